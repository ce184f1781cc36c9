"""What a press on the sheet takes hold of, and the gesture that a drag of it begins."""

from __future__ import annotations

from collections.abc import Callable

from app.timeline.chosen import NOTHING, Chosen
from app.timeline.gestures import Gesture, Spot
from app.timeline.gestures.box import Box, ChooseInBox
from app.timeline.gestures.chosen_things import MoveChosen
from app.timeline.gestures.events import DragEvent
from app.timeline.gestures.handles import DragSpacing
from app.timeline.gestures.sound import MoveSound
from app.timeline.gestures.speech import DragBound
from app.timeline.timeline import Timeline
from ui.timeline.hands import Grip
from ui.timeline.hits import Hit


class SheetGrips:
    """Finds grips for hits.

    Parameters
    ----------
    timeline : what is worked on
    inside : what lies in a box of the sheet
    show_box : draws the box
    """

    def __init__(
        self, timeline: Timeline, inside: Callable[[Box], Chosen], show_box: Callable[[Box | None], None]
    ) -> None:
        self._timeline = timeline
        self._inside, self._show_box = inside, show_box

    def grasp(self, found: Hit, spot: Spot) -> Grip:
        """What a press on something takes hold of."""
        if found.kind == "handle":
            return self._handle(found)
        if found.kind == "bound":
            place_of, at_end = found.place, found.at_end
            return Grip(
                lambda first: DragBound(self._timeline, place_of, at_end, first), lambda _: self._choose(found, spot)
            )
        if found.kind == "region" and found.line is not None:
            line = found.line
            return Grip(lambda _: DragSpacing(self._timeline, line.channel, line.layer, found.time))
        if found.kind == "audio":
            return Grip(
                lambda first: MoveSound(self._timeline, first),
                lambda _: self._timeline.change(lines=frozenset(("audio",))),
            )
        if found.chosen:
            return self._thing(found, spot)
        return self._empty()

    def _handle(self, found: Hit) -> Grip:
        part = found.part
        assert part is not None
        (key,) = found.chosen.events
        return Grip(lambda first: DragEvent(self._timeline, key, part, first))

    def _thing(self, found: Hit, spot: Spot) -> Grip:
        """A thing that is not chosen yet is chosen by the press, so that it goes along."""
        chosen = self._timeline.chosen
        known = chosen.holds(found.chosen)
        if not known:
            self._timeline.choose(chosen.joined(found.chosen) if spot.shift or spot.control else found.chosen)

        def begin(first: Spot) -> Gesture:
            return MoveChosen(self._timeline, found.time, first, copies=first.alt)

        def click(_: Spot) -> None:
            if known:
                self._choose(found, spot)

        return Grip(begin, click)

    def _choose(self, found: Hit, spot: Spot) -> None:
        """Choose a thing alone, or with Shift or Ctrl take it into what is chosen or out of it."""
        several = spot.shift or spot.control
        self._timeline.choose(self._timeline.chosen.toggled(found.chosen) if several else found.chosen)

    def _empty(self) -> Grip:
        """Nothing is there: a drag draws a box, a click lets go of everything."""

        def begin(first: Spot) -> Gesture:
            return ChooseInBox(self._timeline, first, self._inside, self._show_box)

        def click(spot: Spot) -> None:
            if not (spot.shift or spot.control):
                self._timeline.choose(NOTHING)

        return Grip(begin, click)
