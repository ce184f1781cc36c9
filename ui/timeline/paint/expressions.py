"""Key expressions: a small portrait for each, its name, and a key below it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath, QPen

from app.timeline.lines import Line, rows_of
from facemodel.animation.clip import KeyExpression
from ui.theme.apply import interface_font
from ui.theme.colour import blend
from ui.theme.metrics import RADIUS, SMALL_TYPE
from ui.timeline.paint.ground import Pane, elided, paint_key
from ui.timeline.paint.tracks import paint_keys
from ui.widgets.portrait_paint import paint_portrait

PORTRAIT = QRectF(-20, 4, 40, 44)
"""Where the portrait is, from the time and the top of the line."""

KEY_BELOW = 8
"""Pixels from the foot of the line to the middle of its keys."""

Pictures = Callable[[float], QImage | None]
"""The portrait of the key expression at a time, if it was taken already."""


def paint_expressions(painter: QPainter, pane: Pane, line: Line, area: QRectF, pictures: Pictures) -> None:
    """All key expressions in sight, and below them the keys of all lines together."""
    keys = QRectF(area.x(), area.bottom() - 2 * KEY_BELOW, area.width(), 2 * KEY_BELOW)
    paint_keys(painter, pane, rows_of(line, pane.animation), keys, 3.6)
    painter.setFont(interface_font(SMALL_TYPE))
    marks = pane.animation.expressions
    for number, mark in enumerate(marks):
        x = pane.scale.x(mark.time)
        if not -60 < x < pane.width + 60:
            continue
        following = pane.scale.x(marks[number + 1].time) if number + 1 < len(marks) else float("inf")
        chosen = mark.time in pane.chosen.expressions
        _paint_portrait(painter, pane, PORTRAIT.translated(x, area.y()), pictures(mark.time), chosen)
        paint_key(painter, x, area.bottom() - KEY_BELOW, chosen, pane, 5.4)
        _paint_name(painter, pane, mark, QRectF(x + 23, area.y() + 5, following - x - 46, 16))


def _paint_portrait(painter: QPainter, pane: Pane, place: QRectF, picture: QImage | None, chosen: bool) -> None:
    shape = QPainterPath()
    shape.addRoundedRect(place, RADIUS, RADIUS)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    paint_portrait(painter, shape, picture)
    colour = QColor(pane.theme.accent) if chosen else blend(pane.ground, pane.theme.muted, 0.45)
    painter.setPen(QPen(colour, 1.6 if chosen else 1.0))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRoundedRect(place, RADIUS, RADIUS)


def _paint_name(painter: QPainter, pane: Pane, mark: KeyExpression, room: QRectF) -> None:
    if mark.name and room.width() > 14:
        painter.setPen(QColor(pane.theme.muted))
        wide = min(room.width(), 120.0)
        place = QRectF(room.x(), room.y(), wide, room.height())
        painter.drawText(
            place, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop, elided(painter, mark.name, wide)
        )
