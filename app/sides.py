"""Left and right: which fields move together when the sides are linked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from facemodel.actions import ActionUnit


def other_side(field: str, units: Sequence[ActionUnit]) -> str | None:
    """The same field on the other side of the face; none where the unit has no sides."""
    for unit in units:
        if unit.paired and field in unit.fields:
            left, right = unit.fields
            return right if field == left else left
    return None


def both_sides(weights: Mapping[str, float], units: Sequence[ActionUnit], linked: bool) -> dict[str, float]:
    """The weights as they are, or with each side's weight given to the other too when the sides are linked.

    A field that is named itself keeps its own weight; of a unit whose sides undo each other they are never linked.
    """
    if not linked:
        return dict(weights)
    together = [unit for unit in units if not unit.opposed]
    mirrored = {other_side(field, together): weight for field, weight in weights.items()}
    return {**{field: weight for field, weight in mirrored.items() if field is not None}, **weights}
