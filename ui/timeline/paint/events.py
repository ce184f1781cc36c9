"""Events: every bump with the handles of its temporal parameters, and groups of them as clips."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.timeline.gestures.events import Part
from app.timeline.lines import Line, channels_title, clips_of
from facemodel.animation.channels import channel_of
from facemodel.animation.event import Event, bump
from ui.theme.apply import interface_font
from ui.theme.colour import blend
from ui.theme.metrics import RADIUS, SMALL_TYPE
from ui.timeline.paint.ground import Pane, diamond, elided
from ui.timeline.paint.runs import draw_strip, run_image

MARGIN = 6
"""Pixels above and below a bump, for its handles."""

HANDLE = 3.6
"""Half the width of a handle."""


class EventScale:
    """Heights of an event's values in its line.

    Parameters
    ----------
    area : the line
    full : value of full size; a bump that goes beyond fits as well
    """

    def __init__(self, pane: Pane, event: Event, area: QRectF) -> None:
        reach = [channel_of(name, pane.units) for name in event.channels]
        rigid = any(each.rigid for each in reach)
        self.full = max(abs(event.amplitude) * 1.05, 12.0 if rigid else 1.0)
        room = area.height() - 2 * MARGIN
        self.rest = area.y() + area.height() / 2 if rigid else area.bottom() - MARGIN
        self._per_unit = (room / 2 if rigid else room) / self.full

    def y(self, value: float) -> float:
        """Height of a value."""
        return self.rest - value * self._per_unit

    def value(self, y: float) -> float:
        """The value at a height."""
        return (self.rest - y) / self._per_unit


def handles(pane: Pane, event: Event, area: QRectF) -> Mapping[Part, QPointF]:
    """Where the handles of an event are."""
    scale = EventScale(pane, event, area)
    rises, falls = event.full
    peak = event.start + event.peak
    half, top = scale.y(event.amplitude / 2), scale.y(event.amplitude)
    return {
        "onset": QPointF(pane.scale.x(event.begins), scale.rest),
        "offset": QPointF(pane.scale.x(event.ends), scale.rest),
        "rise": QPointF(pane.scale.x((event.begins + rises) / 2), half),
        "fall": QPointF(pane.scale.x((falls + event.ends) / 2), half),
        "peak": QPointF(pane.scale.x(peak), top),
    }


def paint_event(painter: QPainter, pane: Pane, line: Line, area: QRectF) -> None:
    """Events that move the same: their bumps, and the handles of those that are chosen."""
    for event in events_of(pane, line):
        if _seen(pane, event):
            colour = pane.side(line.side)
            colour.setAlphaF(0.35 if event.muted else 0.95)
            _paint_bump(painter, pane, event, area, colour, 0.3)
            if event.key in pane.chosen.events:
                _paint_handles(painter, pane, event, area)


def paint_events(painter: QPainter, pane: Pane, line: Line, area: QRectF) -> None:
    """Groups of events as clips with their names, and all bumps in them."""
    for name, events in clips_of(events_of(pane, line)).items():
        body = clip_body(pane, events, area)
        if body.right() >= 0 and body.x() <= pane.width:
            title = name if events[0].group else channels_title(events[0].channels, pane.units)
            _paint_clip(painter, pane, title, events, body)


def _paint_clip(painter: QPainter, pane: Pane, name: str, events: list[Event], body: QRectF) -> None:
    chosen = all(event.key in pane.chosen.events for event in events)
    accent = QColor(pane.theme.accent)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(accent if chosen else blend(pane.ground, pane.theme.muted, 0.5), 1.0))
    painter.setBrush(blend(pane.ground, accent if chosen else pane.theme.muted, 0.16))
    painter.drawRoundedRect(body, RADIUS, RADIUS)
    quiet = blend(pane.ground, pane.theme.muted, 0.75)
    for event in events:
        _paint_bump(painter, pane, event, body.adjusted(0, -MARGIN + 2, 0, MARGIN - 2), quiet, 0.08)
    painter.setFont(interface_font(SMALL_TYPE))
    left = max(body.x(), 0.0) + 6
    room = QRectF(left, body.y() + 1, max(min(body.right(), pane.width) - left - 4, 0), body.height() - 2)
    if room.width() > 16:
        painter.setPen(QColor(pane.theme.text))
        align = Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft
        painter.drawText(room, align, elided(painter, name, room.width()))


def clip_body(pane: Pane, events: list[Event], area: QRectF) -> QRectF:
    """The block of a group."""
    begin, end = min(event.begins for event in events), max(event.ends for event in events)
    x = pane.scale.x(begin)
    return QRectF(x + 0.5, area.y() + 3.5, max(pane.scale.x(end) - x, 2.0), area.height() - 7)


def events_of(pane: Pane, line: Line) -> list[Event]:
    """The events of a line or lane."""
    keys = set(line.members)
    return [event for event in pane.animation.events if event.key in keys]


def _paint_bump(painter: QPainter, pane: Pane, event: Event, area: QRectF, colour: QColor, fill: float) -> None:
    left = int(max(np.floor(pane.scale.x(event.begins)), 0))
    right = int(min(np.ceil(pane.scale.x(event.ends)) + 1, pane.width))
    if right <= left:
        return
    scale = EventScale(pane, event, area)
    count = round((right - left) * pane.ratio)
    xs = left + (np.arange(count) + 0.5) / pane.ratio
    values = bump(event, pane.scale.begin + xs / pane.scale.per_second)
    y = (np.array([scale.y(value) for value in (0.0, 1.0)]) - area.y()) * pane.ratio
    heights = y[0] + (y[1] - y[0]) * values
    image = run_image(heights, heights, float(y[0]), round(area.height() * pane.ratio), colour, fill)
    draw_strip(painter, QRectF(left, area.y(), right - left, area.height()), image)


def _paint_handles(painter: QPainter, pane: Pane, event: Event, area: QRectF) -> None:
    places = handles(pane, event, area)
    theme = pane.theme
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(theme.accent), 1.0, Qt.PenStyle.DotLine))
    painter.drawLine(QPointF(places["peak"].x(), area.y() + 2), QPointF(places["peak"].x(), area.bottom() - 2))
    painter.setPen(QPen(pane.ground, 1.0))
    painter.setBrush(QColor(theme.accent))
    painter.drawPolygon(diamond(places["peak"].x(), places["peak"].y(), HANDLE + 1.2))
    for part in ("onset", "offset"):
        painter.drawRect(_square(places[part]))  # type: ignore[index]
    painter.setBrush(QColor(theme.text))
    for part in ("rise", "fall"):
        painter.drawEllipse(places[part], HANDLE, HANDLE)  # type: ignore[index]


def _square(place: QPointF) -> QRectF:
    return QRectF(place.x() - HANDLE, place.y() - HANDLE, 2 * HANDLE, 2 * HANDLE)


def _seen(pane: Pane, event: Event) -> bool:
    return pane.scale.x(event.ends) >= 0 and pane.scale.x(event.begins) <= pane.width


def parts_by_closeness(places: Mapping[Part, QPointF], at: QPointF, finger: float) -> Iterator[Part]:
    """The handles within a finger's width, the nearest first; the peak before others at the same place."""
    order: tuple[Part, ...] = ("peak", "onset", "offset", "rise", "fall")
    near = [((places[part] - at).manhattanLength(), order.index(part), part) for part in order]
    yield from (part for away, _, part in sorted(near) if away <= finger)
