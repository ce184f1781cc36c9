"""A point of the face that is pulled to a place: which weights bring it there (Choe 2001, the second way to set keys).

min over w of |P (p + D w - target)|^2 + r |S (w - w0)|^2 within the limits of the units: D are the fields at the point,
w0 the weights it had, and r small, so that the point follows the hand and all else stays as it was as far as it can.

P leaves out the line of sight, along which a hand on a screen says nothing.  S is diagonal and holds for every field
how much farther it moves the face elsewhere than here: a lip corner is pulled up by the unit that is for lip corners,
and not by a little of everything that moves it too.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import numpy as np
from scipy.optimize import lsq_linear

from facemodel.actions import ActionUnit, Expression
from facemodel.basis import Basis
from fem.types import FloatArray

LAZINESS = 0.5
"""Square millimetres for a full change of a unit whose largest motion is here: one of 7 mm brings it 99 %."""

FARTHEST = 20.0
"""How much farther a unit may move the face elsewhere and still count as more than this."""

FULL = 1.0
"""A hand brings no unit beyond its full strength that was not there before."""

LEAST = 0.5
"""Millimetres that a field has to move the point at weight 1 to have a say; others would be driven to their ends."""

KEPT = 1e-4
"""A weight below this is none."""


def pulled(
    basis: Basis,
    point: int,
    target: FloatArray,
    weights: Expression,
    units: Sequence[ActionUnit],
    among: Collection[str] | None = None,
    sight: FloatArray | None = None,
) -> dict[str, float]:
    """The weights of the fields that move, and those that did, so that a point comes as near to a place as it can.

    Parameters
    ----------
    basis : the displacement fields
    point : of the drawn skin
    target : (3,) where it is to be, millimetres
    weights : where the sliders stand
    units : of the face
    among : fields that may move; all if not given
    sight : (3,) unit vector along which it does not matter where the point is
    """
    limits: Mapping[str, float] = {name: unit.limit for unit in units for name in unit.fields}
    names = [name for name in basis.names if name in limits and (among is None or name in among)]
    if point >= basis.display.moving or not names:
        return dict(weights)
    moved = np.stack([basis.moving_field(name)[point] for name in names]).astype(np.float64)
    felt = np.linalg.norm(moved, axis=1) >= LEAST
    names, moved = [name for name, has in zip(names, felt.tolist(), strict=True) if has], moved[felt]
    if not names:
        return dict(weights)
    before = np.array([weights.get(name, 0.0) for name in names])
    rest = basis.display.points[point].astype(np.float64) + _others(basis, point, weights, names)
    across = np.eye(3) if sight is None else np.eye(3) - np.outer(sight, sight)
    peaks = np.array([basis.peak(name) for name in names])
    lazy = np.sqrt(LAZINESS) * peaks / np.maximum(np.linalg.norm(moved, axis=1), peaks / FARTHEST)
    system = np.vstack([across @ moved.T, np.diag(lazy)])
    wanted = np.concatenate([across @ (np.asarray(target, dtype=np.float64) - rest), lazy * before])
    high = np.array([min(limits[name], max(FULL, weights.get(name, 0.0))) for name in names])
    found = lsq_linear(system, wanted, (np.zeros(len(names)), high), method="bvls").x
    made = {**weights, **dict(zip(names, found.tolist(), strict=True))}
    return {name: weight for name, weight in made.items() if abs(weight) > KEPT or name in weights}


def _others(basis: Basis, point: int, weights: Expression, names: Collection[str]) -> FloatArray:
    """How far the fields that stay as they are have moved the point (3,)."""
    total = np.zeros(3)
    for name, weight in weights.items():
        if name in basis.index and name not in names:
            total += weight * basis.moving_field(name)[point]
    return total
