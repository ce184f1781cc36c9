"""Weights as they come from a person: checked, resolved to fields, and told apart from those that stand."""

from __future__ import annotations

import math
from collections.abc import Mapping

from app.errors import NumberError
from facemodel.actions import EXAGGERATED, Expression, field_names, find_emotion, resolve
from facemodel.project import Project

LARGEST_WEIGHT = EXAGGERATED
"""As far as any slider goes; a unit may stop earlier at its own limit."""


def checked_weights(weights: Mapping[str, float], project: Project) -> dict[str, float]:
    """Weights by field from weights by any name; a later name overrides an earlier one, and limits of units hold.

    Raises
    ------
    UnknownNameError
        If a name is no action unit of the project.
    NumberError
        If a weight is not a number from 0 to `LARGEST_WEIGHT`.
    """
    known = set(field_names(project.units))
    limits = {field: unit.limit for unit in project.units for field in unit.fields}
    checked: dict[str, float] = {}
    for name, weight in weights.items():
        if not (math.isfinite(weight) and 0 <= weight <= LARGEST_WEIGHT):
            raise NumberError(
                f"The weight {weight:g} of action unit {name} is not possible; "
                f"choose one from 0 (off) over 1 (full) to {LARGEST_WEIGHT:g} (exaggerated)."
            )
        for fld in (name,) if name in known else resolve(name, project.units):
            checked[fld] = min(float(weight), limits.get(fld, LARGEST_WEIGHT))
    return checked


def with_weights(expression: Expression, weights: Expression) -> dict[str, float]:
    """The expression with some weights replaced; a field that comes to weigh zero leaves it."""
    merged = {**expression, **weights}
    return {name: weight for name, weight in merged.items() if weight != 0 or name not in weights}


def whole_expression(expression: Expression, project: Project) -> dict[str, float]:
    """A weight for every field, zero for those not named, so that it replaces any other expression."""
    neutral = dict.fromkeys((*project.expression, *field_names(project.units)), 0.0)
    return {**neutral, **expression}


def emotion_weights(name: str, strength: float, project: Project) -> dict[str, float]:
    """A weight for every field that shows an emotion and nothing else.

    Parameters
    ----------
    name : the emotion
    strength : 1 shows it as it is defined; every weight is multiplied by it, up to `LARGEST_WEIGHT`

    Raises
    ------
    UnknownNameError
        If the project has no such emotion.
    NumberError
        If the strength is not a number from 0 to `LARGEST_WEIGHT`.
    """
    if not (math.isfinite(strength) and 0 <= strength <= LARGEST_WEIGHT):
        raise NumberError(
            f"The strength {strength:g} of {name} is not possible; "
            f"choose one from 0 (neutral) over 1 (full) to {LARGEST_WEIGHT:g} (exaggerated)."
        )
    emotion = find_emotion(name, project.emotions)
    scaled = {unit: min(weight * strength, LARGEST_WEIGHT) for unit, weight in emotion.weights.items()}
    return whole_expression(checked_weights(scaled, project), project)


def in_order(project: Project) -> Project:
    """The project with the weights of its expression by name in order, as all commands leave them."""
    if list(project.expression) == sorted(project.expression):
        return project
    return project.posed(dict(sorted(project.expression.items())))
