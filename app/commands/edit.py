"""The step from one state of a project to another, whatever it is that differs."""

from __future__ import annotations

from app.commands.animation import edit_animation
from app.commands.command import Command
from app.commands.content import edit_content
from app.commands.corrections import set_corrections
from app.commands.painting import paint_layers
from app.commands.skull import set_skull
from app.commands.whole import ReplaceProject, Several
from app.differences import changes
from facemodel.project import Project


def edit(before: Project, after: Project, label: str, gesture: str = "") -> Command:
    """The smallest step between two states of a project, as pure functions on projects give them."""
    if changes(before, after).whole:
        return ReplaceProject(label, before, after)
    steps: tuple[Command, ...] = (
        edit_content(before, after, label, gesture),
        paint_layers(before.face, after.face, label, gesture),
        set_skull(before.face.skull, after.face.skull, label, gesture),
        set_corrections(before.corrections, after.corrections, label, gesture),
        edit_animation(before.animation, after.animation, label, gesture),
    )
    needed = tuple(step for step in steps if step.changes)
    return needed[0] if len(needed) == 1 else Several(label, needed, gesture)
