"""Lids lie on the eyeball: a linear sum of fields takes the chord, the eyeball is round (design section 6)."""

from __future__ import annotations

import numpy as np

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

    def _sphere(self, rest: Float32Array, centre: FloatArray, radius: float) -> tuple[FloatArray, Float32Array]:
        """Centre of a sphere and the least distance (m,) from it of the points near it."""
        away = np.linalg.norm(rest[self._near] - centre, axis=1)
        return centre, np.minimum(away, radius + CLEARANCE).astype(np.float32)

    def move(self, here: Float32Array, stance: Stance) -> None:
        """Push what lies too deep out of the eyeball as it is turned, in place."""
        turn = stance.eyes[self._number]
        lids = here[self._near]
        for centre, least in self._spheres:
            middle = (turn[:3, :3] @ centre + turn[:3, 3]).astype(np.float32)
            offset = lids - middle
            distance = np.sqrt(np.einsum("ij,ij->i", offset, offset))
            deep = np.flatnonzero(distance < least * (1 - ROUNDING))
            lids[deep] = middle + offset[deep] * (least[deep] / distance[deep])[:, None]
        here[self._near] = lids


ROUNDING = np.float32(1e-5)
"""Shares of a distance that are rounding."""


def near_eyeball(eye: Eye, rest: Float32Array | FloatArray) -> BoolArray:
    """Which points (n,) at rest belong to the lids of an eye."""
    offset = rest - eye.centre
    near = np.linalg.norm(offset, axis=1) < eye.radius + LID_REACH
    return np.asarray(near & (offset[:, 2] > FRONT * eye.radius))
