"""Smooth the skin in the corners of a mouth where the targets of the base mesh crumple it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.sparse import diags_array

from facemodel.mesh import Mesh
from fem.types import BoolArray

REACH = 8.0
"""Millimetres about each corner within which skin is looked at."""

THIN = 0.1
"""Millimetres: a triangle that is not so high is crumpled, since targets are rounded to as much."""

TURNED = 0.5
"""Cosine between a triangle and the smooth normals in its corners below which it is crumpled: 60 degrees; where skin
turns about the edge of a lip, a fine mesh stays above 0.6."""

STEP = 0.5
"""Share of the way to the middle of its neighbours that a vertex goes in one round."""

ROUNDS = 40
"""How often vertices move at most; four rounds are enough on the faces that ship."""


def with_smooth_corners(skin: Mesh, landmarks: Mapping[str, int]) -> Mesh:
    """Skin without a triangle that is crumpled beside a corner of the mouth.

    Vertices of crumpled triangles and their neighbours go to the middle of their own neighbours until none is left, and
    no others do.  The edges of the lips and the corners themselves stay, so that the mouth keeps its outline.
    """
    corners = skin.positions[[landmarks["mouth_corner_L"], landmarks["mouth_corner_R"]]]
    free = np.linalg.norm(skin.positions[:, None] - corners, axis=2).min(axis=1) < REACH
    free[np.concatenate(skin.boundary_loops)] = False
    adjacency = skin.adjacency
    mean = diags_array(1 / np.asarray(adjacency.sum(axis=1)).ravel()) @ adjacency
    for _ in range(ROUNDS):
        touched = np.zeros(len(skin.positions))
        touched[skin.triangles[crumpled(skin) & free[skin.triangles].any(axis=1)]] = 1
        moving = free & (touched + adjacency @ touched > 0)
        if not moving.any():
            break
        way = STEP * (mean @ skin.positions - skin.positions)
        skin = skin.moved(np.where(moving[:, None], skin.positions + way, skin.positions))
    return skin


def crumpled(skin: Mesh) -> BoolArray:
    """Which triangles (T,) are turned out of the smooth surface, or next to none."""
    a, b, c = (skin.positions[skin.triangles[:, k]] for k in range(3))
    longest = np.max([np.linalg.norm(side, axis=1) for side in (b - a, c - b, a - c)], axis=0)
    normal = skin.triangle_normals
    twice = np.linalg.norm(normal, axis=1)
    smooth = skin.normals[skin.triangles].mean(axis=1)
    along = np.einsum("ij,ij->i", normal, smooth)
    turned = along < TURNED * twice * np.linalg.norm(smooth, axis=1)
    return np.asarray(turned | (twice < THIN * longest))
