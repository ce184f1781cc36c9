"""Weights of the fields that explain how some points moved: bounded least squares, all frames at once.

Of each frame, min over 0 <= x <= u of  |W (D x - d)|^2 + sum_j p_j^2 (r x_j^2 + 2 c x_j)

D (3 K, M) are the fields at the points, d (3 K,) how far these moved, W how much each is trusted, p_j the largest
motion of a field anywhere.  r and c let a field that moves much for little that was seen of it stay at rest, and of
two that explain the same the one that does it with less.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fem.types import FloatArray

RIDGE = 2e-2
"""Square of how many millimetres at the points are worth one of the largest motion, of trusted points."""

SPARSE = 5e-2
"""The same at a weight near none: trembling of the points below it wakes no field."""

SWEEPS = 400
"""Of a sweep each makes the error smaller; so many at most, which none but the strangest frames need."""

SETTLED = 1e-4
"""A weight that moves by less in a sweep has settled: the largest field then moves by a few thousandths of a mm."""

BLOCK = 256
"""Frames that are worked on together: their weights stay in the processor's cache."""


@dataclass(frozen=True, eq=False)
class Fitter:
    """Fits the same fields to many frames.

    Attributes
    ----------
    fields : (M, K, 3) at weight 1, millimetres
    trust : (K, 3) weights of the squares
    peaks : (M,) largest motion of each field, millimetres
    high : (M,) largest weight of each field
    """

    fields: FloatArray
    trust: FloatArray
    peaks: FloatArray
    high: FloatArray

    def weights(self, moved: FloatArray, guess: FloatArray) -> FloatArray:
        """The weights (N, M) of frames whose points moved by (N, K, 3) millimetres, from a guess (N, M) on."""
        rows = (self.fields * self.trust).reshape(len(self.fields), -1)
        wanted = rows @ moved.reshape(len(moved), -1).T - SPARSE * self.peaks[:, None] ** 2
        found = guess.T.copy()
        for start in range(0, len(moved), BLOCK):
            block = slice(start, start + BLOCK)
            found[:, block] = self._settled(wanted[:, block], found[:, block])
        return found.T

    @cached_property
    def _gram(self) -> FloatArray:
        """Left side (M, M) of the normal equations."""
        rows = self.fields.reshape(len(self.fields), -1)
        gram = (rows * self.trust.ravel()) @ rows.T
        gram[np.diag_indices_from(gram)] += RIDGE * self.peaks**2
        return np.asarray(gram)

    def _settled(self, wanted: FloatArray, guess: FloatArray) -> FloatArray:
        """Weights (M, n) for right sides (M, n): one after the other to its best, as often as it takes."""
        found = np.ascontiguousarray(guess)
        for _ in range(SWEEPS):
            largest = 0.0
            for j, row in enumerate(self._gram):
                best = np.clip(found[j] + (wanted[j] - row @ found) / row[j], 0.0, self.high[j])
                largest = max(largest, float(np.abs(best - found[j]).max(initial=0.0)))
                found[j] = best
            if largest < SETTLED:
                break
        return found
