"""Many curves of keys evaluated together."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from facemodel.animation.curve import Curve
from facemodel.animation.segments import joined, segments
from fem.types import FloatArray, IntArray

FEW_TIMES = 4
"""Up to so many times, all keys are compared with each of them at once; more are sought curve by curve."""


class KeyedCurves:
    """Some curves with at least one key each, laid one behind the other so that one time costs a few array operations.

    Parameters
    ----------
    curves : (C,) of them
    """

    def __init__(self, curves: Sequence[Curve]) -> None:
        self._curves = tuple(curves)
        counts = np.array([len(curve) for curve in self._curves], dtype=np.int64)
        # A curve of K keys has K + 1 pieces.
        self._first_key = np.concatenate([[0], np.cumsum(counts)[:-1]]).astype(np.int64)
        self._first_piece = self._first_key + np.arange(len(counts))
        if self._curves:
            self._keys = np.concatenate([curve.times for curve in self._curves])
            self._pieces = joined([segments(curve) for curve in self._curves])

    def at(self, times: FloatArray) -> FloatArray:
        """Values (T, C) at times (T,)."""
        if not self._curves or not len(times):
            return np.zeros((len(times), len(self._curves)))
        pieces = self._passed(times) + self._first_piece
        return self._pieces.values(pieces, times[:, None])

    def _passed(self, times: FloatArray) -> IntArray:
        """How many keys of every curve lie at or before each time, (T, C)."""
        if len(times) <= FEW_TIMES:
            rows = [np.add.reduceat(self._keys <= time, self._first_key, dtype=np.int64) for time in times.tolist()]
            return np.array(rows, dtype=np.int64).reshape(len(times), -1)
        found = [np.searchsorted(curve.times, times, side="right") for curve in self._curves]
        return np.stack(found, axis=1).astype(np.int64)


def values_of(curve: Curve, times: FloatArray) -> FloatArray:
    """Values (T,) of one curve at times (T,); without keys it is worth nothing."""
    return KeyedCurves([curve]).at(times)[:, 0] if len(curve) else np.zeros(len(times))
