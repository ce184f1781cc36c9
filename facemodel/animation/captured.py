"""Many captured curves evaluated together, each bent by its layers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from weakref import WeakKeyDictionary

import numpy as np

from facemodel.animation.displacement import Spline, Splines, spline_through
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track
from fem.types import FloatArray

Grid = tuple[float, float, int]
"""Rate, start and count of samples: curves of one capture share it."""

_known: WeakKeyDictionary[Track, Spline] = WeakKeyDictionary()


def displaced(track: Track, times: FloatArray) -> FloatArray:
    """The captured curve of a track with all its layers (T,) at times (T,)."""
    return CapturedCurves([track]).at(times)[:, 0]


def displacement(track: Track) -> Spline:
    """What all layers of a track add to its captured curve, each made over those below it; made once for each track."""
    found = _known.get(track)
    if found is None:
        found = _known[track] = _displacement(track)
    return found


def _displacement(track: Track) -> Spline:
    whole: Spline = ()
    for layer in track.layers:
        if layer.active and track.captured is not None:
            times = layer.keys.times
            stands = track.captured.at(times) + Splines([whole]).at(times)[:, 0]
            spline = spline_through(times, layer.keys.values - stands, layer.spacing)
            whole += tuple(replace(piece, coefficients=layer.weight * piece.coefficients) for piece in spline)
    return whole


class CapturedCurves:
    """Some tracks with captured curves.

    Parameters
    ----------
    tracks : (C,) of them
    """

    def __init__(self, tracks: Sequence[Track]) -> None:
        self._count = len(tracks)
        grids: dict[Grid, list[tuple[int, Samples]]] = {}
        for row, track in enumerate(tracks):
            samples = track.captured
            assert samples is not None
            grids.setdefault((samples.rate, samples.start, len(samples.values)), []).append((row, samples))
        self._grids = [(np.array([row for row, _ in each]), [s for _, s in each]) for each in grids.values()]
        self._bent = Splines([displacement(track) for track in tracks])

    def at(self, times: FloatArray) -> FloatArray:
        """Values (T, C) at times (T,)."""
        found = self._bent.at(times)
        for rows, samples in self._grids:
            found[:, rows] += _together(samples, times)
        return found


def _together(samples: Sequence[Samples], times: FloatArray) -> FloatArray:
    """Values (T, n) of samples on one grid; it does what `Samples.at` does, and looks for the place once."""
    if not len(samples[0].values):
        return np.zeros((len(times), len(samples)))
    left, right, share = samples[0].between(times)
    before = np.stack([each.values[left] for each in samples], axis=1).astype(np.float64)
    after = np.stack([each.values[right] for each in samples], axis=1)
    return before + share[:, None] * (after - before)
