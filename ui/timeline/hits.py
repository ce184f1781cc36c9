"""What lies under the pointer on the lines of the timeline."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from PySide6.QtCore import QPointF, QRectF

from app.timeline.chosen import Chosen
from app.timeline.gestures.events import Part
from app.timeline.lines import Line, clips_of, rows_of
from facemodel.animation.curve import SAME_TIME
from facemodel.animation.displacement import regions
from facemodel.animation.editing.expressions import expression_keys
from facemodel.animation.editing.selection import Row, curve_of_row, selected, unlocked
from facemodel.animation.event import Event
from ui.timeline.paint.events import EventScale, clip_body, events_of, handles, parts_by_closeness
from ui.timeline.paint.expressions import PORTRAIT
from ui.timeline.paint.ground import Pane
from ui.timeline.paint.speech import sounds_area

FINGER = 7.0
"""Pixels that the tip of the pointer covers."""

EDGE = 5.0
"""Pixels from an edge within which it is taken."""

Kind = Literal["nothing", "keys", "expression", "event", "clip", "handle", "sound", "bound", "region", "audio"]


@dataclass(frozen=True)
class Hit:
    """Something under the pointer.

    Attributes
    ----------
    kind : what it is
    line : the line it is in, if any
    chosen : what a click chooses
    time : of the thing itself, which snaps when it is moved
    part : handle of an event
    place : of a sound
    at_end : whether it is the end of a sound
    value : where the handle stands, in the unit of the event
    """

    kind: Kind = "nothing"
    line: Line | None = None
    chosen: Chosen = field(default_factory=Chosen)
    time: float = 0.0
    part: Part | None = None
    place: int = 0
    at_end: bool = False


def hit(pane: Pane, line: Line, area: QRectF, at: QPointF) -> Hit:
    """What of a line lies under a point."""
    finders = {
        "expressions": _expression,
        "speech": _sound,
        "events": _clip,
        "event": _event,
        "group": _keys,
        "track": _keys,
        "layer": _layer,
    }
    finder = finders.get(line.kind)
    found = finder(pane, line, area, at) if finder is not None else None
    if found is None and line.kind == "audio":
        return Hit("audio", line)
    return found or Hit("nothing", line)


def _expression(pane: Pane, line: Line, area: QRectF, at: QPointF) -> Hit | None:
    portrait = PORTRAIT.adjusted(0, 0, 0, area.height() - PORTRAIT.bottom())
    for mark in reversed(pane.animation.expressions):
        if portrait.translated(pane.scale.x(mark.time), area.y()).contains(at):
            keys = expression_keys(pane.animation, mark.time)
            return Hit("expression", line, Chosen(keys, expressions=frozenset((mark.time,))), mark.time)
    return _keys(pane, line, area, at) if at.y() > area.y() + PORTRAIT.bottom() else None


def _keys(pane: Pane, line: Line, _area: QRectF, at: QPointF) -> Hit | None:
    """The nearest key within a finger's width that is not locked, or all such keys of a sum at its time."""
    rows = unlocked(pane.animation, rows_of(line, pane.animation))
    time = nearest_key(pane, rows, at.x())
    if time is None:
        return None
    keys = selected(pane.animation, time, time, rows)
    return Hit("keys", line, Chosen(keys), time)


def nearest_key(pane: Pane, rows: tuple[Row, ...], x: float) -> float | None:
    """Time of the key of some rows that is nearest to a pixel, within a finger's width."""
    time, reach = pane.scale.time(x), pane.scale.seconds(FINGER)
    best: tuple[float, float] | None = None
    for row in rows:
        times = curve_of_row(pane.animation, row).times
        after = int(np.searchsorted(times, time))
        for near in times[max(after - 1, 0) : after + 1].tolist():
            if abs(near - time) <= reach and (best is None or abs(near - time) < best[0]):
                best = (abs(near - time), near)
    return best[1] if best is not None else None


def _layer(pane: Pane, line: Line, area: QRectF, at: QPointF) -> Hit | None:
    found = _keys(pane, line, area, at)
    track = pane.animation.track(line.channel)
    if found is not None or track is None:
        return found
    layer = track.layers[line.layer - 1]
    for begin, end in regions(layer):
        for edge in (begin, end):
            if abs(pane.scale.x(edge) - at.x()) <= EDGE:
                inside = layer.keys.times[(layer.keys.times >= begin) & (layer.keys.times <= end)]
                about = float(inside[0] if edge == begin else inside[-1])
                return Hit("region", line, time=about)
    return None


def _clip(pane: Pane, line: Line, area: QRectF, at: QPointF) -> Hit | None:
    for events in reversed(clips_of(events_of(pane, line)).values()):
        if clip_body(pane, events, area).contains(at):
            begin = min(event.begins for event in events)
            return Hit("clip", line, Chosen(events=frozenset(event.key for event in events)), begin)
    return None


def _event(pane: Pane, line: Line, area: QRectF, at: QPointF) -> Hit | None:
    events = events_of(pane, line)
    for event in events:
        if event.key in pane.chosen.events:
            part = next(parts_by_closeness(handles(pane, event, area), at, FINGER + 2), None)
            if part is not None:
                return Hit("handle", line, _one(event), event.begins, part)
    time = pane.scale.time(at.x())
    under = [event for event in events if event.begins - SAME_TIME <= time <= event.ends + SAME_TIME]
    if not under:
        return None
    shortest = min(under, key=lambda event: event.ends - event.begins)
    return Hit("event", line, _one(shortest), shortest.begins)


def _one(event: Event) -> Chosen:
    return Chosen(events=frozenset((event.key,)))


def _sound(pane: Pane, line: Line, area: QRectF, at: QPointF) -> Hit | None:
    sounds, time = pane.animation.speech.phonemes, pane.scale.time(at.x())
    if not sounds_area(area).contains(at):
        return None
    place = bisect_right(sounds, time, key=lambda each: each.start) - 1
    for near in (place, place + 1, place - 1):
        if 0 <= near < len(sounds):
            for bound, at_end in ((sounds[near].start, False), (sounds[near].end, True)):
                wide = (sounds[near].end - sounds[near].start) * pane.scale.per_second > 3 * EDGE
                if wide and abs(pane.scale.x(bound) - at.x()) <= EDGE:
                    return Hit("bound", line, Chosen(sounds=frozenset((near,))), bound, place=near, at_end=at_end)
    if 0 <= place < len(sounds) and time <= sounds[place].end:
        return Hit("sound", line, Chosen(sounds=frozenset((place,))), sounds[place].start, place=place)
    return None


def event_scale(pane: Pane, chosen: Chosen, area: QRectF) -> EventScale | None:
    """The scale of amplitudes of the event that is chosen, in its line."""
    event = next((event for event in pane.animation.events if event.key in chosen.events), None)
    return None if event is None else EventScale(pane, event, area)


def inside(pane: Pane, line: Line, area: QRectF, box: QRectF) -> Chosen:
    """What of a line lies in a box: keys by their time, events and sounds by any part of theirs."""
    start, end = pane.scale.time(box.left()), pane.scale.time(box.right())
    if line.kind in ("track", "layer", "group"):
        return Chosen(selected(pane.animation, start, end, unlocked(pane.animation, rows_of(line, pane.animation))))
    if line.kind == "expressions":
        times = [each.time for each in pane.animation.expressions if start <= each.time <= end]
        found = Chosen(expressions=frozenset(times))
        for time in times:
            found = found.joined(Chosen(expression_keys(pane.animation, time)))
        return found
    if line.kind in ("event", "events"):
        within = [e for e in events_of(pane, line) if e.begins <= end and e.ends >= start]
        return Chosen(events=frozenset(event.key for event in within))
    if line.kind == "speech":
        sounds = enumerate(pane.animation.speech.phonemes)
        return Chosen(sounds=frozenset(k for k, each in sounds if each.start < end and each.end > start))
    return Chosen()
