"""The tissue between skin and skull as a layer that keeps its volume where that is painted (design section 4)."""

from __future__ import annotations

import numpy as np

from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.tissue import tissue_thickness
from fem import VolumeLayer
from fem.types import FloatArray, IntArray


def volume_layer(face: Face, vertices: IntArray) -> VolumeLayer:
    """The layer under some skin vertices; stiffness zero where nobody painted it."""
    return VolumeLayer(face.layers.volume[vertices], tissue_thickness(face)[vertices])


def bone_volume(skin: Mesh, thickness: FloatArray, moved: FloatArray) -> FloatArray:
    """Volume per area (n,), millimetres, by which bone that moves lifts the skin over it.

    Displacements are linear from bone to skin.  Bone that moves by b sweeps ``b . n`` and, where it is drawn apart,
    makes room for ``t / 2 div b``; the tissue keeps its volume where the skin changes it by the difference (see
    `fem.volume`).

    Parameters
    ----------
    skin : n vertices, millimetres
    thickness : (n,) of the tissue under them, millimetres
    moved : (n, 3) of the bone under them, millimetres
    """
    swept = np.einsum("ij,ij->i", moved, skin.normals)
    return np.asarray(swept - thickness / 2 * divergence(skin, moved))


def divergence(skin: Mesh, field: FloatArray) -> FloatArray:
    """Divergence along the surface (n,) of a field (n, 3) that is linear in every triangle, averaged about vertices."""
    corners = skin.positions[skin.triangles]
    normals = skin.triangle_normals
    square = np.einsum("ij,ij->i", normals, normals)
    # The gradient of a corner's share is its opposite edge, turned by a right angle in the plane, over twice the area.
    opposite = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    gradients = np.cross(normals[:, None], opposite) / square[:, None, None]
    own = np.einsum("tkc,tkc->t", gradients, field[skin.triangles])
    around = np.repeat(np.sqrt(square) / 6, 3)
    total = np.bincount(skin.triangles.ravel(), around * np.repeat(own, 3), len(skin.positions))
    return np.asarray(total / np.maximum(skin.vertex_areas, np.finfo(np.float64).tiny))
