"""Slopes at the vertices of a field that is known there alone, by a local fit in the chart."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array, eye_array

from fem.types import FloatArray, IntArray

LEAST_SHARE = 1e-8
"""Singular values of a fit below this share of the largest are taken for zero: neighbours that lie in one line tell
nothing of the slope across it."""


def vertex_slopes(chart: FloatArray, triangles: IntArray) -> tuple[csr_array, csr_array]:
    """Operators (N, N) from values at the vertices to d/du and d/dv there.

    At every vertex a quadric through its own value is fitted to the values two edges around, nearer ones counting
    more: of a field that is quadratic in the chart the slopes are exact.

    Parameters
    ----------
    chart : (N, 2) place (u, v) of the vertices
    triangles : (T, 3)
    """
    count = len(chart)
    one, other = _pairs(triangles, count)
    away = chart[other] - chart[one]
    squared = np.einsum("ij,ij->i", away, away)
    size = np.sqrt(np.bincount(one, squared, count) / np.maximum(np.bincount(one, minlength=count), 1))
    u, v = (away / size[one, None]).T
    terms = np.stack([u, v, u * u / 2, u * v, v * v / 2], axis=1)
    weight = 1 / (squared / size[one] ** 2)
    normal = np.zeros((count, 5, 5))
    np.add.at(normal, one, weight[:, None, None] * terms[:, :, None] * terms[:, None, :])
    inverse = np.linalg.pinv(normal, rcond=LEAST_SHARE, hermitian=True)
    share = np.einsum("pkl,pl->pk", inverse[one, :2], terms) * (weight / size[one])[:, None]
    return _operator(one, other, share[:, 0], count), _operator(one, other, share[:, 1], count)


def _pairs(triangles: IntArray, count: int) -> tuple[IntArray, IntArray]:
    """Every vertex with each of those up to two edges away."""
    i, j = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2).T
    near = csr_array((np.ones(2 * len(i)), (np.concatenate([i, j]), np.concatenate([j, i]))), (count, count))
    near = csr_array(near + eye_array(count))
    around = csr_array(near @ near).tocoo()
    apart = around.row != around.col
    return around.row[apart].astype(np.int64), around.col[apart].astype(np.int64)


def _operator(one: IntArray, other: IntArray, share: FloatArray, count: int) -> csr_array:
    own = -np.bincount(one, share, count)
    rows, columns = np.concatenate([one, np.arange(count)]), np.concatenate([other, np.arange(count)])
    return csr_array((np.concatenate([share, own]), (rows, columns)), (count, count))
