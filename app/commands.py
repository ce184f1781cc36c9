"""Commands: what is done to a project and undone, as frozen values.

A command holds the difference and nothing else.  ``do`` and ``undo`` are pure: they make another project
of the one they are given.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from app.weights import with_weights
from facemodel.actions import ActionUnit, Expression
from facemodel.project import Project

Delta = Mapping[str, float | None]
"""New weights of a few fields; none for a field that the expression does not name."""

WEIGHT_BYTES = 200
"""About what one weight takes in both mappings of a step; only the order of magnitude counts."""


class Command(Protocol):
    """Something that can be done to a project and undone."""

    @property
    def label(self) -> str:
        """What a person calls it, as in “Undo …”."""

    @property
    def cost(self) -> int:
        """Bytes that only this command keeps alive."""

    @property
    def changes(self) -> bool:
        """Whether it does anything."""

    def do(self, project: Project) -> Project:
        """The project with it done."""

    def undo(self, project: Project) -> Project:
        """The project as it was; takes what `do` gave."""

    def joined(self, later: Command) -> Command | None:
        """Both this and a later command as one step, or none where each is a step of its own."""


@dataclass(frozen=True)
class SetWeights:
    """Change the weights of a few fields.

    Attributes
    ----------
    label : what a person calls it
    before, after : the changed weights alone
    gesture : steps with the same gesture in a row are one step; empty for a step of its own
    """

    label: str
    before: Delta
    after: Delta
    gesture: str = ""

    @property
    def cost(self) -> int:
        """Bytes that only this command keeps alive."""
        return WEIGHT_BYTES * len(self.after)

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return self.before != self.after

    def do(self, project: Project) -> Project:
        """The project with the new weights."""
        return project.posed(_changed(project.expression, self.after))

    def undo(self, project: Project) -> Project:
        """The project with the old weights."""
        return project.posed(_changed(project.expression, self.before))

    def joined(self, later: Command) -> Command | None:
        """Both as one step if they belong to one gesture."""
        if not isinstance(later, SetWeights) or not self.gesture or later.gesture != self.gesture:
            return None
        before, after = {**later.before, **self.before}, {**self.after, **later.after}
        moved = [name for name in after if before[name] != after[name]]
        return SetWeights(
            later.label,
            {name: before[name] for name in moved},
            {name: after[name] for name in moved},
            self.gesture,
        )


@dataclass(frozen=True, eq=False)
class ReplaceProject:
    """Put another project in the place of this one: another face, atlas or basis settings."""

    label: str
    before: Project
    after: Project

    @property
    def cost(self) -> int:
        """Bytes of the arrays of the face that would be freed without this command."""
        return 0 if self.before.face is self.after.face else array_bytes(self.before.face)

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return self.before is not self.after

    def do(self, project: Project) -> Project:
        """The new project."""
        return self.after

    def undo(self, project: Project) -> Project:
        """The old project."""
        return self.before

    def joined(self, later: Command) -> Command | None:
        """Never one step with another."""
        return None


def set_weights(project: Project, weights: Expression, label: str = "", gesture: str = "") -> SetWeights:
    """The step from the project's expression to one with some weights (by field, checked) replaced."""
    old, new = project.expression, with_weights(project.expression, weights)
    moved = [name for name in weights if old.get(name, 0.0) != new.get(name, 0.0)]
    before = {name: old.get(name) for name in moved}
    after = {name: new.get(name) for name in moved}
    return SetWeights(label or _named(moved, project.units), before, after, gesture)


def array_bytes(value: Any) -> int:
    """Bytes of all arrays that a frozen value holds, at any depth."""
    return sum(array.nbytes for array in _arrays(value))


def _arrays(value: Any) -> Iterator[np.ndarray[Any, Any]]:
    if isinstance(value, np.ndarray):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from _arrays(item)
    elif dataclasses.is_dataclass(value):
        for member in dataclasses.fields(value):
            yield from _arrays(getattr(value, member.name))


def _changed(expression: Expression, delta: Delta) -> dict[str, float]:
    merged = {**expression, **delta}
    return {name: weight for name, weight in merged.items() if weight is not None}


def _named(moved: list[str], units: tuple[ActionUnit, ...]) -> str:
    """What to call a change of these fields: the one unit's name, with its side if only one moved."""
    if not moved:
        return "Expression"
    touched = [unit for unit in units if any(name in unit.fields for name in moved)]
    if len(touched) != 1:
        return "Expression"
    unit = touched[0]
    side = f" {moved[0][-1]}" if unit.paired and len(moved) == 1 else ""
    return f"{unit.name[:1].upper()}{unit.name[1:]}{side}"
