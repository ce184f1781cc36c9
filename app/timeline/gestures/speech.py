"""Dragging the bounds between sounds."""

from __future__ import annotations

from app.timeline.gestures.chosen_things import snapping_for
from app.timeline.gestures.gesture import Spot
from app.timeline.snapping import snapping
from app.timeline.timeline import LiveChange, Timeline
from facemodel.animation.editing.speech import with_bounds


class DragBound:
    """The start or the end of a sound follows the hand; a neighbour that touches it goes along.

    Parameters
    ----------
    place : of the sound
    at_end : whether it is its end
    """

    advice = "Ctrl turns snapping over · Esc puts it back"

    def __init__(self, timeline: Timeline, place: int, at_end: bool, spot: Spot) -> None:
        self._timeline = timeline
        self._live = LiveChange(timeline, "Move sound")
        self._place, self._at_end, self._from = place, at_end, spot
        phoneme = self._live.base.speech.phonemes[place]
        self._held = phoneme.end if at_end else phoneme.start
        # Sounds are shorter than frames: they only snap to marks and keys.
        targets = timeline.state.snaps - {"frames"}
        self._snapping = snapping(self._live.base, targets, timeline.chosen, [timeline.playhead.time])

    def move(self, spot: Spot) -> None:
        """Follow the hand."""
        time = snapping_for(self._timeline, spot, self._snapping).time(
            self._held + spot.time - self._from.time, spot.reach
        )
        bound = {"end": time} if self._at_end else {"start": time}
        self._live.show(with_bounds(self._live.base, self._place, **bound))

    def release(self, spot: Spot) -> None:
        """It stays there."""
        self.move(spot)

    def cancel(self) -> None:
        """It goes back."""
        self._live.cancel()
