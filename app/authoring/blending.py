"""Blend between chosen expressions on a pad: each has a place, and the nearer the pointer is the more of it is seen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from facemodel.actions import Expression, Place

CLOSE = 1e-9
"""Distance on the pad within which the pointer is on an expression and shows it alone."""


def shares(places: Sequence[Place], pointer: Place) -> list[float]:
    """How much of each expression is seen at a place of the pad; they sum to one.

    Weights fall with the square of the distance (Shepard 1968): on an expression it is seen alone, and between two of
    them in equal parts where they are equally far.
    """
    away = [float(np.hypot(x - pointer[0], y - pointer[1])) for x, y in places]
    nearest = min(away, default=1.0)
    if nearest < CLOSE:
        alone = [float(each < CLOSE) for each in away]
        return [each / sum(alone) for each in alone]
    weights = [(nearest / each) ** 2 for each in away]
    return [weight / sum(weights) for weight in weights]


def blended(parts: Mapping[str, tuple[Place, Expression]], pointer: Place) -> dict[str, float]:
    """The expression (by field) at a place of a pad on which expressions (by field) lie at places of their own."""
    weighed = shares([place for place, _ in parts.values()], pointer)
    total: dict[str, float] = {}
    for share, (_, expression) in zip(weighed, parts.values(), strict=True):
        for field, weight in expression.items():
            total[field] = total.get(field, 0.0) + share * weight
    return {field: weight for field, weight in total.items() if weight}
