"""Steps that change what is sculpted on top of solved fields."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from app.commands.command import ITEM_BYTES, Command, array_bytes
from facemodel.project import Project
from facemodel.sculpting.correction import Correction, Corrections

Layers = Mapping[str, Correction | None]
"""By field name; none for a field that has no correction."""


@dataclass(frozen=True, eq=False)
class SetCorrections:
    """Give some fields other corrections.

    Attributes
    ----------
    label : what a person calls it
    before, after : those that are different alone
    gesture : steps with the same gesture in a row are one step; empty for a step of its own
    """

    label: str
    before: Layers
    after: Layers
    gesture: str = ""

    @property
    def cost(self) -> int:
        """Bytes that only this command keeps alive."""
        return ITEM_BYTES * len(self.after) + array_bytes(self.before) + array_bytes(self.after)

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return bool(self.after)

    def do(self, project: Project) -> Project:
        """The project with the new corrections."""
        return _with(project, self.after)

    def undo(self, project: Project) -> Project:
        """The project with the old corrections."""
        return _with(project, self.before)

    def joined(self, later: Command) -> Command | None:
        """Both as one step if they belong to one gesture."""
        if not isinstance(later, SetCorrections) or not self.gesture or later.gesture != self.gesture:
            return None
        before, after = {**later.before, **self.before}, {**self.after, **later.after}
        moved = [name for name in after if before[name] is not after[name]]
        return SetCorrections(
            later.label,
            {name: before[name] for name in moved},
            {name: after[name] for name in moved},
            self.gesture,
        )


def set_corrections(before: Corrections, after: Corrections, label: str, gesture: str = "") -> SetCorrections:
    """The step from some corrections to others; those that are the same objects are the same."""
    moved = [name for name in {**before, **after} if before.get(name) is not after.get(name)]
    old, new = ({name: each.get(name) for name in moved} for each in (before, after))
    return SetCorrections(label, old, new, gesture)


def _with(project: Project, layers: Layers) -> Project:
    """By name in order, so that two projects that are the same are the same in a file too."""
    merged = {**project.corrections, **layers}
    return replace(project, corrections={name: each for name, each in sorted(merged.items()) if each is not None})
