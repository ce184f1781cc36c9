"""The fewest shapes that tell a set of displacements apart, by principal components."""

from __future__ import annotations

import numpy as np

from fem.types import Float32Array, FloatArray

INDEPENDENT = 1e-6
"""Share of the largest singular value below which a component is rounding of float32."""


def fewest_shapes(moved: Float32Array, within: float, most: int) -> tuple[Float32Array, Float32Array]:
    """A mean (3 Q,) and shapes (K, 3 Q) whose weighted sums come near every row of displacements (T, 3 Q).

    The shapes are the leading principal components: no other K have a smaller sum of squared errors.  Where all rows
    are near nothing already, there are no shapes and the mean is nothing.

    Parameters
    ----------
    moved : millimetres
    within : the largest distance of a point, millimetres, at which no more shapes are needed
    most : K at most
    """
    mean = moved.mean(axis=0) if farthest(moved) > within and most > 0 else np.zeros_like(moved[0])
    rest = moved - mean
    left, sizes, right = np.linalg.svd(rest, full_matrices=False)
    known = min(most, int((sizes > INDEPENDENT * sizes.max(initial=0.0)).sum()))
    count = 0
    while count < known and farthest(rest) > within:
        rest -= np.outer(sizes[count] * left[:, count], right[count])
        count += 1
    # Either sign would do; one is chosen, so that every machine writes the same file.
    largest = np.take_along_axis(left, np.abs(left).argmax(axis=0)[None], axis=0)[0, :count]
    return mean, right[:count] * np.sign(largest)[:, None]


def fitted(shapes: Float32Array, moved: Float32Array) -> FloatArray:
    """Weights (K,) with which shapes (K, 3 Q), each at right angles to all others, come nearest to (3 Q,)."""
    squares = np.einsum("kq,kq->k", shapes, shapes)
    return np.asarray((shapes @ moved) / squares, dtype=np.float64)


def from_nothing_to_one(
    mean: Float32Array, shapes: Float32Array, weights: FloatArray
) -> tuple[Float32Array, Float32Array, FloatArray]:
    """Other shapes that say the same with weights from 0 to 1 only, which is all that some programs take.

    Parameters
    ----------
    mean : (3 Q,) added to every sum
    shapes : (K, 3 Q)
    weights : (T, K) of any size

    Returns
    -------
    The mean, shapes and weights that take their place.
    """
    low, high = weights.min(axis=0, initial=0.0), weights.max(axis=0, initial=0.0)
    span = np.where(high > low, high - low, 1.0)
    base = mean + low.astype(np.float32) @ shapes if len(shapes) else mean
    return base, shapes * span.astype(np.float32)[:, None], (weights - low) / span


def farthest(moved: Float32Array) -> float:
    """The longest displacement of any point in an array of them (..., 3 Q), millimetres."""
    points = moved.reshape(-1, 3)
    return float(np.sqrt(np.einsum("ij,ij->i", points, points).max(initial=0.0)))
