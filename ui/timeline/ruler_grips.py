"""What a press on the ruler takes hold of, and the gesture that a drag of it begins."""

from __future__ import annotations

from PySide6.QtCore import QPointF

from app.timeline.chosen import NOTHING, Chosen, times_of
from app.timeline.gestures.chosen_things import MoveChosen, ScaleChosen
from app.timeline.gestures.time import DragPlayed, DragRange, End, Scrub
from app.timeline.timeline import Timeline
from facemodel.animation.clip import NamedRange
from ui.timeline.hands import Grip
from ui.timeline.hits import EDGE, FINGER
from ui.timeline.paint.ground import Pane
from ui.timeline.paint.ruler import MARKS, TIMES, band_of


def mark_at(pane: Pane, x: float) -> Chosen:
    """The marker or named range under a pixel of the strip of marks."""
    for marker in reversed(pane.animation.markers):
        if -3 <= x - pane.scale.x(marker.time) <= FINGER + 4:
            return Chosen(markers=frozenset((marker.time,)))
    for each in reversed(pane.animation.ranges):
        if pane.scale.x(each.start) - EDGE <= x <= pane.scale.x(each.end) + EDGE:
            return Chosen(ranges=frozenset((each.name,)))
    return NOTHING


def played_end(pane: Pane, place: QPointF) -> End | None:
    """The end of what is played whose handle is under a point."""
    if not TIMES - 11 <= place.y() < TIMES:
        return None
    if -2 <= place.x() - pane.scale.x(pane.animation.start) <= 8:
        return "start"
    return "end" if -8 <= place.x() - pane.scale.x(pane.animation.end) <= 2 else None


def goes_sideways(pane: Pane, place: QPointF) -> bool:
    """Whether a drag from a point moves or stretches something."""
    if played_end(pane, place) is not None:
        return True
    if place.y() >= TIMES + MARKS:
        band = band_of(pane)
        return band is not None and band.left() - EDGE <= place.x() <= band.right() + EDGE
    return place.y() >= TIMES and bool(mark_at(pane, place.x()))


def grasp(timeline: Timeline, pane: Pane, place: QPointF) -> Grip:
    """What a press at a point takes hold of."""
    end = played_end(pane, place)
    if end is not None:
        return Grip(lambda first: DragPlayed(timeline, end, first))
    if place.y() < TIMES:
        return _scrub(timeline)
    return _band(timeline, pane, place.x()) if place.y() >= TIMES + MARKS else _mark(timeline, pane, place.x())


def _scrub(timeline: Timeline) -> Grip:
    return Grip(lambda first: Scrub(timeline, first), at_once=True)


def _mark(timeline: Timeline, pane: Pane, x: float) -> Grip:
    mark = mark_at(pane, x)
    if not mark:
        return Grip(click=lambda _: timeline.choose(NOTHING))
    if not timeline.chosen.holds(mark):
        timeline.choose(mark)
    for each in pane.animation.ranges:
        if each.name in mark.ranges:
            return _range(timeline, pane, each, x)
    (time,) = mark.markers
    return Grip(lambda first: MoveChosen(timeline, time, first))


def _range(timeline: Timeline, pane: Pane, each: NamedRange, x: float) -> Grip:
    if abs(pane.scale.x(each.start) - x) <= EDGE:
        return Grip(lambda first: DragRange(timeline, each.name, "start", first))
    if abs(pane.scale.x(each.end) - x) <= EDGE:
        return Grip(lambda first: DragRange(timeline, each.name, "end", first))
    return Grip(lambda first: MoveChosen(timeline, each.start, first))


def _band(timeline: Timeline, pane: Pane, x: float) -> Grip:
    band, reach = band_of(pane), times_of(pane.animation, pane.chosen)
    if band is None or reach is None:
        return _scrub(timeline)
    if abs(x - band.right()) <= EDGE + 1:
        return Grip(lambda _: ScaleChosen(timeline, reach[1], reach[0]))
    if abs(x - band.left()) <= EDGE + 1:
        return Grip(lambda _: ScaleChosen(timeline, reach[0], reach[1]))
    if band.left() < x < band.right():
        return Grip(lambda first: MoveChosen(timeline, reach[0], first))
    return Grip()
