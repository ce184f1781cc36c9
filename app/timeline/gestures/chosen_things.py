"""Dragging what is chosen: to another time, or apart."""

from __future__ import annotations

from collections.abc import Callable

from app.timeline.chosen import times_of
from app.timeline.clipping import clipping, pasted
from app.timeline.gestures.gesture import Spot
from app.timeline.moving import Edited, moved, scaled
from app.timeline.snapping import FREE, Snapping, snapping
from app.timeline.timeline import LiveChange, Timeline
from facemodel.actions import ActionUnit
from facemodel.animation.editing.bulk import SMALLEST_FACTOR


def snapping_for(timeline: Timeline, spot: Spot, snap: Snapping) -> Snapping:
    """What a gesture snaps to while Ctrl is up or down: the settings, or their opposite."""
    if not spot.control:
        return snap
    return FREE if timeline.state.snaps else Snapping(timeline.rate)


class MoveChosen:
    """Moves everything that is chosen.

    Parameters
    ----------
    grabbed : time of the thing under the hand, which is what snaps
    spot : where the hand took it
    copies : leave everything where it is and move copies instead
    rises : let values follow the hand too
    """

    advice = "Ctrl turns snapping over · Shift keeps to one direction · Esc puts everything back"

    def __init__(
        self, timeline: Timeline, grabbed: float, spot: Spot, copies: bool = False, rises: bool = False
    ) -> None:
        chosen = timeline.chosen
        count = chosen.key_count
        what = f"{count} keys" if count > 1 else "key" if count else "events" if chosen.events else "marks"
        self._timeline = timeline
        self._live = LiveChange(timeline, f"{'Copy' if copies else 'Move'} {what}")
        self._base, self._chosen = self._live.base, chosen
        self._snapping = snapping(self._base, timeline.state.snaps, chosen, [timeline.playhead.time])
        self._grabbed, self._from, self._rises = grabbed, spot, rises
        self._copy: Callable[[float], Edited] | None = None
        if copies:
            reach = times_of(self._base, chosen)
            begin = reach[0] if reach is not None else grabbed
            clip = clipping(self._base, chosen)
            self._copy = lambda seconds: pasted(self._base, clip, begin + seconds, (), self._units)

    def move(self, spot: Spot) -> None:
        """Everything goes along."""
        snap = snapping_for(self._timeline, spot, self._snapping)
        seconds = snap.time(self._grabbed + spot.time - self._from.time, spot.reach) - self._grabbed
        rise = spot.value - self._from.value if self._rises else 0.0
        if spot.shift and self._rises:
            seconds, rise = self._one_way(spot, seconds, rise)
        if self._copy is not None:
            self._live.show(*self._copy(seconds))
        else:
            self._live.show(*moved(self._base, self._chosen, seconds, rise, self._units))

    def release(self, spot: Spot) -> None:
        """It stays there."""
        self.move(spot)

    def cancel(self) -> None:
        """It goes back."""
        self._live.cancel()

    def _one_way(self, spot: Spot, seconds: float, rise: float) -> tuple[float, float]:
        """Along the axis that the hand has gone farther on."""
        across = abs(spot.time - self._from.time) / max(spot.reach, 1e-12)
        up = abs(rise) / max(spot.rise, 1e-12)
        return (seconds, 0.0) if across >= up else (0.0, rise)

    @property
    def _units(self) -> tuple[ActionUnit, ...]:
        return self._timeline.document.project.units


class ScaleChosen:
    """Draws everything that is chosen apart in time, about the far end, or about the playhead with Shift.

    Parameters
    ----------
    held : time of the end under the hand
    about : time of the other end
    """

    advice = "Shift scales about the playhead · Ctrl turns snapping over · Esc puts everything back"

    def __init__(self, timeline: Timeline, held: float, about: float) -> None:
        self._timeline = timeline
        self._live = LiveChange(timeline, "Scale keys" if timeline.chosen.keys else "Scale events")
        self._chosen = timeline.chosen
        self._snapping = snapping(self._live.base, timeline.state.snaps, self._chosen, [timeline.playhead.time])
        self._held, self._about = held, about

    def move(self, spot: Spot) -> None:
        """The end follows the hand."""
        snap = snapping_for(self._timeline, spot, self._snapping)
        about = self._timeline.playhead.time if spot.shift else self._about
        if abs(self._held - about) < SMALLEST_FACTOR:
            return
        factor = (snap.time(spot.time, spot.reach) - about) / (self._held - about)
        units = self._timeline.document.project.units
        self._live.show(*scaled(self._live.base, self._chosen, about, factor, units))

    def release(self, spot: Spot) -> None:
        """It stays there."""
        self.move(spot)

    def cancel(self) -> None:
        """It goes back."""
        self._live.cancel()
