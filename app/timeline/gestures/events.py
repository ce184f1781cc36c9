"""Dragging the handles of an event's bump, one for each of its temporal parameters."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

from app.timeline.gestures.chosen_things import snapping_for
from app.timeline.gestures.gesture import Spot
from app.timeline.snapping import snapping
from app.timeline.timeline import LiveChange, Timeline
from facemodel.animation.channels import channel_of
from facemodel.animation.editing.events import sound, with_events, with_fall, with_rise
from facemodel.animation.event import SHORTEST, Event

Part = Literal["onset", "rise", "peak", "fall", "offset"]
"""Handles: where it sets out, half-way up, its peak (which amplitude and latency it has), half-way down, its end."""


class DragEvent:
    """One handle of an event follows the hand.

    Parameters
    ----------
    key : of the event
    part : which handle
    spot : where the hand took it
    """

    def __init__(self, timeline: Timeline, key: str, part: Part, spot: Spot) -> None:
        self._timeline = timeline
        self._live = LiveChange(timeline, f"Event {part}")
        self._event = next(event for event in self._live.base.events if event.key == key)
        self._snapping = snapping(self._live.base, timeline.state.snaps, timeline.chosen, [timeline.playhead.time])
        self._part: Part = part
        self._from = spot

    @property
    def advice(self) -> str:
        """What keys change about it."""
        own = "Shift keeps the amplitude" if self._part == "peak" else "the bump follows"
        return f"{own} · Ctrl turns snapping over · Esc puts it back"

    def move(self, spot: Spot) -> None:
        """The bump follows the hand."""
        self._live.show(with_events(self._live.base, (self._changed(spot),)))

    def release(self, spot: Spot) -> None:
        """It stays so."""
        self.move(spot)

    def cancel(self) -> None:
        """It is as it was."""
        self._live.cancel()

    def _changed(self, spot: Spot) -> Event:
        event = self._event
        snap = snapping_for(self._timeline, spot, self._snapping)
        by = spot.time - self._from.time
        rises, falls = event.full
        if self._part == "onset":
            onset = snap.time(event.begins + by, spot.reach) - event.start
            return replace(event, onset=min(onset, event.peak - SHORTEST))
        if self._part == "rise":
            return with_rise(event, rises + 2.0 * by)
        if self._part == "fall":
            return with_fall(event, falls + 2.0 * by)
        if self._part == "offset":
            return sound(replace(event, offset=snap.time(event.ends + by, spot.reach) - event.start))
        peak = snap.time(event.start + event.peak + by, spot.reach) - event.start
        peak = min(max(peak, event.onset + SHORTEST), event.offset)
        rise = 0.0 if spot.shift else spot.value - self._from.value
        return replace(event, peak=peak, amplitude=self._kept(event.amplitude + rise))

    def _kept(self, amplitude: float) -> float:
        """An amplitude that what it moves can have; heads and eyes turn both ways."""
        units = self._timeline.document.project.units
        reach = [channel_of(name, units) for name in self._event.channels]
        return min(max(amplitude, min(each.low for each in reach)), max(each.high for each in reach))
