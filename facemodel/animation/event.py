"""Events: an action unit comes and goes, described by the six temporal parameters of Yu, Garrod and Schyns (2012)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.animation.ease import least_jerk
from fem.types import FloatArray

BRISKEST = 50.0
"""The largest acceleration and deceleration: a rise that takes a fiftieth of its time is a jump."""

SHORTEST = 1e-3
"""Seconds that rise and fall take at least, so that no event jumps."""


@dataclass(frozen=True)
class Event:
    """One bump.  All latencies are seconds after its start, onset <= peak <= offset.

    Attributes
    ----------
    key : tells it from the other events of an animation
    channels : what it moves, all alike: both fields of a paired unit, or one
    start : seconds; when the expression that it belongs to begins
    onset : onset latency, when it sets out
    acceleration : how many times faster it rises than it has to: at 1 it arrives just at the peak, at 3 it takes a
        third of the time and stays
    amplitude : peak amplitude, weight or degrees
    peak : peak latency, when it is at its peak at the latest
    deceleration : how many times faster it falls than it has to: at 3 it stays for two thirds of the time
    offset : offset latency, when it is over
    group : events of one name were placed as one and are moved as one; empty for an event of its own
    muted : whether it is left out
    """

    key: str
    channels: tuple[str, ...]
    start: float
    onset: float = 0.0
    acceleration: float = 1.0
    amplitude: float = 1.0
    peak: float = 0.3
    deceleration: float = 1.0
    offset: float = 0.8
    group: str = ""
    muted: bool = False

    @property
    def begins(self) -> float:
        """When it sets out, seconds of the clip."""
        return self.start + self.onset

    @property
    def full(self) -> tuple[float, float]:
        """From when to when it is at its peak, seconds of the clip."""
        rise, fall = _durations(self)
        return self.begins + rise, max(self.begins + rise, self.ends - fall)

    @property
    def ends(self) -> float:
        """When it is over, seconds of the clip."""
        return self.start + _latencies(self)[2]


def _latencies(event: Event) -> tuple[float, float, float]:
    """Onset, peak and offset latency, with a little time between them in any case."""
    peak = max(event.peak, event.onset + SHORTEST)
    return event.onset, peak, max(event.offset, peak + SHORTEST)


def _durations(event: Event) -> tuple[float, float]:
    """Seconds that rise and fall take."""
    onset, peak, offset = _latencies(event)
    return (peak - onset) / event.acceleration, (offset - peak) / event.deceleration


def bump(event: Event, times: FloatArray) -> FloatArray:
    """What an event adds (T,) at times (T,)."""
    return Bumps([event]).at(times)[:, 0]


class Bumps:
    """Many events evaluated together.

    Parameters
    ----------
    events : (E,) of them
    """

    def __init__(self, events: Sequence[Event]) -> None:
        spans = [(event.begins, event.ends, *_durations(event)) for event in events]
        self._begin, self._end, self._rise, self._fall = np.array(spans, dtype=np.float64).reshape(-1, 4).T
        self._amplitude = np.array([event.amplitude for event in events], dtype=np.float64)

    def at(self, times: FloatArray) -> FloatArray:
        """Values (T, E) at times (T,): least jerk up, and down."""
        at = times[:, None]
        up = least_jerk((at - self._begin) / self._rise)
        return np.asarray(self._amplitude * np.minimum(up, least_jerk((self._end - at) / self._fall)))
