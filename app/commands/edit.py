"""The step from one state of a project to another, whatever it is that differs."""

from __future__ import annotations

from app.commands.command import Command
from app.commands.content import edit_content
from app.commands.painting import paint_layers
from app.commands.whole import ReplaceProject, Several
from app.differences import changes
from facemodel.project import Project


def edit(before: Project, after: Project, label: str, gesture: str = "") -> Command:
    """The smallest step between two states of a project, as pure functions on projects give them."""
    found = changes(before, after)
    if found.whole or found.skull:
        return ReplaceProject(label, before, after)
    content = edit_content(before, after, label, gesture)
    if not found.layers:
        return content
    painted = paint_layers(before.face, after.face, label, gesture)
    return Several(label, (content, painted)) if content.changes else painted
