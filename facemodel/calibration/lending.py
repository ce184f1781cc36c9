"""Take values from one skin to another that lies on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array, diags_array
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu

from facemodel.laying.places import nearest
from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray, IntArray

NEAR = 2.5
"""Millimetres between two skins within which they are the same."""

SAME_WAY = 0.3
"""Least cosine between their normals: across the slit of the mouth they look against each other."""


@dataclass(frozen=True, eq=False)
class Lent:
    """Which place of a skin lends its values to every vertex of another one.

    Attributes
    ----------
    skin : n vertices that borrow
    corners, share : (n, 3) vertices of the lender and their weights
    away : (n,) millimetres between both skins
    believed : (n,) where both are the same; elsewhere values are spread over the skin from there
    """

    skin: Mesh
    corners: IntArray
    share: FloatArray
    away: FloatArray
    believed: BoolArray

    @classmethod
    def between(cls, lender: Mesh, skin: Mesh) -> Lent:
        """Every vertex of a skin borrows from the nearest place of the lender."""
        places, triangle, away = nearest(lender, skin.positions)
        normals = lender.triangle_normals[triangle]
        normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        agree = np.einsum("ij,ij->i", normals, skin.normals) > SAME_WAY
        corners = lender.triangles[triangle]
        share = _barycentric(lender.positions[corners], places)
        return cls(skin, corners, share, away, agree & (away < NEAR))

    @property
    def vertex(self) -> IntArray:
        """The vertex (n,) of the lender that lies nearest."""
        return np.asarray(self.corners[np.arange(len(self.corners)), self.share.argmax(axis=1)])

    def values(self, lent: FloatArray) -> FloatArray:
        """Values (N, ...) of the lender on the skin that borrows, (n, ...)."""
        flat = lent.reshape(len(lent), -1)
        found = np.einsum("nk,nkc->nc", self.share, flat[self.corners])
        return np.asarray(_spread(self.skin, found, self.believed)).reshape(len(found), *lent.shape[1:])


def _spread(skin: Mesh, values: FloatArray, known: BoolArray) -> FloatArray:
    """Values (n, c) with those not known made harmonic on the graph of the skin between those that are."""
    if known.all() or not known.any():
        return values
    degree = np.asarray(skin.adjacency.sum(axis=1)).ravel()
    # A trace of the value found keeps pieces of the skin definite that no known vertex touches.
    laplacian = csr_array(diags_array(degree + TRACE) - skin.adjacency)
    rest = ~known
    right = TRACE * values[rest] - laplacian[rest][:, known] @ values[known]
    filled = values.copy()
    filled[rest] = splu(laplacian[rest][:, rest].tocsc()).solve(right)
    return filled


TRACE = 1e-6
"""Weight of what was found against what is spread."""


def _barycentric(corners: FloatArray, points: FloatArray) -> FloatArray:
    """Barycentric coordinates (n, 3) of points (n, 3) in triangles (n, 3, 3), clipped into them."""
    e, f, d = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0], points - corners[:, 0]
    ee, ef, ff, de, df = (np.einsum("ij,ij->i", x, y) for x, y in ((e, e), (e, f), (f, f), (d, e), (d, f)))
    area = np.maximum(ee * ff - ef**2, 1e-12)
    second, third = (ff * de - ef * df) / area, (ee * df - ef * de) / area
    share = np.clip(np.stack([1 - second - third, second, third], axis=1), 0.0, 1.0)
    return np.asarray(share / share.sum(axis=1, keepdims=True))


def largest_piece(triangles: IntArray, chosen: BoolArray) -> BoolArray:
    """The largest part of the chosen triangles (T,) that hangs together by edges."""
    own = np.flatnonzero(chosen)
    if not len(own):
        return chosen
    edges = np.sort(triangles[own][:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, edge = np.unique(edges, axis=0, return_inverse=True)
    by_edge = csr_array((np.ones(len(edges)), (np.repeat(np.arange(len(own)), 3), np.ravel(edge))))
    piece = connected_components(by_edge @ by_edge.T, directed=False)[1]
    kept = np.zeros_like(chosen)
    kept[own[piece == np.bincount(piece).argmax()]] = True
    return kept
