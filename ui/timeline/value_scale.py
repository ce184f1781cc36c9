"""Where values lie on the graph.  Pure."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

FLATTEST, STEEPEST = 0.5, 20_000.0
"""Pixels per unit of value: two hundred millimetres on a screen, and a thousandth of a weight as wide as a hand."""

LINE_ROOM = 34
"""Pixels between two labelled lines at least."""


@dataclass(frozen=True)
class ValueScale:
    """A range of values on the screen, upwards.

    Attributes
    ----------
    top : value at the upper edge
    per_unit : pixels
    """

    top: float = 1.1
    per_unit: float = 150.0

    def y(self, value: float) -> float:
        """Pixels from the upper edge."""
        return (self.top - value) * self.per_unit

    def value(self, y: float) -> float:
        """The value at a pixel."""
        return self.top - y / self.per_unit

    def zoomed(self, factor: float, y: float) -> ValueScale:
        """Steeper or flatter; the value under a pixel stays there."""
        per_unit = min(max(self.per_unit * factor, FLATTEST), STEEPEST)
        return ValueScale(self.value(y) + y / per_unit, per_unit)

    def panned(self, pixels: float) -> ValueScale:
        """Moved along by pixels; what is seen moves down."""
        return replace(self, top=self.top + pixels / self.per_unit)

    def lines(self, height: float) -> Iterator[float]:
        """Values at which there is a line."""
        step = value_step(LINE_ROOM / self.per_unit)
        first, last = math.ceil(self.value(height) / step), math.floor(self.top / step)
        yield from (number * step for number in range(first, last + 1))


def fitted_values(low: float, high: float, height: float, margin: float = 0.12) -> ValueScale:
    """The scale that shows a range of values in so many pixels, with some air around it."""
    room = max(high - low, 1e-3) * (1.0 + 2.0 * margin)
    per_unit = min(max(height / room, FLATTEST), STEEPEST)
    return ValueScale((low + high) / 2.0 + height / per_unit / 2.0, per_unit)


def value_step(least: float) -> float:
    """The smallest of 1, 2 and 5 times a power of ten that is no less."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(step * power for step in (1.0, 2.0, 5.0, 10.0) if step * power >= least * (1.0 - 1e-9))
