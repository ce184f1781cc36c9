"""Distances on the skin from any of its points, fast enough for a moving brush."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.mesh import Mesh
from facemodel.painting.unfolding import corner_windows, point_windows, strips, unfold
from fem.types import FloatArray, IntArray

NEIGHBOURS = 120
"""A vertex is joined by straight lines to all that it sees as far away as this many nearest ones: so many directions
to leave it that a path over a few of them is hardly longer than the geodesic."""

RINGS = 3
"""Triangles crossed at least, where the mesh is coarse on one side of a vertex."""

POINT_REACH = 1.8
"""The point itself sees farther than the vertices about it by this factor; nearer distances are exact."""

INSIDE = 1e-4
"""Least barycentric coordinate of a source: from the rim of a triangle, windows would be seen edge-on."""


@dataclass(frozen=True, eq=False)
class SurfacePoint:
    """A point on the skin.

    Attributes
    ----------
    triangle : of the skin
    barycentric : (3,) coordinates in it
    """

    triangle: int
    barycentric: FloatArray

    def position(self, mesh: Mesh) -> FloatArray:
        """Where it is (3,), millimetres."""
        return np.asarray(self.barycentric @ mesh.positions[mesh.triangles[self.triangle]])


@dataclass(frozen=True, eq=False)
class Ball:
    """Vertices (k,) within a geodesic radius of a point, and their distances (k,) in millimetres."""

    vertices: IntArray
    distances: FloatArray


class Geodesics:
    """Geodesic distances on one mesh.

    Every vertex is joined once to those that it sees along a straight line in the unfolded mesh.  From a point the same
    lines are found anew, and go on from vertex to vertex: where a geodesic passes a hole or a saddle it does run over
    vertices, elsewhere it loses up to two hundredths of its length.  A distance is never too short.

    Parameters
    ----------
    mesh : manifold; kept as `mesh`
    """

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh
        self._strips = strips(mesh)
        count = min(NEIGHBOURS, len(mesh.positions) - 1)
        self._reach: FloatArray = mesh.tree.query(mesh.positions, k=count + 1)[0][:, -1]
        self._starts, self._ends, self._lengths = self._lines()

    def _lines(self) -> tuple[IntArray, IntArray, FloatArray]:
        """All lines by the vertex they start from: where in the lists each begins, ends and lengths."""
        one, other, length = unfold(self._strips, corner_windows(self._strips), self._reach, RINGS)
        i, j = self.mesh.edges.T
        along = np.linalg.norm(self.mesh.positions[i] - self.mesh.positions[j], axis=1)
        start = np.concatenate([one, other, i, j])
        end = np.concatenate([other, one, j, i])
        length = np.concatenate([length, length, along, along])
        # Two vertices may see each other along several lines: the shortest comes first, and alone stays.
        order = np.lexsort((length, end, start))
        start, end, length = start[order], end[order], length[order]
        first = np.append(True, (start[1:] != start[:-1]) | (end[1:] != end[:-1])) & (start != end)
        starts = np.searchsorted(start[first], np.arange(len(self.mesh.positions) + 1))
        return starts.astype(np.int64), end[first], length[first]

    def within(self, point: SurfacePoint, radius: float) -> Ball:
        """Vertices nearer to a point than a radius (millimetres), and how far they are."""
        barycentric = np.maximum(point.barycentric, INSIDE)
        windows, away = point_windows(self._strips, point.triangle, barycentric / barycentric.sum())
        corners = self.mesh.triangles[point.triangle]
        reach = min(radius, POINT_REACH * self._reach[corners].max())
        _, seen, distance = unfold(self._strips, windows, np.array([reach]))
        nearest = np.full(len(self.mesh.positions), np.inf)
        nearest[corners] = away
        np.minimum.at(nearest, seen, distance)
        nearest[nearest > radius] = np.inf
        self._spread(nearest, radius)
        vertices = np.flatnonzero(nearest < np.inf)
        return Ball(vertices, nearest[vertices])

    def _spread(self, nearest: FloatArray, radius: float) -> None:
        """Go on along the lines from all vertices that are known, until nothing gets nearer."""
        front = np.flatnonzero(nearest < np.inf)
        moved = np.zeros(len(nearest), dtype=np.bool_)
        while len(front):
            count = self._starts[front + 1] - self._starts[front]
            last = np.cumsum(count)
            line = np.arange(last[-1]) + np.repeat(self._starts[front] - last + count, count)
            distance = np.repeat(nearest[front], count) + self._lengths[line]
            end = self._ends[line]
            nearer = (distance < nearest[end]) & (distance <= radius)
            np.minimum.at(nearest, end[nearer], distance[nearer])
            moved[:] = False
            moved[end[nearer]] = True
            front = np.flatnonzero(moved)
