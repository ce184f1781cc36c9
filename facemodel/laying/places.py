"""Places on a face: the nearest point of skin or bone, and the same place on the other side."""

from __future__ import annotations

import atexit
from functools import lru_cache
from typing import Literal

import igl
import numpy as np
from scipy.spatial import KDTree

from facemodel.face import Face
from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray, IntArray

Snap = Literal["vertex", "surface", "free"]
"""Where a dragged point comes to lie: on the nearest vertex, on the nearest point of the surface, or where it is."""

Bone = Literal["cranium", "mandible"]

Kind = Literal["vertex", "foot", "skin", "bone", "free"]
"""What a point lies on: a vertex of the skin, the bone under one, the skin or a bone elsewhere, or nothing."""

SNAPPED = 1e-3
"""Millimetres between a point and the vertex that it was snapped to: faces may be stored in single precision."""

OUTSIDE = 0.3
"""Windings of the skin about a point in the air; within the head there is one, on the skin one half."""

ON_SKIN = 2.0
"""Millimetres from the skin within which a point counts as on it."""

FLAT = 1e-9
"""Share of a normal that is rounding: a head built symmetric has its middle plane at x = 0 to the last bit."""


@lru_cache(maxsize=16)
def _tree(mesh: Mesh) -> igl.AABB:
    tree = igl.AABB()
    tree.init(mesh.positions, mesh.triangles)
    return tree


# What igl made goes before the interpreter does, which would call it leaked.
atexit.register(_tree.cache_clear)


def nearest(mesh: Mesh, points: FloatArray) -> tuple[FloatArray, IntArray, FloatArray]:
    """The nearest points of a mesh to points (n, 3), found in a tree that is kept with the mesh.

    Returns
    -------
    places : (n, 3) on the surface
    triangles : (n,) in which they lie
    distances : (n,) millimetres
    """
    asked = np.ascontiguousarray(np.atleast_2d(points), dtype=np.float64)
    square, triangles, places = _tree(mesh).squared_distance(mesh.positions, mesh.triangles, asked)
    return np.reshape(places, (-1, 3)), np.reshape(triangles, -1), np.sqrt(np.reshape(square, -1))


def ahead(mesh: Mesh, points: FloatArray, along: FloatArray) -> FloatArray:
    """Millimetres (n,) from points (n, 3) to a mesh in unit directions (n, 3); infinite where it is not ahead."""
    start = np.ascontiguousarray(points, dtype=np.float64)
    ways = np.ascontiguousarray(np.broadcast_to(along, start.shape), dtype=np.float64)
    met, distance, _ = _tree(mesh).intersect_ray_first(mesh.positions, mesh.triangles, start, ways)
    return np.where(np.reshape(met, -1) < 0, np.inf, np.reshape(distance, -1))


def on_skin(face: Face, point: FloatArray, snap: Snap = "vertex") -> FloatArray:
    """Where on the skin (3,) a point that is dragged to ``point`` (3,) comes to lie."""
    return _snapped(face.skin, point, snap)


def on_bone(face: Face, point: FloatArray, snap: Snap = "surface", bone: Bone | None = None) -> FloatArray:
    """Where on the skull (3,) a point that is dragged to ``point`` (3,) comes to lie; by default the nearer bone."""
    bones = {"cranium": face.skull.cranium, "mandible": face.skull.mandible}
    if snap == "free":
        return np.array(point, dtype=np.float64)
    return _snapped(bones[bone or nearer_bone(face, point)], point, snap)


def nearer_bone(face: Face, point: FloatArray) -> Bone:
    """Which bone lies nearer to a point (3,)."""
    cranium, mandible = (nearest(mesh, point)[2][0] for mesh in (face.skull.cranium, face.skull.mandible))
    return "mandible" if mandible < cranium else "cranium"


def _snapped(mesh: Mesh, point: FloatArray, snap: Snap) -> FloatArray:
    if snap == "free":
        return np.array(point, dtype=np.float64)
    if snap == "vertex":
        return np.array(mesh.positions[mesh.tree.query(point)[1]])
    return np.array(nearest(mesh, point)[0][0])


def outside_head(face: Face, points: FloatArray) -> BoolArray:
    """Which of some points (n, 3) lie in the air around a head; those on its skin do not.

    Told by the generalised winding number, which sees through eyes, mouth and neck where the skin is open.
    """
    asked = np.ascontiguousarray(np.atleast_2d(points), dtype=np.float64)
    if not len(asked):
        return np.zeros(0, dtype=np.bool_)
    turns = np.asarray(igl.fast_winding_number(face.skin.positions, face.skin.triangles, asked))
    return (turns < OUTSIDE) & (nearest(face.skin, asked)[2] > ON_SKIN)


def kind_of_place(face: Face, point: FloatArray) -> tuple[Kind, int]:
    """What a point (3,) lies on, and the number of the skin vertex that it lies on or over; -1 if on neither."""
    points: tuple[tuple[Kind, KDTree], ...] = (("vertex", face.skin.tree), ("foot", _feet_tree(face)))
    for kind, tree in points:
        away, vertex = tree.query(point)
        if away < SNAPPED:
            return kind, int(vertex)
    surfaces: tuple[tuple[Kind, Mesh], ...] = (
        ("skin", face.skin),
        ("bone", face.skull.cranium),
        ("bone", face.skull.mandible),
    )
    for kind, mesh in surfaces:
        if nearest(mesh, point)[2][0] < SNAPPED:
            return kind, -1
    return "free", -1


def mirrored_place(face: Face, point: FloatArray) -> FloatArray:
    """The same place (3,) on the other side of a face.

    A point on a vertex of the skin, or on the bone under one, goes to that of the mirrored vertex, so that it
    is right on a face that is not quite symmetric; another point is reflected in the middle plane.  On a face that
    does not know which vertices mirror each other every point is reflected, and what lay on skin or bone is put back
    on it.
    """
    kind, vertex = kind_of_place(face, point)
    if knows_mirror(face):
        if kind == "vertex":
            return np.array(face.skin.positions[face.mirror[vertex]])
        if kind == "foot":
            return np.array(face.skull.anchors[face.mirror[vertex]])
        return _reflected(face, point)
    return settled(face, _reflected(face, point), kind)


@lru_cache(maxsize=16)
def knows_mirror(face: Face) -> bool:
    """Whether a face knows the vertex across the midline of every vertex of its skin."""
    own = np.arange(len(face.skin.positions))
    paired = len(face.mirror) == len(own) and np.array_equal(face.mirror[face.mirror], own)
    return bool(paired and (face.mirror != own).any())


def settled(face: Face, point: FloatArray, kind: Kind) -> FloatArray:
    """The place (3,) of a kind that is nearest to a point."""
    if kind == "vertex":
        return on_skin(face, point, "vertex")
    if kind == "foot":
        return nearest_foot(face, point)
    if kind == "skin":
        return on_skin(face, point, "surface")
    return on_bone(face, point, "surface") if kind == "bone" else np.array(point)


def _reflected(face: Face, point: FloatArray) -> FloatArray:
    middle, across = middle_plane(face)
    return np.asarray(point - 2 * ((point - middle) @ across) * across)


def mirrored_vector(face: Face, vector: FloatArray) -> FloatArray:
    """A direction (3,) reflected in the middle plane of a face."""
    across = middle_plane(face)[1]
    return np.asarray(vector - 2 * (vector @ across) * across)


@lru_cache(maxsize=16)
def middle_plane(face: Face) -> tuple[FloatArray, FloatArray]:
    """A point (3,) and the unit normal (3,), to the subject's left, of the plane between mirrored vertices.

    Where a face does not know them the plane lies between its eyes, or in the middle of its skin.
    """
    skin = face.skin.positions
    if not knows_mirror(face):
        return _plane_between_eyes(face)
    apart = skin - skin[face.mirror]
    left = apart[:, 0] > 0
    across = apart[left].sum(axis=0) if left.any() else np.array([1.0, 0.0, 0.0])
    across = np.where(np.abs(across) < FLAT * np.linalg.norm(across), 0.0, across)
    across /= np.linalg.norm(across)
    height = float(((skin + skin[face.mirror]) @ across).mean() / 2)
    return (0.0 if abs(height) < SNAPPED else height) * across, across


def _plane_between_eyes(face: Face) -> tuple[FloatArray, FloatArray]:
    centres = {eye.side: eye.centre for eye in face.eyes}
    if centres.keys() >= {"L", "R"}:
        across = (centres["L"] - centres["R"]) / np.linalg.norm(centres["L"] - centres["R"])
        return (centres["L"] + centres["R"]) / 2, across
    middle = (face.skin.positions.min(axis=0) + face.skin.positions.max(axis=0)) / 2
    return middle * [1.0, 0.0, 0.0], np.array([1.0, 0.0, 0.0])


@lru_cache(maxsize=16)
def _feet_tree(face: Face) -> KDTree:
    return KDTree(face.skull.anchors)


def nearest_foot(face: Face, point: FloatArray) -> FloatArray:
    """The nearest point (3,) of the bone that lies under a vertex of the skin."""
    return np.array(face.skull.anchors[_feet_tree(face).query(point)[1]])
