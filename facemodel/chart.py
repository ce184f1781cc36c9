"""The chart (u, v) of a skin: bijective, of low distortion, with holes allowed (design section 3).

The inner loops are closed with a fan, Tutte's map puts the disk into a circle without a flip, and SLIM lowers
the symmetric Dirichlet energy from there without ever flipping a triangle.
"""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import splu

from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from fem.types import FloatArray, IntArray

SLIM_ITERATIONS = 30
"""On a head the energy falls by less than a thousandth per iteration after twenty."""


@dataclass(frozen=True)
class ChartFigures:
    """How good a chart is.

    Attributes
    ----------
    flips : triangles turned over (must be zero)
    worst : largest stretch, as the larger of the greatest singular value and the inverse of the smallest
    p95 : the same figure at the 95th percentile of the triangles
    """

    flips: int
    worst: float
    p95: float


def jacobians(mesh: Mesh, uv: FloatArray) -> FloatArray:
    """Map d(u, v)/d(s, t) of each triangle against its own isometric plane, (T, 2, 2)."""
    a, b, c = (mesh.positions[mesh.triangles[:, k]] for k in range(3))
    s = (b - a) / np.linalg.norm(b - a, axis=1, keepdims=True)
    normal = mesh.triangle_normals / np.linalg.norm(mesh.triangle_normals, axis=1, keepdims=True)
    t = np.cross(normal, s)
    flat = np.stack([np.stack([_dot(b - a, s), _dot(c - a, s)], 1), np.stack([_dot(b - a, t), _dot(c - a, t)], 1)], 1)
    pa, pb, pc = (uv[mesh.triangles[:, k]] for k in range(3))
    drawn = np.stack([pb - pa, pc - pa], axis=2)
    return np.asarray(drawn @ np.linalg.inv(flat))


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    return np.asarray(np.einsum("ij,ij->i", a, b))


def chart_figures(mesh: Mesh, uv: FloatArray) -> ChartFigures:
    """Flips and stretch of a chart (N, 2) of a mesh."""
    j = jacobians(mesh, uv)
    singular = np.linalg.svd(j, compute_uv=False)
    stretch = np.maximum(singular[:, 0], 1 / np.maximum(singular[:, 1], 1e-12))
    flips = int((np.linalg.det(j) <= 0).sum())
    return ChartFigures(flips, float(stretch.max()), float(np.percentile(stretch, 95)))


def _filled(mesh: Mesh) -> tuple[Mesh, IntArray]:
    """Close every loop but the longest with a fan about its middle; returns the disk and its outer loop."""
    *inner, outer = mesh.boundary_loops
    positions, triangles = [mesh.positions], [mesh.triangles]
    for k, loop in enumerate(inner):
        positions.append(mesh.positions[loop].mean(axis=0, keepdims=True))
        centre = np.full(len(loop), len(mesh.positions) + k)
        triangles.append(np.stack([np.roll(loop, -1), loop, centre], axis=1))
    return Mesh(np.concatenate(positions), np.concatenate(triangles)), outer


def _tutte(disk: Mesh, outer: IntArray) -> FloatArray:
    """Tutte's embedding with uniform weights: bijective whatever the mesh."""
    circle = igl.map_vertices_to_circle(disk.positions, outer)
    n = len(disk.positions)
    laplacian = csr_array(diags_array(np.asarray(disk.adjacency.sum(axis=1)).ravel()) - disk.adjacency)
    free = np.setdiff1d(np.arange(n), outer)
    uv = np.zeros((n, 2))
    uv[outer] = circle
    uv[free] = splu(laplacian[free][:, free].tocsc()).solve(-(laplacian[free][:, outer] @ circle))
    area = np.linalg.norm(disk.triangle_normals, axis=1).sum() / 2
    return np.asarray(uv * np.sqrt(area / np.pi))


def make_chart(mesh: Mesh, iterations: int = SLIM_ITERATIONS, energy: str = "SYMMETRIC_DIRICHLET") -> FloatArray:
    """A bijective chart (N, 2) in millimetres, of about the area of the mesh.

    Parameters
    ----------
    mesh : connected, manifold, with at least one boundary loop; the longest becomes the outer one
    iterations : of SLIM
    energy : name of one of libigl's flip-free energies

    Raises
    ------
    FaceError
        If the mesh has no boundary, or a triangle came out flipped.
    """
    if not mesh.boundary_loops:
        raise FaceError("The skin is closed and has no chart; cut it open at the mouth, the eyes or the neck.")
    disk, outer = _filled(mesh)
    data = igl.slim_precompute(
        disk.positions,
        disk.triangles,
        _tutte(disk, outer),
        getattr(igl.MappingEnergyType, energy),
        np.zeros(0, dtype=np.int64),
        np.zeros((0, 2)),
        0.0,
    )
    uv = np.asarray(igl.slim_solve(data, iterations))[: len(mesh.positions)].copy()
    figures = chart_figures(mesh, uv)
    if figures.flips:
        raise FaceError(f"The chart of the skin has {figures.flips} flipped triangles; repair the mesh around them.")
    return uv
