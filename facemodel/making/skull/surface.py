"""From a field of signed distances to a light, closed triangle mesh."""

from __future__ import annotations

from collections.abc import Callable

import igl
import numpy as np

from facemodel.mesh import Mesh
from fem.types import FloatArray

Field = Callable[[FloatArray], FloatArray]
"""Signed distance (n,) at points (n, 3), negative inside, in millimetres."""


def grid(low: FloatArray, high: FloatArray, step: float) -> tuple[FloatArray, tuple[int, int, int]]:
    """Points (n, 3) of a regular grid between two corners, x fastest, symmetric about x = 0, and its size."""
    reach = step * (np.ceil(max(-low[0], high[0]) / step - 0.5) + 0.5)
    axes = [np.arange(-reach, reach + step / 2, step)]
    axes += [np.arange(low[k], high[k] + step, step) for k in (1, 2)]
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    return np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1), (len(axes[0]), len(axes[1]), len(axes[2]))


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


def meshed(values: FloatArray, points: FloatArray, size: tuple[int, int, int], triangles: int) -> Mesh:
    """The closed surface where a field sampled on a grid is zero, reduced to about a number of triangles."""
    found = igl.marching_cubes(values, points, *size, 0.0)
    whole = relaxed(largest_piece(Mesh(found[0], found[1].astype(np.int64))), 6)
    p, t, *_ = igl.qslim(whole.positions, whole.triangles, triangles)
    return Mesh(np.ascontiguousarray(p), np.ascontiguousarray(t, dtype=np.int64))
