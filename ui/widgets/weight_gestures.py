"""What a drag or a key makes of a weight: pure functions, so that the widget only forwards events."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from PySide6.QtCore import Qt

from app.arithmetic import evaluate
from app.weights import LARGEST_WEIGHT

FULL = 1.0
"""Full contraction; the bar is full."""

FINE = 0.1
"""What Shift makes of a drag."""

STEP = 0.05
"""What an arrow key adds; PageUp and PageDown add four of them, Shift makes it 0.01."""

FINE_STEP = 0.01

THRESHOLD = 3.0
"""Pixels that the pointer travels before a press becomes a drag, so that a click changes nothing."""

Modifier = Qt.KeyboardModifier
Key = Qt.Key


def _no_letter(_weight: float) -> str:
    return ""


@dataclass(frozen=True)
class WeightScale:
    """How far a bar goes, and how its weight is told and typed.

    Attributes
    ----------
    limit : the largest weight
    letter : the intensity of a weight; empty where there is none
    read : the weight that is meant by a typed text; raises `NumberError` if none is
    """

    limit: float = LARGEST_WEIGHT
    letter: Callable[[float], str] = _no_letter
    read: Callable[[str], float] = evaluate

    @property
    def full(self) -> float:
        """The weight at the end of the bar: full contraction, or the limit of what has one of its own."""
        return FULL if self.limit >= LARGEST_WEIGHT else self.limit

    def end(self, modifiers: Modifier, start: float) -> float:
        """Where a gesture ends: past the bar with Ctrl, or where the weight already is."""
        return self.limit if modifiers & Modifier.ControlModifier else min(max(self.full, start), LARGEST_WEIGHT)

    def text(self, weight: float) -> str:
        """The weight with its letter."""
        letter = self.letter(weight)
        return f"{letter} {weight:.2f}" if letter else f"{weight:.2f}"


USUAL = WeightScale()


@dataclass(frozen=True)
class Drag:
    """A press that may have become a drag.

    Attributes
    ----------
    x : where the pointer was last, pixels
    start : weights (left, right) when it began, which Esc restores
    reached : the weight now, not rounded, so that fine movements add up
    moving : whether the pointer has left the threshold
    fine : whether Shift was held at the last movement
    """

    x: float
    start: tuple[float, float]
    reached: float
    moving: bool = False
    fine: bool = False

    @property
    def weight(self) -> float:
        """The weight now, rounded as finely as the hand was."""
        return round(self.reached, 3 if self.fine else 2)


def dragged(drag: Drag, x: float, width: float, modifiers: Modifier, scale: WeightScale = USUAL) -> Drag:
    """The drag after the pointer moved to ``x`` on a bar of ``width`` pixels."""
    if not drag.moving and abs(x - drag.x) < THRESHOLD:
        return drag
    fine = bool(modifiers & Modifier.ShiftModifier)
    step = (FINE if fine else 1.0) * scale.full * (x - drag.x) / max(1.0, width)
    reached = min(max(drag.reached + step, 0.0), scale.end(modifiers, max(drag.start)))
    return replace(drag, x=x, reached=reached, moving=True, fine=fine)


def stepped(weight: float, key: int, modifiers: Modifier, scale: WeightScale = USUAL) -> float | None:
    """The weight that a key asks for, or None where it asks for none."""
    step = FINE_STEP if modifiers & Modifier.ShiftModifier else STEP
    targets = {
        Key.Key_Right: weight + step,
        Key.Key_Up: weight + step,
        Key.Key_Left: weight - step,
        Key.Key_Down: weight - step,
        Key.Key_PageUp: weight + 4 * step,
        Key.Key_PageDown: weight - 4 * step,
        Key.Key_Home: 0.0,
        Key.Key_End: scale.full,
    }
    target = targets.get(Key(key))
    return None if target is None else round(min(max(target, 0.0), scale.end(modifiers, weight)), 3)
