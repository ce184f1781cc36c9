"""Where times lie on the screen, and what is written along them.  Pure."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from facemodel.animation.timecode import TimeStyle, written

SPARSEST, DENSEST = 0.5, 12_000.0
"""Pixels per second: half an hour across a screen, and a frame of the fastest clip as wide as a hand."""

EARLIEST = -2.0
"""Seconds before the start of the clip that can still be seen."""

AIR = 28.0
"""Pixels on either side of what is brought into view: half a portrait of a key expression and a little more."""

TENTHS = (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
"""Steps between labels in seconds, below one."""

LABEL_ROOM = 84
"""Pixels that a label of the ruler needs."""


@dataclass(frozen=True)
class TimeScale:
    """A stretch of time on the screen.

    Attributes
    ----------
    begin : time at the left edge, seconds
    per_second : pixels
    """

    begin: float = -0.1
    per_second: float = 200.0

    def x(self, time: float) -> float:
        """Pixels from the left edge."""
        return (time - self.begin) * self.per_second

    def time(self, x: float) -> float:
        """The time under a pixel."""
        return self.begin + x / self.per_second

    def seconds(self, pixels: float) -> float:
        """How long some pixels are."""
        return pixels / self.per_second

    def end(self, width: float) -> float:
        """Time at the right edge of so many pixels."""
        return self.time(width)

    def zoomed(self, factor: float, x: float) -> TimeScale:
        """Nearer or farther by a factor; the time under a pixel stays there."""
        per_second = min(max(self.per_second * factor, SPARSEST), DENSEST)
        return replace(self, begin=self.time(x) - x / per_second, per_second=per_second).held()

    def panned(self, pixels: float) -> TimeScale:
        """Moved along by pixels; what is seen moves to the right."""
        return replace(self, begin=self.begin - pixels / self.per_second).held()

    def held(self) -> TimeScale:
        """The same, not too far before the start of time."""
        return replace(self, begin=max(self.begin, EARLIEST))


def fitted(start: float, end: float, width: float, margin: float = 0.04) -> TimeScale:
    """The scale that shows a stretch of time in so many pixels, with some air around it."""
    room = max(width - 2.0 * max(margin * width, AIR), 1.0)
    per_second = min(max(room / max(end - start, 1e-3), SPARSEST), DENSEST)
    return TimeScale((start + end) / 2.0 - width / per_second / 2.0, per_second).held()


@dataclass(frozen=True)
class Tick:
    """A line of the ruler: its time, and what is written at it if anything."""

    time: float
    label: str = ""


def ticks(scale: TimeScale, width: float, rate: float, style: TimeStyle) -> Iterator[Tick]:
    """The lines of the ruler from left to right, labelled where there is room."""
    step = tick_step(scale.seconds(LABEL_ROOM), rate, style)
    finer = step / _parts(step, rate, style)
    first, last = math.floor(scale.begin / finer), math.ceil(scale.end(width) / finer)
    every = round(step / finer)
    for number in range(max(first, 0), last + 1):
        time = number * finer
        yield Tick(time, written(time, rate, style) if number % every == 0 else "")


def tick_step(least: float, rate: float, style: TimeStyle = "timecode") -> float:
    """The shortest good step between labels of at least so many seconds: whole frames, or tenths and hundredths where
    seconds are written, then whole seconds.
    """
    frames = [count / rate for count in (1, 2, 5, 10, 15, 20) if count < rate]
    below = TENTHS if style == "seconds" else frames
    steps = [*below, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600]
    return next((step for step in steps if step >= least), 3600.0 * math.ceil(least / 3600.0))


def _parts(step: float, rate: float, style: TimeStyle) -> int:
    """Into how many the step between labels is divided."""
    if step < 1.0 and style == "seconds":
        return 5
    count = round(step * rate) if step < 1.0 else round(step)
    if step < 1.0:
        return 5 if count % 5 == 0 else max(count, 1) if count <= 4 else 1
    return {1: 2, 2: 2, 15: 3}.get(count, 5 if count % 5 == 0 else 2)
