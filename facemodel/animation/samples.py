"""A dense curve as it was captured: one value for every frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from fem.types import Float32Array, FloatArray, IntArray

ON_SAMPLE = 1e-6
"""Of a frame: a time that was computed from a frame's number gives its very value back."""


@dataclass(frozen=True, eq=False)
class Samples:
    """Values at even steps of time; straight between them, and still before the first and behind the last.

    Attributes
    ----------
    values : (N,) float32
    rate : samples per second
    start : time of the first, seconds
    """

    values: Float32Array
    rate: float
    start: float = 0.0

    @property
    def end(self) -> float:
        """Time of the last sample."""
        return self.start + max(len(self.values) - 1, 0) / self.rate

    @property
    def times(self) -> FloatArray:
        """(N,) seconds."""
        return self.start + np.arange(len(self.values)) / self.rate

    def at(self, times: FloatArray) -> FloatArray:
        """Values (T,) at times (T,)."""
        if not len(self.values):
            return np.zeros(len(times))
        left, right, share = self.between(times)
        before = self.values[left].astype(np.float64)
        return np.asarray(before + share * (self.values[right] - before))

    def between(self, times: FloatArray) -> tuple[IntArray, IntArray, FloatArray]:
        """The samples (T,) before and after each time, and the share of the way between them; it needs one sample."""
        last = len(self.values) - 1
        place = np.clip((times - self.start) * self.rate, 0.0, last)
        nearest = np.rint(place)
        place = np.where(np.abs(place - nearest) < ON_SAMPLE, nearest, place)
        left = np.minimum(place.astype(np.int64), max(last - 1, 0))
        return left, np.minimum(left + 1, last), place - left
