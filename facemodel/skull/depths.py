"""How deep the bone lies under the skin everywhere, and where it comes through."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import igl
import numpy as np

from facemodel.face import Face, Skull
from facemodel.mesh import Mesh
from facemodel.skull.naming import spoken
from facemodel.system import solved_vertices
from fem.types import BoolArray, FloatArray, IntArray

OUTSIDE = 0.5
"""Windings of the skin about a place on it; within the head there are more, in the air fewer."""

NEAR = 20.0
"""Millimetres from the skin beyond which bone is not taken for poking through it: a skull base that hangs out of a cut
neck goes through no skin."""


@dataclass(frozen=True, eq=False)
class Depths:
    """How deep the bone lies.

    Attributes
    ----------
    depth : (N,) millimetres from every skin vertex to the nearest bone, below zero where the bone is outside
    through : (N,) where bone comes through the skin
    shallowest, deepest : millimetres, over the solved part of the face
    """

    depth: FloatArray
    through: BoolArray
    shallowest: float
    deepest: float

    @property
    def count(self) -> int:
        """Vertices that bone comes through."""
        return int(self.through.sum())


def bone_depths(face: Face) -> Depths:
    """The depths of a face; remembered for the last few states of skin and bone."""
    return _depths(face.skin, face.skull.cranium, face.skull.mandible, solved_vertices(face).tobytes())


@lru_cache(maxsize=4)
def _depths(skin: Mesh, cranium: Mesh, mandible: Mesh, solved: bytes) -> Depths:
    bone = joined(cranium, mandible)
    kind = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    depth = np.asarray(igl.signed_distance(skin.positions, bone.positions, bone.triangles, kind)[0])
    through = depth < 0
    away, pierced = skin.tree.query(bone.positions)
    windings = np.asarray(igl.fast_winding_number(skin.positions, skin.triangles, bone.positions))
    out = (windings < OUTSIDE) & (away < NEAR)
    # Seen past the rim of the neck a place has few windings too, without having gone through any skin.
    ahead = np.einsum("ij,ij->i", bone.positions - skin.positions[pierced], skin.normals[pierced])
    out &= (ahead > 0) & ~_on_rim(skin)[pierced]
    through[pierced[out]] = True
    depth = np.where(through, -np.abs(depth), depth)
    vertices = np.frombuffer(solved, dtype=np.int64)
    return Depths(depth, through, float(depth[vertices].min()), float(depth[vertices].max()))


def _on_rim(skin: Mesh) -> BoolArray:
    """Which vertices lie on a border of the skin."""
    rim = np.zeros(len(skin.positions), dtype=np.bool_)
    for loop in skin.boundary_loops:
        rim[loop] = True
    return rim


def joined(one: Mesh, other: Mesh) -> Mesh:
    """Two meshes as one; the vertices of the first come first."""
    return Mesh(
        np.concatenate([one.positions, other.positions]),
        np.concatenate([one.triangles, other.triangles + len(one.positions)]),
    )


def whole(skull: Skull) -> Mesh:
    """Both bones as one mesh; the vertices of the cranium come first."""
    return joined(skull.cranium, skull.mandible)


def worst_places(face: Face, depths: Depths) -> IntArray:
    """Skin vertices (k,) that bone comes through, the worst first."""
    pierced = np.flatnonzero(depths.through)
    return np.asarray(pierced[np.argsort(depths.depth[pierced])])


def complaint(face: Face) -> str:
    """One sentence that says where bone comes through the skin, how far, and what to do; empty if it does not."""
    depths = bone_depths(face)
    if not depths.count:
        return ""
    worst = int(worst_places(face, depths)[0])
    vertices = "1 vertex" if depths.count == 1 else f"{depths.count} vertices"
    return (
        f"Bone comes through the skin at {vertices}, {-depths.depth[worst]:.1f} mm{_where(face, worst)}: "
        "move or scale the skull, or snap it to the depths of the tissue."
    )


def _where(face: Face, vertex: int) -> str:
    """The landmark nearest to a vertex, as people say it."""
    if not face.landmarks:
        return f" at vertex {vertex}"
    names = list(face.landmarks)
    places = face.skin.positions[list(face.landmarks.values())]
    return f" near the {spoken(names[int(np.linalg.norm(places - face.skin.positions[vertex], axis=1).argmin())])}"
