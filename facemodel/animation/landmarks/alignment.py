"""Head motion out: similarity transforms that lay the points of every frame on those of a face at rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from fem.types import FloatArray

SMALLEST = 1e-12
"""Mean square spread of points, in their unit, below which they are one point and no face."""


@dataclass(frozen=True, eq=False)
class Similarity:
    """Of every frame: ``scale * turn @ p + shift``.

    Attributes
    ----------
    turn : (N, 3, 3) rotations
    scale : (N,)
    shift : (N, 3)
    """

    turn: FloatArray
    scale: FloatArray
    shift: FloatArray

    def of(self, points: FloatArray) -> FloatArray:
        """Points (N, K, 3) moved, each frame by its own."""
        moved = points @ np.swapaxes(self.turn, 1, 2)
        return np.asarray(self.scale[:, None, None] * moved + self.shift[:, None, :])


def similarity(points: FloatArray, targets: FloatArray, weights: FloatArray) -> Similarity:
    """The similarities that lay points (N, K, 3) nearest to targets (N or 1, K, 3) in weighted least squares.

    Umeyama 1991, "Least-squares estimation of transformation parameters between two point patterns", eqs. 40 to 42,
    with weights (K,).
    """
    share = weights / weights.sum()
    middle, goal = np.einsum("k,nkc->nc", share, points), np.einsum("k,nkc->nc", share, targets)
    from_middle, from_goal = points - middle[:, None], targets - goal[:, None]
    covariance = np.einsum("k,nki,nkj->nij", share, np.broadcast_to(from_goal, points.shape), from_middle)
    u, sizes, v = np.linalg.svd(covariance)
    signs = np.ones_like(sizes)
    # A mirror image is no motion of a head.
    signs[:, 2] = np.sign(np.linalg.det(u) * np.linalg.det(v))
    turn = u * signs[:, None, :] @ v
    spread = np.einsum("k,nkc->n", share, from_middle**2)
    scale = (sizes * signs).sum(axis=1) / np.maximum(spread, SMALLEST)
    shift = goal - scale[:, None] * np.einsum("nij,nj->ni", turn, middle)
    return Similarity(turn, scale, shift)
