"""From a field of signed distances to a light, closed triangle mesh."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import igl
import numpy as np
from scipy.ndimage import zoom

from facemodel.mesh import Mesh
from fem.types import FloatArray


@dataclass(frozen=True, eq=False)
class Grid:
    """A regular grid in a box, symmetric about x = 0 when the box is.

    Attributes
    ----------
    low : (3,) the corner with the smallest coordinates
    step : distance of neighbours, millimetres
    size : number of points along x, y and z
    """

    low: FloatArray
    step: float
    size: tuple[int, int, int]

    @classmethod
    def over(cls, low: Sequence[float], high: Sequence[float], step: float) -> Grid:
        """The coarsest grid of a step that covers a box, centred on it."""
        ends = np.array([low, high])
        cells = np.ceil((ends[1] - ends[0]) / step).astype(int)
        x, y, z = (cells + 1).tolist()
        return cls(ends.mean(axis=0) - step * cells / 2, step, (x, y, z))

    def points(self) -> FloatArray:
        """The points (n, 3), x fastest."""
        z, y, x = np.meshgrid(*(np.arange(n, dtype=np.float64) for n in self.size[::-1]), indexing="ij")
        return self.low + self.step * np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)

    def halved(self) -> Grid:
        """The grid of half the step that holds every point of this one."""
        x, y, z = (2 * n - 1 for n in self.size)
        return Grid(self.low, self.step / 2, (x, y, z))

    def refined(self, values: FloatArray) -> FloatArray:
        """Values (n,) on this grid carried to the halved one by cubic splines."""
        cube = values.reshape(self.size[::-1])
        return np.asarray(zoom(cube, [(2 * n - 1) / n for n in cube.shape], order=3, mode="mirror")).ravel()


def largest_piece(mesh: Mesh) -> Mesh:
    """The connected piece with most triangles."""
    _, labels = igl.facet_components(mesh.triangles)
    keep = labels == np.bincount(labels).argmax()
    vertices, triangles = np.unique(mesh.triangles[keep], return_inverse=True)
    return Mesh(mesh.positions[vertices], triangles.reshape(-1, 3).astype(np.int64))


def relaxed(mesh: Mesh, rounds: int) -> Mesh:
    """Taubin's smoothing: takes the grid's steps out and keeps the volume."""
    degree = np.asarray(mesh.adjacency.sum(axis=1))[:, None]
    p = mesh.positions
    for _ in range(rounds):
        for share in (0.5, -0.53):
            p = p + share * (mesh.adjacency @ p / degree - p)
    return mesh.moved(p)


def meshed(grid: Grid, values: FloatArray, triangles: int) -> Mesh:
    """The closed surface where a field sampled on a grid is zero, reduced to about a number of triangles."""
    positions, found, _ = igl.marching_cubes(values, grid.points(), *grid.size, 0.0)
    whole = relaxed(largest_piece(Mesh(positions, found.astype(np.int64))), 9)
    p, t, *_ = igl.qslim(whole.positions, whole.triangles, triangles)
    return Mesh(np.ascontiguousarray(p), np.ascontiguousarray(t, dtype=np.int64))
