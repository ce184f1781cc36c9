"""The range of a number on a bar: where it lies, what a drag or a key makes of it, how it is written.  Pure."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from PySide6.QtCore import Qt

from ui.widgets.weight_gestures import FINE, THRESHOLD

FIGURES = 3
"""Figures of the largest value that are shown; more cannot be told apart on a bar."""

STEPS = 50
"""Arrow steps across a bar; PageUp and PageDown go four of them, Shift a fifth."""

Key = Qt.Key
Modifier = Qt.KeyboardModifier


@dataclass(frozen=True)
class NumberScale:
    """A range with a unit.

    Attributes
    ----------
    least, most : its ends
    default : what a reset goes to
    unit : written after the number; nothing for a pure one
    whole : whether it counts something
    bend : exponent from the place on the bar to the value; more than 1 gives small values more room
    """

    least: float
    most: float
    default: float
    unit: str = ""
    whole: bool = False
    bend: float = 1.0

    @property
    def decimals(self) -> int:
        """Decimals that are shown."""
        size = max(abs(self.least), abs(self.most), 1e-9)
        return 0 if self.whole else max(1, FIGURES - math.ceil(math.log10(size)))

    def share(self, value: float) -> float:
        """The place of a value on the bar, 0 to 1."""
        if self.most <= self.least:
            return 0.0
        return float((self.clamped(value) - self.least) / (self.most - self.least)) ** (1 / self.bend)

    def value(self, share: float) -> float:
        """The value at a place of the bar."""
        return self.least + (self.most - self.least) * min(max(share, 0.0), 1.0) ** self.bend

    def clamped(self, value: float) -> float:
        """The nearest value within the range."""
        return min(max(value, self.least), self.most)

    def rounded(self, value: float, finer: int = 0) -> float:
        """A value within the range, as exact as it is shown, or by some decimals finer."""
        return self.clamped(round(value, self.decimals + (0 if self.whole else finer)))

    def text(self, value: float) -> str:
        """The number with its unit."""
        space = "" if self.unit in ("", "°") else " "
        # The sum turns what would be written “-0.00” into zero.
        return f"{round(value, self.decimals) + 0.0:.{self.decimals}f}{space}{self.unit}"

    def stepped(self, value: float, key: int, modifiers: Modifier) -> float | None:
        """The value that a key asks for; none where it asks for none."""
        fine = bool(modifiers & Modifier.ShiftModifier)
        step = 1 / STEPS * (0.2 if fine else 1.0)
        least_step = 1.0 if self.whole else 10.0**-self.decimals
        ways = {
            Key.Key_Right: 1,
            Key.Key_Up: 1,
            Key.Key_Left: -1,
            Key.Key_Down: -1,
            Key.Key_PageUp: 4,
            Key.Key_PageDown: -4,
        }
        if key in (Key.Key_Home, Key.Key_End):
            return self.least if key == Key.Key_Home else self.most
        if key not in ways:
            return None
        way = ways[Key(key)]
        target = self.value(self.share(value) + way * step)
        if abs(target - value) < least_step:
            target = value + math.copysign(least_step, way)
        return self.rounded(target)


@dataclass(frozen=True)
class NumberDrag:
    """A press on a bar that may have become a drag.

    Attributes
    ----------
    x : where the pointer was last, pixels
    start : value when it began, which Esc restores
    reached : place on the bar now, not rounded, so that fine movements add up
    moving : whether the pointer has left the threshold
    fine : whether Shift was held at the last movement
    """

    x: float
    start: float
    reached: float
    moving: bool = False
    fine: bool = False

    def moved(self, x: float, width: float, modifiers: Modifier) -> NumberDrag:
        """The drag after the pointer went to ``x`` on a bar of ``width`` pixels."""
        if not self.moving and abs(x - self.x) < THRESHOLD:
            return self
        fine = bool(modifiers & Modifier.ShiftModifier)
        step = (FINE if fine else 1.0) * (x - self.x) / max(1.0, width)
        return replace(self, x=x, reached=min(max(self.reached + step, 0.0), 1.0), moving=True, fine=fine)
