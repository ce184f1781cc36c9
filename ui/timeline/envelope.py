"""Lowest and highest of many samples, pixel by pixel, in the time of a few: a pyramid of extremes."""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np

from facemodel.animation.samples import Samples
from fem.types import Float32Array, FloatArray

FOLD = 4
"""Samples of one level that make one of the next."""


class Envelope:
    """Extremes of samples (N,) at any density.

    Parameters
    ----------
    values : what is looked at; it is not copied
    """

    def __init__(self, values: Float32Array) -> None:
        self._levels: list[tuple[Float32Array, Float32Array]] = [(values, values)]
        low = high = values
        while len(low) > FOLD:
            whole = -(-len(low) // FOLD) * FOLD
            low = np.pad(low, (0, whole - len(low)), mode="edge").reshape(-1, FOLD).min(axis=1)
            high = np.pad(high, (0, whole - len(high)), mode="edge").reshape(-1, FOLD).max(axis=1)
            self._levels.append((low, high))

    def between(self, edges: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Lowest and highest (n,) from each edge to the next, places (n + 1,) of samples in order, not whole.

        Each stretch holds at least the sample nearest to it; outside of all samples it is the first or last one.
        """
        stretch = float(edges[-1] - edges[0]) / max(len(edges) - 1, 1)
        level = int(np.clip(np.floor(np.log(max(stretch, 1.0)) / np.log(FOLD)), 0, len(self._levels) - 1))
        low, high = self._levels[level]
        size = FOLD**level
        begin = np.clip(np.floor(edges[:-1] / size).astype(np.int64), 0, len(low) - 1)
        stop = np.clip(np.ceil(edges[1:] / size).astype(np.int64), begin + 1, len(low))
        lowest, highest = low[begin].astype(np.float64), high[begin].astype(np.float64)
        for step in range(1, int((stop - begin).max())):
            at = np.minimum(begin + step, stop - 1)
            lowest, highest = np.minimum(lowest, low[at]), np.maximum(highest, high[at])
        return lowest, highest


_known: WeakKeyDictionary[Samples, Envelope] = WeakKeyDictionary()


def envelope(samples: Samples) -> Envelope:
    """The envelope of captured samples; made once for each."""
    found = _known.get(samples)
    if found is None:
        found = _known[samples] = Envelope(samples.values)
    return found
