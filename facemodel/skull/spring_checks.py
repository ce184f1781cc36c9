"""Springs of the tissue that mean nothing: those of no length, and those that go through bone before their foot.

Koch et al. 1998 (section 4.2) let every spring run freely from skin to bone.  Where a skull is placed, scaled or
imported badly it does not: the skin then lies on the bone, or in it, or another bone lies between.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import igl
import numpy as np

from facemodel.face import Face
from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray, IntArray

NO_LENGTH = 0.01
"""Millimetres; a shorter spring has no direction worth the name.  Stored faces are exact to a hundredth of this; the
shortest spring of the shipped ones is half a millimetre."""

THROUGH = 11.0
"""Millimetres between the place where a spring meets bone and its foot, from which on it goes through that bone.  Feet
lie on the smooth surface under which the bone is modelled, which knows nothing of teeth: up to 8 mm behind the sockets
of molars on the shipped faces, and the struts of neighbours up to 10."""

INSIDE = 0.5
"""Windings of the bone about a place in it are one, about a place in the open none."""


@dataclass(frozen=True, eq=False)
class SpringFaults:
    """Which springs of a tissue are left out of it.

    Attributes
    ----------
    vertices : (M,) skin vertex that each spring starts at
    feet : (M, 3) the other end, millimetres
    no_length : (M,) those that end where they start
    through : (M,) those that start in bone or go through it before their foot
    """

    vertices: IntArray
    feet: FloatArray
    no_length: BoolArray
    through: BoolArray

    @property
    def left_out(self) -> BoolArray:
        """Springs (M,) that are not solved."""
        return self.no_length | self.through

    @property
    def at(self) -> IntArray:
        """Skin vertices (k,), in order, at which a spring is left out."""
        return np.unique(self.vertices[self.left_out])


def spring_ends(skin: Mesh, vertices: IntArray) -> tuple[IntArray, IntArray]:
    """Where the springs of some skin vertices (n,) start, and over which vertex their foot lies.

    Returns
    -------
    starts : (M,) index into ``vertices``; the main springs come first, in order, then the struts
    over : (M,) skin vertex whose point of the bone each one goes to
    """
    strut_from, strut_to = skin.adjacency[vertices].tocoo().coords
    return np.concatenate([np.arange(len(vertices)), strut_from]), np.concatenate([vertices, strut_to])


def spring_faults(face: Face, vertices: IntArray) -> SpringFaults:
    """Check the springs of some skin vertices (n,); remembered for the last few states of skin and bone."""
    skull = face.skull
    feet, some = (np.ascontiguousarray(array) for array in (skull.anchors, vertices))
    return _faults(face.skin, skull.cranium, skull.mandible, feet.tobytes(), some.astype(np.int64).tobytes())


@lru_cache(maxsize=4)
def _faults(skin: Mesh, cranium: Mesh, mandible: Mesh, feet: bytes, vertices: bytes) -> SpringFaults:
    own = np.frombuffer(vertices, dtype=np.int64)
    starts, over = spring_ends(skin, own)
    ends = np.frombuffer(feet, dtype=np.float64).reshape(-1, 3)[over]
    reach = ends - skin.positions[own[starts]]
    length = np.linalg.norm(reach, axis=1)
    bone = whole_bone(cranium, mandible)
    tree = igl.AABB()
    tree.init(bone.positions, bone.triangles)
    skin_at = skin.positions[own]
    in_bone = np.asarray(igl.fast_winding_number(bone.positions, bone.triangles, skin_at)) > INSIDE
    square, _, _ = tree.squared_distance(bone.positions, bone.triangles, skin_at)
    through = in_bone[starts]
    # No spring meets bone before the nearest bone there is, which spares most of them the search along their way.
    asked = np.flatnonzero(~through & (length - np.sqrt(np.reshape(square, -1))[starts] > THROUGH))
    lines = np.ascontiguousarray(skin_at[starts[asked]]), np.ascontiguousarray(reach[asked])
    met, share, _ = tree.intersect_ray_first(bone.positions, bone.triangles, *lines)
    behind = np.where(np.asarray(met) >= 0, 1 - np.asarray(share), 0.0) * length[asked]
    through[asked] = behind > THROUGH
    no_length = length < NO_LENGTH
    return SpringFaults(own[starts], ends, no_length, through & ~no_length)


def whole_bone(cranium: Mesh, mandible: Mesh) -> Mesh:
    """Both bones as one mesh, the mandible behind the cranium."""
    return Mesh(
        np.concatenate([cranium.positions, mandible.positions]),
        np.concatenate([cranium.triangles, mandible.triangles + len(cranium.positions)]),
    )
