"""Dragging the sound along in time."""

from __future__ import annotations

from dataclasses import replace

from app.timeline.gestures.chosen_things import snapping_for
from app.timeline.gestures.gesture import Spot
from app.timeline.snapping import snapping
from app.timeline.timeline import LiveChange, Timeline


class MoveSound:
    """The sound follows the hand; what is said stays where it is."""

    advice = "Ctrl turns snapping over · Esc puts it back"

    def __init__(self, timeline: Timeline, spot: Spot) -> None:
        self._timeline, self._from = timeline, spot
        self._live = LiveChange(timeline, "Move sound")
        self._snapping = snapping(self._live.base, timeline.state.snaps, timeline.chosen, [timeline.playhead.time])

    def move(self, spot: Spot) -> None:
        """Follow the hand."""
        audio = self._live.base.audio
        if audio is None:
            return
        snap = snapping_for(self._timeline, spot, self._snapping)
        start = snap.time(audio.start + spot.time - self._from.time, spot.reach)
        self._live.show(replace(self._live.base, audio=replace(audio, start=start)))

    def release(self, spot: Spot) -> None:
        """It stays there."""
        self.move(spot)

    def cancel(self) -> None:
        """It goes back."""
        self._live.cancel()
