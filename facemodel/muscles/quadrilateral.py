"""The quadrilateral sheet of Choe, Lee and Ko 2001, eq. 1: an edge on the bone pulls what lies about one on the skin.

Their corners are p1, p2 (origin) and p3, p4 (insertion); here they are the ends of the outer central fibres.
"""

from __future__ import annotations

import numpy as np

from facemodel.mesh import Mesh
from facemodel.muscles.curve import SHORTEST
from facemodel.muscles.muscle import Muscle
from fem.types import FloatArray


def quadrilateral_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Force per area (N, 3) on the skin, N/mm^2, of a parallel muscle.

    f_ij = a_i f_i (1 - r_ij / r_i) d_ij (eq. 1) within the radius r_i of the insertion and nothing beyond,
    where r_ij is the distance to the nearest point of the insertion and d_ij the unit vector to the nearest
    point of the origin.  r_i is the muscle's width and f_i its strength.

    Two central fibres are the paper's quadrilateral.  With more of them both edges are lines that bend at
    their ends; with one the edges are points.  The intermediate points of bent fibres play no part.
    """
    x = skin.positions
    insertion = nearest_on_line(x, np.array([fibre.attachment for fibre in muscle.fibres]))
    origin = nearest_on_line(x, np.array([fibre.origin for fibre in muscle.fibres]))
    share = np.maximum(1 - np.linalg.norm(x - insertion, axis=1) / muscle.width, 0.0)
    pull = origin - x
    distance = np.linalg.norm(pull, axis=1)
    share[distance < SHORTEST] = 0.0
    return np.asarray(muscle.strength * (share / np.maximum(distance, SHORTEST))[:, None] * pull)


def nearest_on_line(places: FloatArray, corners: FloatArray) -> FloatArray:
    """The points (n, 3) nearest to places (n, 3) on an open line through corners (k, 3)."""
    if len(corners) == 1:
        return np.broadcast_to(corners, places.shape)
    start, step = corners[:-1], np.diff(corners, axis=0)
    square = np.maximum(np.einsum("sc,sc->s", step, step), SHORTEST**2)
    share = np.einsum("nsc,sc->ns", places[:, None] - start, step) / square
    foot = start + np.clip(share, 0.0, 1.0)[..., None] * step
    nearest = np.linalg.norm(places[:, None] - foot, axis=2).argmin(axis=1)
    return np.asarray(foot[np.arange(len(places)), nearest])
