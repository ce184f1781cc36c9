"""Gestures on time itself: scrubbing, and what is played."""

from __future__ import annotations

from typing import Literal

from app.timeline.gestures.chosen_things import snapping_for
from app.timeline.gestures.gesture import Spot
from app.timeline.snapping import snapping
from app.timeline.timeline import LiveChange, Timeline
from facemodel.animation.editing.marks import played, with_range

End = Literal["start", "end", "both"]


class Scrub:
    """The playhead follows the hand, on whole frames unless snapping to them is off."""

    advice = "Ctrl goes between frames · Esc goes back"

    def __init__(self, timeline: Timeline, spot: Spot) -> None:
        self._timeline = timeline
        self._before = timeline.playhead.time
        self.move(spot)

    def move(self, spot: Spot) -> None:
        """Stand where the hand is."""
        snaps = ("frames" in self._timeline.state.snaps) != spot.control
        self._timeline.playhead.go(max(spot.time, 0.0), snap=snaps)

    def release(self, spot: Spot) -> None:
        """Stay there."""
        self.move(spot)

    def cancel(self) -> None:
        """Stand where it stood."""
        self._timeline.playhead.go(self._before)


class DragPlayed:
    """One end of what is played follows the hand, or all of it."""

    advice = "Ctrl turns snapping over · Esc puts it back"

    def __init__(self, timeline: Timeline, end: End, spot: Spot) -> None:
        self._timeline = timeline
        self._live = LiveChange(timeline, "Play range")
        base = self._live.base
        self._snapping = snapping(base, timeline.state.snaps, timeline.chosen, [timeline.playhead.time])
        self._end, self._from = end, spot

    def move(self, spot: Spot) -> None:
        """Follow the hand."""
        base, frame = self._live.base, 1.0 / self._live.base.rate
        snap = snapping_for(self._timeline, spot, self._snapping)
        by = spot.time - self._from.time
        start, end = base.start, base.end
        if self._end == "start":
            start = min(max(snap.time(start + by, spot.reach), 0.0), end - frame)
        elif self._end == "end":
            end = max(snap.time(end + by, spot.reach), start + frame)
        else:
            start = max(snap.time(start + by, spot.reach), 0.0)
            end = start + base.end - base.start
        self._live.show(played(base, start, end))

    def release(self, spot: Spot) -> None:
        """It stays there."""
        self.move(spot)

    def cancel(self) -> None:
        """It goes back."""
        self._live.cancel()


class DragRange:
    """One end of a named range follows the hand."""

    advice = DragPlayed.advice

    def __init__(self, timeline: Timeline, name: str, end: End, spot: Spot) -> None:
        self._timeline = timeline
        self._live = LiveChange(timeline, f"Range {name}")
        self._range = next(each for each in self._live.base.ranges if each.name == name)
        self._snapping = snapping(self._live.base, timeline.state.snaps, timeline.chosen, [timeline.playhead.time])
        self._end, self._from = end, spot

    def move(self, spot: Spot) -> None:
        """Follow the hand."""
        snap = snapping_for(self._timeline, spot, self._snapping)
        by = spot.time - self._from.time
        start = snap.time(self._range.start + by, spot.reach) if self._end == "start" else self._range.start
        end = snap.time(self._range.end + by, spot.reach) if self._end == "end" else self._range.end
        self._live.show(with_range(self._live.base, self._range.name, max(start, 0.0), end))

    def release(self, spot: Spot) -> None:
        """It stays there."""
        self.move(spot)

    def cancel(self) -> None:
        """It goes back."""
        self._live.cancel()
