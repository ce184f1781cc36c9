"""Steps that change the weights of an expression."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from app.commands.command import ITEM_BYTES, Command
from app.weights import with_weights
from facemodel.actions import ActionUnit, Expression
from facemodel.project import Project

Delta = Mapping[str, float | None]
"""New weights of a few fields; none for a field that the expression does not name."""


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
        return ITEM_BYTES * len(self.after)

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return self.before != self.after

    def do(self, project: Project) -> Project:
        """The project with the new weights."""
        return project.posed(reweighted(project.expression, self.after))

    def undo(self, project: Project) -> Project:
        """The project with the old weights."""
        return project.posed(reweighted(project.expression, self.before))

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


def set_weights(project: Project, weights: Expression, label: str = "", gesture: str = "") -> SetWeights:
    """The step from the project's expression to one with some weights (by field, checked) replaced."""
    old, new = project.expression, with_weights(project.expression, weights)
    moved = [name for name in weights if old.get(name, 0.0) != new.get(name, 0.0)]
    before = {name: old.get(name) for name in moved}
    after = {name: new.get(name) for name in moved}
    return SetWeights(label or _named(moved, project.units), before, after, gesture)


def reweighted(expression: Expression, delta: Delta) -> dict[str, float]:
    """An expression with a few weights replaced, and those taken out that are none, by name in order.

    The order makes two expressions that are the same the same in a file too.
    """
    merged = {**expression, **delta}
    return {name: weight for name, weight in sorted(merged.items()) if weight is not None}


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
