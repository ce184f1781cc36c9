"""Steps that put other bones, or another hinge of the jaw, under the skin."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from app.commands.command import Command, array_bytes
from facemodel.face import Jaw, Placement, Skull
from facemodel.mesh import Mesh
from facemodel.project import Project
from facemodel.sameness import same


@dataclass(frozen=True, eq=False)
class Bones:
    """The parts of a skull that are no layer of the skin; those that a step leaves alone are none."""

    cranium: Mesh | None = None
    mandible: Mesh | None = None
    jaw: Jaw | None = None
    placement: Placement | None = None

    @property
    def members(self) -> dict[str, Any]:
        """Those that there are, by name."""
        return {name: value for name, value in vars(self).items() if value is not None}


@dataclass(frozen=True, eq=False)
class SetSkull:
    """Replace bones, or the hinge of the jaw.

    Attributes
    ----------
    label : what a person calls it
    before, after : the parts that are different
    gesture : steps with the same gesture in a row are one step; empty for a step of its own
    """

    label: str
    before: Bones
    after: Bones
    gesture: str = ""

    @property
    def cost(self) -> int:
        """Bytes that only this command keeps alive."""
        return array_bytes(self.before)

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return bool(self.after.members)

    def do(self, project: Project) -> Project:
        """The project with the new bones."""
        return _with(project, self.after)

    def undo(self, project: Project) -> Project:
        """The project with the old bones."""
        return _with(project, self.before)

    def joined(self, later: Command) -> Command | None:
        """Both as one step if they belong to one gesture."""
        if not isinstance(later, SetSkull) or not self.gesture or later.gesture != self.gesture:
            return None
        before = {**later.before.members, **self.before.members}
        after = {**self.after.members, **later.after.members}
        moved = [name for name in after if not same(before[name], after[name])]
        return SetSkull(
            later.label,
            Bones(**{name: before[name] for name in moved}),
            Bones(**{name: after[name] for name in moved}),
            self.gesture,
        )


def set_skull(before: Skull, after: Skull, label: str, gesture: str = "") -> SetSkull:
    """The step from one skull to another, but for the arrays with a row per skin vertex."""
    moved = [name for name in vars(Bones()) if not same(getattr(before, name), getattr(after, name))]
    old, new = (Bones(**{name: getattr(skull, name) for name in moved}) for skull in (before, after))
    return SetSkull(label, old, new, gesture)


def _with(project: Project, bones: Bones) -> Project:
    return replace(project, face=replace(project.face, skull=replace(project.face.skull, **bones.members)))
