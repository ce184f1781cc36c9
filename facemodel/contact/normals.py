"""Normals of points that were moved by hand of a rule: the slopes of the surface turn with the slopes of the motion."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array, csr_array

from facemodel.compiled import compiled
from facemodel.display import DisplaySurface
from facemodel.face import Face
from fem.types import Float32Array, FloatArray, IntArray

SMALLEST_NORMAL = np.float32(1e-12)
"""Guards the division where a surface folds onto itself and its normal vanishes."""


class TurnedNormals:
    """Turns the normals of some drawn points, and of those around them, with what those points were moved by.

    The motion is linear on each drawn triangle; its slopes in the chart are averaged over the triangles at a point, by
    their area there, and added to the slopes of the sum of fields.

    Parameters
    ----------
    face : whose chart it is
    display : what is drawn
    points : (n,) moving points of the display that may be moved

    Attributes
    ----------
    turned : (m,) points whose normals may turn
    """

    def __init__(self, face: Face, display: DisplaySurface, points: IntArray) -> None:
        number = np.full(len(display.points), -1)
        number[points] = np.arange(len(points))
        triangles = display.triangles[(number[display.triangles] >= 0).any(axis=1)]
        corners = np.unique(triangles)
        self.turned: IntArray = corners[corners < display.moving]
        row = np.full(len(display.points), -1)
        row[self.turned] = np.arange(len(self.turned))
        places = face.skin.triangles[display.elements[corners]]
        chart = np.zeros((len(display.points), 2))
        chart[corners] = np.einsum("pk,pkc->pc", display.barycentric[corners], face.chart[places])
        d_u, d_v = _slopes(chart[triangles], row[triangles], number[triangles], len(points))
        self._starts, self._points = d_u.indptr.astype(np.int64), d_u.indices.astype(np.int64)
        self._d_u, self._d_v = d_u.data, d_v.data

    def turn(self, normals: Float32Array, slopes: Float32Array, moved: Float32Array) -> None:
        """Write those normals (P, 3) of `turned` in place that turn.

        Parameters
        ----------
        slopes : (6, S) of the moving points before they were moved, as `facemodel.basis.Basis.slopes` has them
        moved : (n, 3) by how much
        """
        _turn(normals, slopes, moved, self.turned, self._starts, self._points, self._d_u, self._d_v)


@compiled
def _turn(
    normals: Float32Array,
    slopes: Float32Array,
    moved: Float32Array,
    turned: IntArray,
    starts: IntArray,
    points: IntArray,
    d_u: Float32Array,
    d_v: Float32Array,
) -> None:
    """See `TurnedNormals.turn`; what is not moved keeps the normal that it has."""
    for row, i in enumerate(turned):
        ux, uy, uz = slopes[0, i], slopes[1, i], slopes[2, i]
        vx, vy, vz = slopes[3, i], slopes[4, i], slopes[5, i]
        still = True
        for k in range(starts[row], starts[row + 1]):
            x, y, z = moved[points[k], 0], moved[points[k], 1], moved[points[k], 2]
            if x != 0 or y != 0 or z != 0:
                still = False
                ux, uy, uz = ux + d_u[k] * x, uy + d_u[k] * y, uz + d_u[k] * z
                vx, vy, vz = vx + d_v[k] * x, vy + d_v[k] * y, vz + d_v[k] * z
        if not still:
            _write(normals, i, ux, uy, uz, vx, vy, vz)


@compiled
def _write(normals: Float32Array, i: int, ux: float, uy: float, uz: float, vx: float, vy: float, vz: float) -> None:
    """Write the unit normal of a point by the slopes of the surface along u and v."""
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    length = np.sqrt(nx * nx + ny * ny + nz * nz) + SMALLEST_NORMAL
    normals[i, 0], normals[i, 1], normals[i, 2] = nx / length, ny / length, nz / length


@compiled
def normals_of(slopes: Float32Array, normals: Float32Array) -> None:
    """Write unit normals (P, 3) of the points whose slopes (6, S) are given, the first ones of them."""
    for i in range(slopes.shape[1]):
        ux, uy, uz = slopes[0, i], slopes[1, i], slopes[2, i]
        vx, vy, vz = slopes[3, i], slopes[4, i], slopes[5, i]
        _write(normals, i, ux, uy, uz, vx, vy, vz)


def _slopes(chart: FloatArray, rows: IntArray, columns: IntArray, count: int) -> tuple[csr_array, csr_array]:
    """Operators from a motion (count, 3) to its slopes along u and v, with their numbers at the same places.

    Parameters
    ----------
    chart : (T, 3, 2) corners of triangles in the chart
    rows, columns : (T, 3) number of each corner in the result and in the motion; -1 where it is in neither
    """
    side = np.roll(chart, -1, axis=1) - np.roll(chart, -2, axis=1)
    twice = side[:, 1, 0] * side[:, 2, 1] - side[:, 1, 1] * side[:, 2, 0]
    area = np.abs(twice)
    sign = np.where(twice < 0, -1.0, 1.0)[:, None]
    # The slope of a corner's hat function times the area of the triangle: its side opposite, turned by 90 degrees.
    hats = sign[..., None] * np.stack([side[..., 1], -side[..., 0]], axis=-1)
    total = np.zeros(rows.max(initial=-1) + 1)
    for corner in range(3):
        inside = rows[:, corner] >= 0
        np.add.at(total, rows[inside, corner], area[inside])
    at, to = np.meshgrid(np.arange(3), np.arange(3), indexing="ij")
    i, j = rows[:, at.ravel()].ravel(), columns[:, to.ravel()].ravel()
    used = (i >= 0) & (j >= 0)
    made = []
    for axis in range(2):
        values = hats[:, to.ravel(), axis].ravel()[used] / total[i[used]]
        shape = (len(total), count)
        made.append(csr_array(coo_array((values.astype(np.float32), (i[used], j[used])), shape=shape)))
    return made[0], made[1]
