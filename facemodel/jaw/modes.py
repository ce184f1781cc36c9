"""The twelve affine motions of the mandible that every rigid motion of it is a sum of.

The tissue is linear in how far its anchors on the bone move, and a rigid motion moves the point r of the bone by
(R - 1) r + t.  Written in the frame of the hinge, a turn by the angle a about its axis is
sin(a) K r + (1 - cos(a)) K^2 r with the cross product K of the axis: two of twelve modes, each of which is solved once
for all angles.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.actions import JawMotion
from facemodel.face import Jaw
from facemodel.jaw.motion import hinge_frame, jaw_motion
from fem.types import FloatArray


@dataclass(frozen=True, order=True)
class JawMode:
    """One of the affine motions, by its number in `MODES`."""

    number: int


def _modes() -> FloatArray:
    """Matrices and shifts (12, 3, 4) in the frame of the hinge, orthogonal to each other."""
    made = np.zeros((12, 3, 4))
    made[0, 2, 1], made[0, 1, 2] = 1.0, -1.0
    made[1, 1, 1] = made[1, 2, 2] = -1.0
    made[2, 1, 3] = made[3, 2, 3] = 1.0
    made[4, 0, 3] = 1.0
    made[5, 0, 0] = 1.0
    for number, (row, column) in enumerate(((0, 1), (1, 0), (0, 2), (2, 0)), start=6):
        made[number, row, column] = 1.0
    made[10, 1, 1], made[10, 2, 2] = 1.0, -1.0
    made[11, 1, 2] = made[11, 2, 1] = 1.0
    return made


MODES: FloatArray = _modes()
"""K and K^2 of a turn about the hinge, a shift up, one forward, and what only a jaw that swings sideways needs."""

SHARES: FloatArray = MODES.reshape(12, 12) / (MODES**2).sum(axis=(1, 2))[:, None]
"""How much of each mode an affine motion is made of, as a product with its twelve numbers."""

OPENING = 4
"""As many modes, the first ones, make up all opening and sliding."""

NEGLIGIBLE = 1e-12
"""Shares of a mode below this are rounding."""


def motion_of(jaw: Jaw, motion: JawMotion) -> FloatArray:
    """The rigid motion (4, 4) of the mandible that a motion of the jaw means."""
    return jaw_motion(jaw, motion.degrees, motion.slide, motion.side)


def mode_shares(jaw: Jaw, motion: FloatArray) -> FloatArray:
    """How much (12,) of every mode a rigid motion (4, 4) of the mandible is made of."""
    middle, frame = hinge_frame(jaw)
    moved = motion[:3] - np.eye(4)[:3]
    affine = np.empty((3, 4))
    affine[:, :3] = frame @ moved[:, :3] @ frame.T
    affine[:, 3] = frame @ (moved[:, :3] @ middle + moved[:, 3])
    shares = SHARES @ affine.ravel()
    return np.where(np.abs(shares) < NEGLIGIBLE, 0.0, shares)


def mode_motion(jaw: Jaw, mode: JawMode, places: FloatArray) -> FloatArray:
    """How far (n, 3) one whole share of a mode moves places (n, 3) of the bone, millimetres."""
    middle, frame = hinge_frame(jaw)
    there = (places - middle) @ frame.T
    moved = there @ MODES[mode.number, :, :3].T + MODES[mode.number, :, 3]
    return np.asarray(moved @ frame)


def modes_for(motions: Sequence[JawMotion]) -> tuple[JawMode, ...]:
    """The modes that any sum of some motions of a jaw is made of, whatever their weights."""
    if not motions:
        return ()
    count = len(MODES) if any(motion.side for motion in motions) else OPENING
    return tuple(JawMode(number) for number in range(count))
