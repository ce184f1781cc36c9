"""The ruler: times, what is played, markers and named ranges, and a band about what is chosen."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from app.timeline.chosen import times_of
from facemodel.animation.timecode import written
from ui.theme.apply import interface_font
from ui.theme.colour import blend
from ui.theme.metrics import RADIUS, SMALL_TYPE
from ui.timeline.paint.ground import Pane, elided
from ui.timeline.time_scale import ticks

TIMES, MARKS, BAND = 24, 15, 7
"""Pixels of the strips: times with what is played, markers and ranges, what is chosen."""

HEIGHT = TIMES + MARKS + BAND

NO_HOURS = "00:"
"""What the ruler leaves out of times within the first hour."""

HEAD_REACH = 48
"""Pixels to either side of the playhead that its head may take."""

FLAG = 7.0
"""Pixels of a marker's flag."""


def paint_ruler(painter: QPainter, pane: Pane) -> None:
    """All but the playhead."""
    theme = pane.theme
    painter.fillRect(QRectF(0, 0, pane.width, HEIGHT), QColor(theme.panel))
    painter.setFont(interface_font(SMALL_TYPE))
    _paint_played(painter, pane)
    _paint_times(painter, pane)
    _paint_ranges(painter, pane)
    _paint_markers(painter, pane)
    _paint_band(painter, pane)
    painter.setPen(QPen(QColor(theme.line), 1.0))
    painter.drawLine(QLineF(0, HEIGHT - 0.5, pane.width, HEIGHT - 0.5))


def paint_head(painter: QPainter, pane: Pane, time: float) -> None:
    """The head of the playhead with its time."""
    theme = pane.theme
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setFont(interface_font(SMALL_TYPE))
    text = written(time, pane.animation.rate, "frames" if pane.style == "timecode" else pane.style)
    x = pane.scale.x(time)
    wide = max(painter.fontMetrics().horizontalAdvance(text) + 10, 22)
    tag = QRectF(x - wide / 2, 2, wide, 16)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(theme.accent))
    painter.drawRoundedRect(tag, RADIUS, RADIUS)
    painter.setPen(QPen(QColor(theme.accent), 1.4))
    painter.drawLine(QLineF(x, tag.bottom(), x, HEIGHT))
    painter.setPen(QColor(theme.on_accent))
    painter.drawText(tag, Qt.AlignmentFlag.AlignCenter, text)


def band_of(pane: Pane) -> QRectF | None:
    """The band about what is chosen; none about a single moment."""
    reach = times_of(pane.animation, pane.chosen)
    if reach is None or reach[1] - reach[0] <= 1e-6:
        return None
    x = pane.scale.x(reach[0])
    return QRectF(x, TIMES + MARKS + 1, pane.scale.x(reach[1]) - x, BAND - 2)


def _paint_times(painter: QPainter, pane: Pane) -> None:
    theme = pane.theme
    for tick in ticks(pane.scale, pane.width, pane.animation.rate, pane.style):
        x = round(pane.scale.x(tick.time)) + 0.5
        painter.setPen(QPen(blend(theme.panel, theme.muted, 0.55 if tick.label else 0.3), 1.0))
        painter.drawLine(QLineF(x, TIMES - (8 if tick.label else 4), x, TIMES))
        if tick.label:
            painter.setPen(QColor(theme.muted))
            painter.drawText(QPointF(x + 4, TIMES - 9), tick.label.removeprefix(NO_HOURS))


def _paint_played(painter: QPainter, pane: Pane) -> None:
    """The stretch that is played, with a handle at each end."""
    theme = pane.theme
    start, end = pane.scale.x(pane.animation.start), pane.scale.x(pane.animation.end)
    bar = QRectF(start, TIMES - 3, end - start, 3).intersected(QRectF(0, 0, pane.width, TIMES))
    painter.fillRect(bar, blend(theme.panel, theme.accent, 0.55))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(theme.accent))
    for x, way in ((start, 1), (end, -1)):
        foot = float(TIMES)
        painter.drawPolygon(QPolygonF([QPointF(x, foot - 10), QPointF(x + 7 * way, foot), QPointF(x, foot)]))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _paint_ranges(painter: QPainter, pane: Pane) -> None:
    theme = pane.theme
    for each in pane.animation.ranges:
        chosen = each.name in pane.chosen.ranges
        x = pane.scale.x(each.start)
        body = QRectF(x, TIMES + 2, max(pane.scale.x(each.end) - x, 2), MARKS - 4)
        if body.right() < 0 or body.x() > pane.width:
            continue
        colour = QColor(theme.accent if chosen else theme.ok)
        painter.fillRect(body, blend(theme.panel, colour, 0.34))
        painter.fillRect(QRectF(body.x(), body.y(), 2, body.height()), colour)
        painter.fillRect(QRectF(body.right() - 2, body.y(), 2, body.height()), colour)
        painter.setPen(QColor(theme.text))
        room = body.adjusted(6 + max(-body.x(), 0), -1, -4, 1)
        align = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        painter.drawText(room, align, elided(painter, each.name, room.width()))


def _paint_markers(painter: QPainter, pane: Pane) -> None:
    theme = pane.theme
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    markers = pane.animation.markers
    for number, marker in enumerate(markers):
        x = pane.scale.x(marker.time)
        following = pane.scale.x(markers[number + 1].time) if number + 1 < len(markers) else float("inf")
        if not -100 < x < pane.width + FLAG:
            continue
        colour = QColor(theme.accent if marker.time in pane.chosen.markers else theme.warn)
        painter.setPen(QPen(colour, 1.2))
        painter.setBrush(colour)
        foot = TIMES + MARKS - 1.0
        painter.drawLine(QPointF(x, TIMES + 1), QPointF(x, foot))
        painter.drawPolygon(QPolygonF([QPointF(x, TIMES + 2), QPointF(x + FLAG, TIMES + 5), QPointF(x, TIMES + 9)]))
        painter.setPen(QColor(theme.text))
        painter.drawText(
            QPointF(x + FLAG + 3, foot - 2), elided(painter, marker.name, min(following - x - FLAG - 6, 120))
        )
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _paint_band(painter: QPainter, pane: Pane) -> None:
    band = band_of(pane)
    if band is None:
        return
    theme = pane.theme
    painter.fillRect(band, blend(theme.panel, theme.accent, 0.4))
    for x in (band.left(), band.right() - 4):
        painter.fillRect(QRectF(x, band.y(), 4, band.height()), QColor(theme.accent))
