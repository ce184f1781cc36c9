"""Which vertices of the skull form the jaw: chosen on the bone as a whole, and what follows when others are.

Koch et al. 1998 (section 4.4) select the vertices of the jaw on the skull by hand, and turn them about an axis.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from scipy.spatial import KDTree

from facemodel.errors import SkullError
from facemodel.face import Face, Skull
from facemodel.laying.places import middle_plane, nearest
from facemodel.mesh import Mesh, submesh
from facemodel.painting.mirror import NOBODY
from facemodel.painting.regions import connected_part, flood
from facemodel.skull.spring_checks import whole_bone
from fem.types import BoolArray, FloatArray, IntArray

PAIRED = 4.0
"""Millimetres between the mirror image of a vertex and its partner; the vertices of the shipped skulls lie 3 apart."""

SOFTENED = 6
"""Rounds of averaging over neighbours by which skin passes from bone that stays to bone that is now jaw."""


@dataclass(frozen=True, eq=False)
class WholeSkull:
    """Both bones as one mesh, as they were before a jaw was cut out.

    Attributes
    ----------
    mesh : M vertices; those along a cut are there once
    jaw : (M,) vertices of the mandible
    shared : (M,) vertices that lie on the cut, which belong to both bones
    corners : of the cranium's vertices and then the mandible's, the vertex of the mesh each one is
    """

    mesh: Mesh
    jaw: BoolArray
    shared: BoolArray
    corners: IntArray

    def partners(self, face: Face) -> IntArray:
        """For every vertex the one across the middle of the face (M,), or -1 where the bone has no such side."""
        middle, across = middle_plane(face)
        mirrored = self.mesh.positions - 2 * np.outer((self.mesh.positions - middle) @ across, across)
        away, other = KDTree(self.mesh.positions).query(mirrored, distance_upper_bound=PAIRED)
        return np.where(np.isfinite(away), other, NOBODY).astype(np.int64)


def whole_skull(skull: Skull) -> WholeSkull:
    """Both bones of a skull as one, with what of it is jaw; remembered."""
    return _whole(skull.cranium, skull.mandible)


@lru_cache(maxsize=4)
def _whole(cranium: Mesh, mandible: Mesh) -> WholeSkull:
    both = whole_bone(cranium, mandible)
    _, first, same = np.unique(both.positions, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")
    number = np.empty(len(order), dtype=np.int64)
    number[order] = np.arange(len(order))
    corners = number[np.reshape(same, -1)]
    triangles = corners[both.triangles]
    used = np.zeros((2, len(order)), dtype=np.bool_)
    used[0, triangles[: len(cranium.triangles)]] = True
    used[1, triangles[len(cranium.triangles) :]] = True
    mesh = Mesh(both.positions[first[order]], triangles)
    return WholeSkull(mesh, used[1], used[0] & used[1], corners)


def mirrored(whole: WholeSkull, face: Face, region: BoolArray) -> BoolArray:
    """A region (M,) with its image across the middle of the face."""
    partners = whole.partners(face)
    paired = partners != NOBODY
    image = np.zeros_like(region)
    image[paired] = region[partners[paired]]
    return region | image


def part_around(mesh: Mesh, seed: int, lower: bool = False) -> BoolArray:
    """What is connected with a vertex (M,), or of that only what lies no higher than it and is connected there."""
    if not lower:
        return connected_part(mesh, seed)
    height = mesh.positions[:, 1]
    return flood(mesh, np.maximum(height - height[seed], 0.0), seed, 0.0)


def with_jaw(face: Face, region: BoolArray) -> Face:
    """A face whose jaw is a region (M,) of its skull's vertices, numbered as by `whole_skull`.

    A triangle belongs to the jaw if all its corners do.  The skin over bone that has changed hands follows it, and
    passes softly to what is around; all other skin keeps its share of the mandible to the last bit.

    Raises
    ------
    SkullError
        If no bone would be jaw, or all of it.
    """
    whole = whole_skull(face.skull)
    mine = np.asarray(region[whole.mesh.triangles].all(axis=1))
    if not mine.any():
        raise SkullError("No bone would be jaw; choose a part of the skull that encloses at least one triangle.")
    if mine.all():
        raise SkullError("All of the skull would be jaw and nothing would hold the face; leave some bone out of it.")
    if np.array_equal(mine, whole.jaw[whole.mesh.triangles].all(axis=1)):
        return face
    bones = replace(face.skull, cranium=submesh(whole.mesh, ~mine)[0], mandible=submesh(whole.mesh, mine)[0])
    changed = _jaw_below(bones).astype(np.float64) - _jaw_below(face.skull)
    share = _following(face.skin, face.skull.jawbone, changed)
    return replace(face, skull=replace(bones, jawbone=share))


def _jaw_below(skull: Skull) -> BoolArray:
    """Skin vertices (N,) whose foot lies nearer to the mandible than to the cranium."""
    away = [_distance(mesh, skull.anchors) for mesh in (skull.cranium, skull.mandible)]
    return np.asarray(away[1] < away[0])


def _distance(mesh: Mesh, points: FloatArray) -> FloatArray:
    return nearest(mesh, points)[2] if len(mesh.triangles) else np.full(len(points), np.inf)


def _following(skin: Mesh, share: FloatArray, changed: FloatArray) -> FloatArray:
    """Shares (N,) after the bone below some vertices became jaw (1) or ceased to be (-1)."""
    if not changed.any():
        return share
    degree = np.maximum(np.asarray(skin.adjacency.sum(axis=1)).ravel(), 1.0)
    soft = np.column_stack([np.maximum(changed, 0.0), np.maximum(-changed, 0.0)])
    for _ in range(SOFTENED):
        soft = (soft + (skin.adjacency @ soft) / degree[:, None]) / 2
    taken, left = np.maximum(soft, np.column_stack([changed > 0, changed < 0])).T
    return np.asarray((share + taken * (1 - share)) * (1 - left))
