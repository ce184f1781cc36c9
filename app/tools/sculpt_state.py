"""How it is sculpted: the brush that moves skin, as a value and with its owner."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from psygnal import Signal

from app.tools.brush_state import GROWTH, SMALLEST_RADIUS, STEP
from app.tools.pointer import Modifier
from facemodel.painting.brush import LARGEST_RADIUS
from facemodel.sculpting.brush import SculptBrush, SculptMode

USUAL: Mapping[SculptMode, float] = {"pull": 1.0, "raise": 0.5, "smooth": 0.5, "pinch": 0.5, "erase": 1.0}
"""Strength before anybody says otherwise: at 1 the skin goes all the way with a hand that pulls."""


@dataclass(frozen=True)
class SculptState:
    """The brush that sculpts.

    Attributes
    ----------
    mode : what it does
    radius : geodesic, millimetres
    hardness : 0 to 1
    mirror : both sides of the face are sculpted alike
    strengths : 0 to 1 by mode; the usual one where it is not named
    """

    mode: SculptMode = "pull"
    radius: float = 18.0
    hardness: float = 0.0
    mirror: bool = True
    strengths: Mapping[SculptMode, float] = field(default_factory=dict)

    @property
    def strength(self) -> float:
        """The strength of what it does now."""
        return self.strengths.get(self.mode, USUAL[self.mode])

    def brush(self, modifiers: frozenset[Modifier] = frozenset()) -> SculptBrush:
        """The brush for a stroke: Shift smooths, Control lowers instead of raising, spreads instead of pinching."""
        mode: SculptMode = "smooth" if "shift" in modifiers else self.mode
        strength = self.strengths.get(mode, USUAL[mode])
        return SculptBrush(mode, self.radius, strength, self.hardness, reverse="control" in modifiers)


class HandSculpt:
    """Holds one `SculptState` and tells when it becomes another."""

    changed = Signal(object, object)
    """(SculptState now, SculptState before)"""

    def __init__(self, state: SculptState | None = None) -> None:
        self._state = state or SculptState()

    @property
    def state(self) -> SculptState:
        """The brush in the hand."""
        return self._state

    def change(self, **members: Any) -> None:
        """Change some members; numbers stop at the ends of their range."""
        before, self._state = self._state, _within(replace(self._state, **members))
        if self._state != before:
            self.changed.emit(self._state, before)

    def set_strength(self, strength: float) -> None:
        """The strength of what it does now, from now on."""
        within = float(np.clip(strength, 0.0, 1.0))
        self.change(strengths={**self._state.strengths, self._state.mode: within})

    def resize(self, notches: float) -> None:
        """Make it larger, or smaller with fewer than no notches."""
        self.change(radius=self._state.radius * GROWTH**notches)

    def strengthen(self, steps: float) -> None:
        """Make it stronger, or weaker with fewer than no steps."""
        self.set_strength(self._state.strength + STEP * steps)


def _within(state: SculptState) -> SculptState:
    return replace(
        state,
        radius=float(np.clip(state.radius, SMALLEST_RADIUS, LARGEST_RADIUS)),
        hardness=float(np.clip(state.hardness, 0.0, 1.0)),
    )
