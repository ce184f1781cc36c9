"""Let lids glide on the eyeball: a linear sum of fields takes the chord, the eyeball is round (design section 6)."""

from __future__ import annotations

import numpy as np

from facemodel.eyeball import cornea_cap
from facemodel.face import Eye
from fem.types import Float32Array, IntArray

LID_REACH = 5.0
"""Millimetres from the eyeball within which a point at rest belongs to the lids."""

FRONT = 0.4
"""Share of the radius in front of the eyeball's centre from which on it can be covered by lids."""

CLEARANCE = 0.35
"""Millimetres between the eyeball and the drawn skin of a lid that lies on it."""

FULL_TURN = 0.6
"""Millimetres of push from which on the normal is that of the eyeball and no longer that of the sum."""


class LidGlide:
    """Pushes points that a pose has put into an eyeball out along its radius.

    At rest nothing moves: a point that rests deeper than the clearance keeps its own depth.

    Parameters
    ----------
    eyes : the eyeballs, looking ahead
    rest : (n, 3) float32, points at rest
    """

    def __init__(self, eyes: tuple[Eye, ...], rest: Float32Array) -> None:
        balls = [(eye.centre, eye.radius) for eye in eyes] + [cornea_cap(eye) for eye in eyes]
        near = np.zeros(len(rest), dtype=np.bool_)
        for eye in eyes:
            offset = rest - eye.centre
            near |= (np.linalg.norm(offset, axis=1) < eye.radius + LID_REACH) & (offset[:, 2] > FRONT * eye.radius)
        self.points: IntArray = np.flatnonzero(near)
        lids = rest[self.points]
        self._balls: list[tuple[IntArray, Float32Array, Float32Array]] = []
        for centre, radius in balls:
            middle = centre.astype(np.float32)
            distance = np.linalg.norm(lids - middle, axis=1)
            which = np.flatnonzero(distance < radius + LID_REACH)
            least = np.minimum(distance[which], np.float32(radius + CLEARANCE)).astype(np.float32)
            self._balls.append((which, middle, least))

    def push(self, points: Float32Array, normals: Float32Array) -> None:
        """Move the points (n, 3) of the lids that lie too deep, in place, and turn their normals with them.

        Parameters
        ----------
        points, normals : only those of `points`, in that order; a normal of zero becomes that of the eyeball
        """
        for which, centre, least in self._balls:
            offset = points[which] - centre
            distance = np.sqrt(np.einsum("ij,ij->i", offset, offset))
            deep = np.flatnonzero(distance < least * (1 - 1e-5))
            if len(deep) == 0:
                continue
            outward = offset[deep] / distance[deep, None]
            target = which[deep]
            points[target] = centre + outward * least[deep, None]
            share = np.minimum((least[deep] - distance[deep]) / FULL_TURN, 1.0)[:, None]
            turned = normals[target] * (1 - share) + outward * share
            normals[target] = turned / np.linalg.norm(turned, axis=1, keepdims=True)
