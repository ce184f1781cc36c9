"""Triangle meshes as frozen values, and what can be read off them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import igl
import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.spatial import KDTree

from fem.types import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Mesh:
    """A triangle mesh.

    Attributes
    ----------
    positions : (N, 3) float64, millimetres
    triangles : (T, 3) int64, counter-clockwise seen from outside
    """

    positions: FloatArray
    triangles: IntArray

    @cached_property
    def triangle_normals(self) -> FloatArray:
        """Normals (T, 3) whose length is twice the triangle's area."""
        a, b, c = (self.positions[self.triangles[:, k]] for k in range(3))
        return np.cross(b - a, c - a)

    @cached_property
    def normals(self) -> FloatArray:
        """Area-weighted unit normals (N, 3); zero at vertices that no triangle uses."""
        total = np.zeros_like(self.positions)
        for k in range(3):
            np.add.at(total, self.triangles[:, k], self.triangle_normals)
        length = np.linalg.norm(total, axis=1, keepdims=True)
        normals: FloatArray = np.divide(total, length, out=np.zeros_like(total), where=length > 0)
        return normals

    @cached_property
    def vertex_areas(self) -> FloatArray:
        """A third of the area of the triangles around each vertex (N,), square millimetres."""
        area = np.linalg.norm(self.triangle_normals, axis=1) / 6
        around = np.bincount(self.triangles.ravel(), np.repeat(area, 3), len(self.positions))
        return around.astype(np.float64)

    @cached_property
    def edges(self) -> IntArray:
        """Undirected edges (E, 2), each once, smaller index first."""
        pairs = np.sort(self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        return np.unique(pairs, axis=0)

    @cached_property
    def adjacency(self) -> csr_array:
        """Symmetric adjacency (N, N) of ones."""
        n = len(self.positions)
        i, j = self.edges.T
        half = coo_array((np.ones(len(i)), (i, j)), shape=(n, n))
        return csr_array(half + half.T)

    @cached_property
    def box(self) -> FloatArray:
        """The least and the largest coordinates (2, 3)."""
        return np.stack([self.positions.min(axis=0), self.positions.max(axis=0)])

    @cached_property
    def tree(self) -> KDTree:
        """Search tree over the positions."""
        return KDTree(self.positions)

    @cached_property
    def boundary_loops(self) -> tuple[IntArray, ...]:
        """Boundary loops as vertex indices in order, the longest (in millimetres) last."""
        loops = [np.array(loop, dtype=np.int64) for loop in igl.boundary_loop_all(self.triangles)]
        return tuple(sorted(loops, key=lambda loop: loop_length(self.positions, loop)))

    def moved(self, positions: FloatArray) -> Mesh:
        """The same triangles with other positions (N, 3)."""
        return Mesh(positions, self.triangles)


def loop_length(positions: FloatArray, loop: IntArray) -> float:
    """Length in millimetres of a closed loop of vertices."""
    return float(np.linalg.norm(positions[loop] - positions[np.roll(loop, -1)], axis=1).sum())


def submesh(mesh: Mesh, keep: np.typing.NDArray[np.bool_]) -> tuple[Mesh, IntArray]:
    """The triangles marked in ``keep`` (T,) as a mesh of their own.

    Returns
    -------
    mesh : the part, its vertices numbered in the order of the whole
    vertices : (n,) int, the index of each of its vertices in the whole
    """
    vertices, triangles = np.unique(mesh.triangles[keep], return_inverse=True)
    return Mesh(mesh.positions[vertices], triangles.reshape(-1, 3).astype(np.int64)), vertices.astype(np.int64)
