"""Lids lie on the eyeball: a linear sum of fields takes the chord, the eyeball is round (design section 6)."""

from __future__ import annotations

import numpy as np

from facemodel.compiled import compiled
from facemodel.eyeball import cornea_cap
from facemodel.face import Eye
from facemodel.kinematics import Stance
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

LID_REACH = 5.0
"""Millimetres from the eyeball within which a point at rest belongs to the lids."""

FRONT = 0.4
"""Share of the radius in front of the eyeball's centre from which on it can be covered by lids."""

CLEARANCE = 0.35
"""Millimetres between the eyeball and the drawn skin of a lid that lies on it."""

ROUNDING = 1e-5
"""Shares of a distance that are rounding."""


class OnEyeball:
    """Pushes points that a pose has put into an eyeball or its cornea out along the radius.

    At rest nothing moves: a point that rests deeper than the clearance keeps its own depth.

    Parameters
    ----------
    eye : looking ahead
    number : of the eye in its face
    rest : (n, 3) points of the site at rest
    """

    def __init__(self, eye: Eye, number: int, rest: Float32Array) -> None:
        self._number = number
        self._near: IntArray = np.flatnonzero(near_eyeball(eye, rest))
        cornea, curvature = cornea_cap(eye)
        self._spheres = [self._sphere(rest, eye.centre, eye.radius), self._sphere(rest, cornea, curvature)]

    def _sphere(self, rest: Float32Array, centre: FloatArray, radius: float) -> tuple[FloatArray, FloatArray]:
        """Centre of a sphere and the least distance (m,) from it of the points near it."""
        away = np.linalg.norm(rest[self._near].astype(np.float64) - centre, axis=1)
        return centre, np.minimum(away, radius + CLEARANCE)

    def move(self, here: Float32Array, stance: Stance) -> None:
        """Push what lies too deep out of the eyeball as it is turned, in place."""
        turn = stance.eyes[self._number]
        for centre, least in self._spheres:
            _push(here, self._near, turn[:3, :3] @ centre + turn[:3, 3], least)


@compiled
def _push(here: Float32Array, near: IntArray, middle: FloatArray, least: FloatArray) -> None:
    """Push points (n, 3) that are nearer to a middle than the least distance (m,) of each out to it, in place."""
    for number, i in enumerate(near):
        x, y, z = here[i, 0] - middle[0], here[i, 1] - middle[1], here[i, 2] - middle[2]
        square = x * x + y * y + z * z
        bound = least[number] * (1 - ROUNDING)
        if square < bound * bound:
            ratio = least[number] / np.sqrt(square)
            here[i, 0], here[i, 1], here[i, 2] = middle[0] + x * ratio, middle[1] + y * ratio, middle[2] + z * ratio


def near_eyeball(eye: Eye, rest: Float32Array | FloatArray) -> BoolArray:
    """Which points (n,) at rest belong to the lids of an eye."""
    offset = rest - eye.centre
    near = np.linalg.norm(offset, axis=1) < eye.radius + LID_REACH
    return np.asarray(near & (offset[:, 2] > FRONT * eye.radius))
