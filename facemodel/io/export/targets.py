"""The shapes that an export offers: every displacement field, and both sides of a paired action unit together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from facemodel.actions import ActionUnit, Expression
from facemodel.basis import Basis
from fem.types import Float32Array


@dataclass(frozen=True)
class Target:
    """One shape.

    Attributes
    ----------
    name : ``12`` for both sides together, ``12L``, ``12R``, or ``17`` for an action unit without sides
    fields : the displacement fields whose sum it is
    """

    name: str
    fields: tuple[str, ...]


def targets(units: Sequence[ActionUnit], basis: Basis) -> tuple[Target, ...]:
    """The shapes of all action units that the basis has, in their order; both sides first, then left and right."""
    found: list[Target] = []
    for unit in units:
        if not all(name in basis.index for name in unit.fields):
            continue
        found.append(Target(str(unit.number), unit.fields))
        if unit.paired:
            found.extend(Target(name, (name,)) for name in unit.fields)
    return tuple(found)


def gaze_targets(units: Sequence[ActionUnit], basis: Basis) -> tuple[Target, ...]:
    """The shapes of the action units that turn the eyes and have no field in the basis."""
    return tuple(
        Target(str(unit.number), unit.fields)
        for unit in units
        if unit.eyes and not any(name in basis.index for name in unit.fields)
    )


def target_field(target: Target, basis: Basis) -> Float32Array:
    """The displacement of the whole drawn skin by a shape, (P, 3) float32, millimetres."""
    total = basis.field(target.fields[0])
    for name in target.fields[1:]:
        total += basis.field(name)
    return total


def target_weights(expression: Expression, shapes: Sequence[Target]) -> list[float]:
    """Weights of the shapes that make an expression; sides of equal weight are one weight for both."""
    weights = []
    for shape in shapes:
        sides = {expression.get(name, 0.0) for name in shape.fields}
        together = len(sides) == 1
        if len(shape.fields) > 1:
            weights.append(sides.pop() if together else 0.0)
        else:
            both = [other for other in shapes if len(other.fields) > 1 and shape.name in other.fields]
            equal = any(len({expression.get(name, 0.0) for name in other.fields}) == 1 for other in both)
            weights.append(0.0 if equal else expression.get(shape.name, 0.0))
    return weights
