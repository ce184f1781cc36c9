"""How it is painted: the brush in the hand, as a value and with its owner."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from psygnal import Signal

from app.tools.pointer import Modifier
from facemodel.errors import UnknownNameError
from facemodel.painting.brush import LARGEST_RADIUS, MODES, Brush, Mode, check_mode
from facemodel.painting.layers import LAYER, PaintLayer
from fem import Support

SMALLEST_RADIUS = 0.5
"""Millimetres; less than the distance between vertices anywhere on a face."""

STEP = 0.05
"""What one key press adds to the strength."""

GROWTH = 1.15
"""What one notch of the wheel does to the radius."""

STRONGER = 1.25
"""What a brush that scales multiplies by, before anybody says otherwise."""

TURN = 15.0
"""Degrees by which a brush that adds turns the grain."""

EMPHASIS = 3.0
"""What a brush that sets paints, over what is there before anybody does: at half strength a first stroke doubles it."""

STANDING = 90.0
"""Degrees that a brush sets the grain to: faces come with level grain."""


@dataclass(frozen=True)
class BrushState:
    """The brush in the hand.

    Attributes
    ----------
    layer : key of what is painted, see `facemodel.painting.layers`
    radius : geodesic, millimetres
    strength, hardness : 0 to 1
    mirror : both sides of the face are painted alike
    tolerance : share of a layer's range within which a flood of the fill goes on
    modes : by layer, what the brush does there; the layer's most usual where it is not named
    values : by layer and mode, what is painted; a default where it is not named
    """

    layer: str = "stiffness"
    radius: float = 12.0
    strength: float = 0.5
    hardness: float = 0.3
    mirror: bool = True
    tolerance: float = 0.1
    modes: Mapping[str, Mode] = field(default_factory=dict)
    values: Mapping[tuple[str, Mode], float] = field(default_factory=dict)

    @property
    def paint_layer(self) -> PaintLayer:
        """What is painted."""
        return LAYER[self.layer]

    @property
    def mode(self) -> Mode:
        """What the brush does to the layer."""
        return self.modes.get(self.layer, MODES[self.paint_layer.kind][0])

    @property
    def value(self) -> float:
        """What it paints there: in the layer's unit, or a factor."""
        return self.values.get((self.layer, self.mode), usual_value(self.paint_layer, self.mode))

    def brush(self, modifiers: frozenset[Modifier] = frozenset()) -> Brush:
        """The brush for one stroke: Shift smooths, Control takes away what it would give."""
        layer, mode, value = self.paint_layer, self.mode, self.value
        if "shift" in modifiers and "smooth" in MODES[layer.kind]:
            return Brush(self.radius, self.strength, self.hardness, "smooth")
        if "control" in modifiers:
            mode, value = _taken_away(mode, value)
        return Brush(self.radius, self.strength, self.hardness, mode, value)


class HandBrush:
    """Holds one `BrushState` and tells when it becomes another."""

    changed = Signal(object, object)
    """(BrushState now, BrushState before)"""

    def __init__(self, state: BrushState | None = None) -> None:
        self._state = state or BrushState()

    @property
    def state(self) -> BrushState:
        """The brush in the hand."""
        return self._state

    def change(self, **members: Any) -> None:
        """Change some members; numbers stop at the ends of their range.

        Raises
        ------
        UnknownNameError
            If there is no such layer.
        """
        before, self._state = self._state, _within(replace(self._state, **members))
        if self._state != before:
            self.changed.emit(self._state, before)

    def set_mode(self, mode: Mode) -> None:
        """What the brush does to the layer in hand from now on; raises `PaintError` if it cannot be done to it."""
        check_mode(self._state.paint_layer, mode)
        self.change(modes={**self._state.modes, self._state.layer: mode})

    def set_value(self, value: float) -> None:
        """What it paints on the layer in hand in its present mode from now on."""
        state = self._state
        self.change(values={**state.values, (state.layer, state.mode): float(value)})

    def resize(self, notches: float) -> None:
        """Make it larger, or smaller with fewer than no notches."""
        self.change(radius=self._state.radius * GROWTH**notches)

    def strengthen(self, steps: float) -> None:
        """Make it stronger, or weaker with fewer than no steps."""
        self.change(strength=self._state.strength + STEP * steps)


def usual_value(layer: PaintLayer, mode: Mode) -> float:
    """What a brush paints before anybody says otherwise: never what is there already."""
    if layer.kind == "choice":
        return float(Support.CLAMPED)
    if mode == "scale":
        return STRONGER
    ordinary = layer.default if layer.typical is None else layer.typical
    if mode == "add":
        return TURN if layer.kind == "angle" else ordinary / 2
    return STANDING if layer.kind == "angle" else EMPHASIS * ordinary


def _taken_away(mode: Mode, value: float) -> tuple[Mode, float]:
    """How a stroke does the opposite: subtract, divide, or bring back what nobody painted."""
    if mode == "add":
        return mode, -value
    if mode == "scale":
        return mode, 1 / value if value else 1.0
    return ("erase" if mode == "set" else mode), value


def _within(state: BrushState) -> BrushState:
    if state.layer not in LAYER:
        raise UnknownNameError(f"There is no layer “{state.layer}” to paint; choose one of {', '.join(LAYER)}.")
    return replace(
        state,
        radius=float(np.clip(state.radius, SMALLEST_RADIUS, LARGEST_RADIUS)),
        strength=float(np.clip(state.strength, 0.0, 1.0)),
        hardness=float(np.clip(state.hardness, 0.0, 1.0)),
        tolerance=float(np.clip(state.tolerance, 0.0, 1.0)),
    )
