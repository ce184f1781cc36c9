"""Weights of the fields that explain how some points moved: bounded least squares, all frames at once.

Of each frame, min over 0 <= x <= u of  |W (D x - d)|^2 + sum_j p_j^2 (r x_j^2 + 2 c x_j)

D (3 K, M) are the fields at the points, d (3 K,) how far these moved, W how much each is trusted, p_j the largest
motion of a field anywhere.  r and c let a field that moves much for little that was seen of it stay at rest, and of
two that explain the same the one that does it with less.
"""

from __future__ import annotations

import numpy as np

from fem.types import FloatArray

RIDGE = 2e-2
"""Square of how many millimetres at the points are worth one of the largest motion, of trusted points."""

SPARSE = 5e-2
"""The same at a weight near none: trembling of the points below it wakes no field."""

SWEEPS = 400
"""Each makes the error smaller; so many that the last no longer move a weight by what `SETTLED` says."""

SETTLED = 1e-5
"""A weight that moves by less in a sweep has settled: nothing that is drawn tells it from the next."""


def fitted_weights(
    fields: FloatArray, moved: FloatArray, trust: FloatArray, peaks: FloatArray, high: FloatArray
) -> FloatArray:
    """The weights (N, M) of each frame.

    Parameters
    ----------
    fields : (M, K, 3) at weight 1, millimetres
    moved : (N, K, 3) how far the points moved, millimetres
    trust : (K, 3) weights of the squares
    peaks : (M,) largest motion of each field, millimetres
    high : (M,) largest weight of each field
    """
    rows = fields.reshape(len(fields), -1)
    gram = (rows * trust.ravel()) @ rows.T
    gram[np.diag_indices_from(gram)] += RIDGE * peaks**2
    wanted = (rows * trust.ravel()) @ moved.reshape(len(moved), -1).T - SPARSE * peaks[:, None] ** 2
    found = np.zeros_like(wanted)
    for _ in range(SWEEPS):
        before = found.copy()
        for j in range(len(gram)):
            step = (wanted[j] - gram[j] @ found) / gram[j, j]
            np.clip(found[j] + step, 0.0, high[j], out=found[j])
        if np.abs(found - before).max(initial=0.0) < SETTLED:
            break
    return found.T
