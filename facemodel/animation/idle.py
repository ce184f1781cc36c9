"""Idle life: blinks, small jumps of the eyes and breathing, the same for ever from one seed.

Only the standard library's generator is drawn from, whose numbers are the same in every version, and every kind of life
draws from one of its own: changing the rate of blinks leaves the eyes where they look.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from random import Random
from typing import Literal

import numpy as np

from facemodel.animation.curve import Curve, curve_through
from facemodel.animation.event import Event, bump
from facemodel.animation.keyed import KeyedCurves
from fem.types import FloatArray

LIDS = ("43L", "43R")

BLINK_SPREAD = 0.45
"""Standard deviation of the logarithm of the pauses between blinks; they are skewed like that (Bentivoglio 1997)."""

SHORTEST_PAUSE = 0.4
"""Seconds between two blinks at least."""

CLOSES_IN, OPENS_IN = 0.075, 0.18
"""Seconds in which a lid falls and rises again (Evinger 1991)."""

FIXATION = 0.9
"""Seconds for which eyes rest on average while somebody listens."""

SACCADE = 0.03
"""Seconds of a small jump of the eyes; small ones all take about as long."""

JUMP = 0.8
"""Degrees, standard deviation of where the eyes rest about straight ahead, upright half as much."""

FARTHEST_LOOK = 3.0
"""Degrees; farther off would be a glance at something."""

BREATH_PITCH, BREATH_RISE = 0.35, 0.8
"""Degrees and millimetres by which a head nods and rises with every breath at rest."""

BREATH_VARIES = 0.12
"""Standard deviation of the length of a breath, as a share."""


@dataclass(frozen=True)
class Idle:
    """A face that is not dead.

    Attributes
    ----------
    seed : which life
    blinks : per minute; 15 at rest
    saccades : size of the small jumps of the eyes, 1 as measured, 0 for a stare
    breathing : size of the head's motion with the breath, 1 as measured
    breaths : per minute; 14 at rest
    muted : whether it is left out
    """

    seed: int = 1
    blinks: float = 15.0
    saccades: float = 1.0
    breathing: float = 1.0
    breaths: float = 14.0
    muted: bool = False


Kind = Literal["blinks", "saccades", "breathing"]


def blink_events(idle: Idle, until: float) -> tuple[Event, ...]:
    """All blinks that begin between 0 and a time, seconds."""
    if idle.blinks <= 0:
        return ()
    draw = _draw(idle, "blinks")
    # The mean of a log-normal is exp(m + s^2 / 2).
    mean = math.log(60.0 / idle.blinks) - BLINK_SPREAD**2 / 2.0
    found: list[Event] = []
    time = 0.0
    while True:
        time += max(math.exp(mean + BLINK_SPREAD * _normal(draw)), SHORTEST_PAUSE)
        if time > until:
            return tuple(found)
        ends = CLOSES_IN + OPENS_IN
        found.append(Event(f"blink {len(found)}", LIDS, time, amplitude=1.0, peak=CLOSES_IN, offset=ends))


def idle_curves(idle: Idle, until: float) -> dict[str, Curve]:
    """What eyes and head do from 0 to a time, as curves by channel."""
    curves: dict[str, Curve] = {}
    if idle.saccades > 0:
        times, yaw, pitch = (np.array(column) for column in zip(*_looks(idle, until), strict=True))
        for eye in ("eyeL", "eyeR"):
            curves[f"{eye}.yaw"] = _jumping(times, yaw * idle.saccades)
            curves[f"{eye}.pitch"] = _jumping(times, pitch * idle.saccades)
    if idle.breathing > 0 and idle.breaths > 0:
        breath = _breaths(idle, until)
        level = (np.arange(len(breath)) % 2).astype(np.float64)
        curves["head.pitch"] = curve_through(breath, idle.breathing * BREATH_PITCH * level)
        curves["head.y"] = curve_through(breath, idle.breathing * BREATH_RISE * level)
    return curves


@lru_cache(maxsize=8)
def life_of(idle: Idle | None, until: float) -> Life:
    """Idle life as curves, made once as long as nothing of it changes."""
    return Life(idle, until)


class Life:
    """Idle life from 0 to a time; it is still before and behind.

    Attributes
    ----------
    channels : what it moves
    """

    def __init__(self, idle: Idle | None, until: float) -> None:
        lives = idle is not None and not idle.muted
        curves = idle_curves(idle, until) if idle is not None and lives else {}
        blinks = blink_events(idle, until) if idle is not None and lives else ()
        self._curves = KeyedCurves(list(curves.values()))
        self._blink = blinks[0] if blinks else None
        self._begins = np.array([event.begins for event in blinks])
        self.channels = (*curves, *(LIDS if blinks else ()))

    def at(self, times: FloatArray) -> FloatArray:
        """Values (T, C) at times (T,)."""
        moved = self._curves.at(times)
        if self._blink is None:
            return moved
        last = np.maximum(np.searchsorted(self._begins, times, side="right") - 1, 0)
        closed = bump(self._blink, self._blink.begins + times - self._begins[last])
        return np.column_stack([moved, closed, closed])


def _looks(idle: Idle, until: float) -> Iterator[tuple[float, float, float]]:
    """From when on the eyes rest where: seconds, degrees of yaw and pitch."""
    draw = _draw(idle, "saccades")
    time = 0.0
    yield time, 0.0, 0.0
    while time <= until:
        time += max(-FIXATION * math.log(1.0 - draw.random()), 4 * SACCADE)
        yaw, pitch = JUMP * _normal(draw), JUMP / 2.0 * _normal(draw)
        yield time, _within(yaw), _within(pitch)


def _jumping(times: FloatArray, values: FloatArray) -> Curve:
    """A curve that rests at each value until the next time, and jumps there within a saccade."""
    arrive = times[1:] + SACCADE
    at = np.concatenate([times[:1], np.stack([times[1:], arrive], axis=1).ravel()])
    to = np.concatenate([values[:1], np.stack([values[:-1], values[1:]], axis=1).ravel()])
    return curve_through(at, to)


def _breaths(idle: Idle, until: float) -> FloatArray:
    """Turning points, out and in by turns; breathing out takes longer."""
    draw = _draw(idle, "breathing")
    times = [0.0]
    while times[-1] <= until:
        length = 60.0 / idle.breaths * max(1.0 + BREATH_VARIES * _normal(draw), 0.3)
        times += [times[-1] + 0.4 * length, times[-1] + length]
    return np.array(times)


def _draw(idle: Idle, kind: Kind) -> Random:
    kinds: Mapping[Kind, int] = {"blinks": 1, "saccades": 2, "breathing": 3}
    return Random(idle.seed * 8 + kinds[kind])


def _normal(draw: Random) -> float:
    """A standard normal number by Box and Muller: `Random.gauss` may change, `Random.random` never does."""
    radius = math.sqrt(-2.0 * math.log(1.0 - draw.random()))
    return radius * math.cos(2.0 * math.pi * draw.random())


def _within(degrees: float) -> float:
    return min(max(degrees, -FARTHEST_LOOK), FARTHEST_LOOK)
