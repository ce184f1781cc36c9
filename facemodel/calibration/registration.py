"""Lay the skin of one of our heads on a measured face: landmarks first, then the nearest skin.

Rounds of the nearest compatible point draw a smooth map of space from the head's skin to the measured one, in the
manner of iterative closest points; the landmarks hold throughout.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.interpolate import RBFInterpolator

from facemodel.calibration.points68 import ROUGH, SCATTER
from facemodel.face import Face
from facemodel.laying.places import nearest
from facemodel.laying.warp import Warp
from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray, IntArray

REACHES = (25.0, 18.0, 13.0, 10.0, 8.0, 8.0, 8.0)
"""Millimetres within which skin is taken for the same in each round: wide first, so that cheeks of another width are
found, then narrow, so that nothing is drawn across a fold."""

AGREEMENT = 0.6
"""Least cosine between the normals of skin that is taken for the same."""

SPACING = 7.0
"""Millimetres between the places of the head that are drawn: finer than any difference between two heads."""

GIVE = 3.0
"""Smoothing of the map at drawn places, in the unit of its kernel: as much as the nearest point may mislead."""


def rigid_pose(places: FloatArray, goals: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Rotation (3, 3) and shift (3,), for row vectors ``x @ turn + shift``, that bring places (n, 3) onto goals.

    Both may differ in size, which is left as it is.
    """
    middle, goal = places.mean(axis=0), goals.mean(axis=0)
    u, _, v = np.linalg.svd((places - middle).T @ (goals - goal))
    mirror = np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ v))])
    turn = u @ mirror @ v
    return turn, goal - middle @ turn


def spread_out(positions: FloatArray, among: IntArray, spacing: float) -> IntArray:
    """Vertices among some that lie a spacing apart, chosen in their order."""
    chosen: list[int] = []
    for vertex in among:
        if not chosen or np.linalg.norm(positions[chosen] - positions[vertex], axis=1).min() > spacing:
            chosen.append(int(vertex))
    return np.array(chosen, dtype=np.int64)


def registered(head: Face, mesh: Mesh, places: Mapping[str, FloatArray]) -> Warp:
    """The map of space that lays the skin of a head on a measured one.

    Parameters
    ----------
    head : whose skin is laid
    mesh : the measured skin, in the axes of a head
    places : (3,) of landmarks on it, by the names of the head's
    """
    names = list(places)
    start = head.skin.positions[[head.landmarks[name] for name in names]]
    goal = np.array([places[name] for name in names])
    give = np.array([SCATTER if name in ROUGH else 0.0 for name in names])
    moving = spread_out(head.skin.positions, np.unique(head.skin.triangles[head.solved]), SPACING)
    border = np.concatenate([np.zeros(0, dtype=np.int64), *mesh.boundary_loops])
    warp = _warp(start, goal, give)
    for reach in REACHES:
        laid = head.skin.moved(warp(head.skin.positions))
        found, drawn = _same_skin(laid, moving, mesh, border, reach)
        warp = _warp(
            np.concatenate([start, head.skin.positions[moving[drawn]]]),
            np.concatenate([goal, found[drawn]]),
            np.concatenate([give, np.full(int(drawn.sum()), GIVE)]),
        )
    return warp


def _same_skin(
    laid: Mesh, moving: IntArray, mesh: Mesh, border: IntArray, reach: float
) -> tuple[FloatArray, BoolArray]:
    """The nearest places (m, 3) of the measured skin, and which of them (m,) are believed."""
    found, triangle, away = nearest(mesh, laid.positions[moving])
    corners = mesh.triangles[triangle]
    normals = mesh.triangle_normals[triangle]
    normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    agree = np.einsum("ij,ij->i", normals, laid.normals[moving])
    return found, (away < reach) & (agree > AGREEMENT) & ~np.isin(corners, border).any(axis=1)


def _warp(start: FloatArray, goal: FloatArray, give: FloatArray) -> Warp:
    # The linear kernel of scipy is -r, whose smoothing adds to a diagonal of the same sign.
    return Warp(RBFInterpolator(start, goal, kernel="linear", degree=1, smoothing=give))
