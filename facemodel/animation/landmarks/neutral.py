"""Which frame of a performance shows the face at rest."""

from __future__ import annotations

from fem.types import FloatArray

BEGINNING = 1.0
"""Seconds at the start among which the calmest moment is looked for: who is recorded begins at rest."""

MOMENT = 0.2
"""Seconds that count as one moment; their mean is calmer than any single frame of a trembling tracker."""


def moment_at(time: float, rate: float, count: int) -> slice:
    """The frames of the moment about a time, as many as there are."""
    half = max(round(MOMENT * rate / 2), 0)
    middle = min(max(round(time * rate), 0), count - 1)
    return slice(max(middle - half, 0), min(middle + half + 1, count))


def calmest(points: FloatArray, rate: float) -> slice:
    """The frames of the calmest moment at the start.

    Parameters
    ----------
    points : (N, K, 3) without head motion
    rate : frames per second
    """
    count = len(points)
    last = min(round(BEGINNING * rate), count - 1)
    moments = [moment_at(frame / rate, rate, count) for frame in range(last + 1)]
    whole = max(moment.stop - moment.start for moment in moments)
    full = [moment for moment in moments if moment.stop - moment.start == whole]
    return min(full, key=lambda moment: float(points[moment].var(axis=0).sum()))
