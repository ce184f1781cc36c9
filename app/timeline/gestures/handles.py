"""Dragging the handles of keys, and the knots of a layer apart."""

from __future__ import annotations

from app.timeline.gestures.gesture import Spot
from app.timeline.timeline import LiveChange, Timeline
from facemodel.animation.displacement import REACH
from facemodel.animation.editing.keys import with_flags, with_handles
from facemodel.animation.editing.layers import with_layer_changed
from facemodel.animation.editing.selection import Row, curve_of_row, with_row
from facemodel.animation.editing.tracks import with_track


class DragHandle:
    """A handle of a key follows the hand, and the other one turns along unless both are broken apart.

    Parameters
    ----------
    row, place : of the key
    ahead : whether it is the handle ahead of the key
    """

    advice = "Alt breaks the two handles apart · Shift keeps the slope level · Esc puts it back"

    def __init__(self, timeline: Timeline, row: Row, place: int, ahead: bool) -> None:
        self._live = LiveChange(timeline, "Move handle")
        self._row, self._place, self._ahead = row, place, ahead

    def move(self, spot: Spot) -> None:
        """Follow the hand."""
        base = self._live.base
        track = base.track(self._row[0])
        if track is None or track.locked:
            return
        curve = curve_of_row(base, self._row)
        if spot.alt:
            curve = with_flags(curve, [self._place], broken=True)
        away = spot.time - float(curve.times[self._place])
        up = 0.0 if spot.shift else spot.value - float(curve.values[self._place])
        handle = (max(away, 0.0) if self._ahead else min(away, 0.0), up)
        made = with_handles(curve, self._place, **{"leaves" if self._ahead else "arrives": handle})
        self._live.show(with_track(base, with_row(track, self._row[1], made)))

    def release(self, spot: Spot) -> None:
        """It stays there."""
        self.move(spot)

    def cancel(self) -> None:
        """It goes back."""
        self._live.cancel()


class DragSpacing:
    """The edge of the region that a layer may change follows the hand: its knots are drawn apart or together.

    Parameters
    ----------
    channel, layer : which layer, 1 the lowest
    about : time of the key whose region it is
    """

    advice = "Farther from the key: a longer, softer change · nearer: a shorter one · Esc puts it back"

    def __init__(self, timeline: Timeline, channel: str, layer: int, about: float) -> None:
        self._live = LiveChange(timeline, "Knot spacing")
        self._channel, self._layer, self._about = channel, layer, about

    def move(self, spot: Spot) -> None:
        """The region reaches as far as the hand."""
        # On average a key lies in the middle of its knot's interval, which has three more on either side.
        spacing = abs(spot.time - self._about) / (REACH - 0.5)
        self._live.show(with_layer_changed(self._live.base, self._channel, self._layer, spacing=spacing))

    def release(self, spot: Spot) -> None:
        """It stays so."""
        self.move(spot)

    def cancel(self) -> None:
        """It is as it was."""
        self._live.cancel()
