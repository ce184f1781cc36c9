"""Where on a skull its jaw may be: what lies nearer to the mandible of another skull than to its cranium."""

from __future__ import annotations

import igl
import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from facemodel.face import Skull
from facemodel.mesh import Mesh
from facemodel.painting.regions import grown, shrunk
from fem.types import BoolArray, FloatArray

LOOSE = 0.02
"""Share of a region below which a piece of it is a crumb."""

FAR = 25.0
"""Millimetres from either bone beyond which nothing can be said."""


def proposed_jaw(bone: Mesh, known: Skull) -> BoolArray:
    """Vertices (M,) of a skull that may be its jaw, by a skull that lies in the same place; none if it has no jaw.

    The border is smoothed by a ring of vertices, crumbs beside it are left out, and holes are filled.
    """
    if not len(known.mandible.triangles):
        return np.zeros(len(bone.positions), dtype=np.bool_)
    away = np.column_stack([_distance(mesh, bone.positions) for mesh in (known.cranium, known.mandible)])
    jaw = (away[:, 1] < away[:, 0]) & (away[:, 1] < FAR)
    jaw = grown(bone, shrunk(bone, jaw))
    return ~_without_crumbs(bone, ~_without_crumbs(bone, jaw))


def _without_crumbs(mesh: Mesh, region: BoolArray) -> BoolArray:
    """A region without small pieces that are cut out of what is around them; a loose tooth is a piece of its own."""
    count, edges = len(region), mesh.edges
    i, j = edges[region[edges].all(axis=1)].T
    graph = coo_array((np.ones(len(i), dtype=np.int8), (i, j)), shape=(count, count))
    piece = connected_components(graph, directed=False)[1]
    cut = np.zeros(count, dtype=np.bool_)
    cut[piece[edges[region[edges].sum(axis=1) == 1]]] = True
    small = np.bincount(piece[region], minlength=count) < LOOSE * region.sum()
    return np.asarray(region & ~(small & cut)[piece])


def _distance(mesh: Mesh, points: FloatArray) -> FloatArray:
    square, _, _ = igl.point_mesh_squared_distance(points, mesh.positions, mesh.triangles)
    return np.asarray(np.sqrt(np.reshape(square, -1)))
