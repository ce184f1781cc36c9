"""Dragging the value of a channel, which becomes a key under the playhead."""

from __future__ import annotations

from app.timeline.gestures.gesture import Spot
from app.timeline.timeline import LiveChange, Timeline
from app.timeline.values import value_of, with_value
from facemodel.animation.channels import RIGID, channel_of

SWEEP = 200.0
"""Pixels that a hand travels from rest to full."""

FINE = 0.1
"""What Shift makes of a drag."""


class DragValue:
    """The value of a channel follows the hand to the side."""

    advice = "A key is set under the playhead · Shift is finer · Esc takes it back"

    def __init__(self, timeline: Timeline, channel: str, spot: Spot) -> None:
        known = channel_of(channel, timeline.document.project.units)
        self._timeline, self._channel = timeline, channel
        self._live = LiveChange(timeline, f"Key {known.title}")
        self._full = known.high if channel in RIGID else 1.0
        self._value, self._x = value_of(timeline, channel), spot.x

    def move(self, spot: Spot) -> None:
        """Follow the hand."""
        gone, self._x = spot.x - self._x, spot.x
        self._value += gone / SWEEP * self._full * (FINE if spot.shift else 1.0)
        shown = round(self._value, 1 if self._channel in RIGID else 2 + int(spot.shift))
        self._live.show(with_value(self._timeline, self._live.base, self._channel, shown))

    def release(self, spot: Spot) -> None:
        """It stays so."""
        self.move(spot)

    def cancel(self) -> None:
        """There is no key."""
        self._live.cancel()
