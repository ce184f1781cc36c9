"""Springs on a bone that came from elsewhere: each keeps its direction and ends as much deeper as the bone lies."""

from __future__ import annotations

import igl
import numpy as np

from facemodel.mesh import Mesh
from fem.types import FloatArray

ROUNDS = 3
"""Averagings over neighbours: a foot of bone is wider than the distance between two springs."""


def feet_on(skin: Mesh, feet: FloatArray, before: Mesh, bone: Mesh) -> FloatArray:
    """Where the springs of a skin end (N, 3) on another bone.

    Under every vertex it is measured how much deeper the new bone lies than the old one, and its spring is so much
    longer or shorter.  Feet may lie somewhat behind the bone, on the smooth surface that it is modelled under, and in
    the air of orbits and mouth; they stay so with regard to the new bone.

    Parameters
    ----------
    skin : of N vertices
    feet : (N, 3) where the springs end on the old bone
    before, bone : the old bone and the new one, in the same place
    """
    reach = feet - skin.positions
    length = np.linalg.norm(reach, axis=1, keepdims=True)
    along = np.where(length > 0, reach / np.maximum(length, np.finfo(float).tiny), -skin.normals)
    deeper = _depth(bone, skin.positions) - _depth(before, skin.positions)
    degree = np.maximum(np.asarray(skin.adjacency.sum(axis=1)).ravel(), 1.0)
    for _ in range(ROUNDS):
        deeper = (deeper + (skin.adjacency @ deeper) / degree) / 2
    return np.asarray(feet + deeper[:, None] * along)


def _depth(bone: Mesh, points: FloatArray) -> FloatArray:
    """Millimetres (n,) from points to the nearest bone, below zero within it."""
    kind = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    return np.reshape(igl.signed_distance(points, bone.positions, bone.triangles, kind)[0], -1)
