"""The heads of lines: fold, number, name, the value under the playhead, and the switches mute, solo and lock."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import qtawesome
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from app.timeline.lines import Line
from app.timeline.switches import Switch, switches_of
from facemodel.animation.clip import Animation
from ui.theme.apply import interface_font
from ui.theme.chosen import quiet_ink
from ui.theme.colour import blend
from ui.theme.icons import FAMILY
from ui.theme.metrics import GRID, SMALL_TYPE, TYPE
from ui.theme.roles import Theme

GLYPHS: Mapping[Switch, tuple[str, str]] = {
    "muted": ("eye-off-outline", "eye-outline"),
    "solo": ("star", "star-outline"),
    "locked": ("lock", "lock-open-variant-outline"),
}
"""Drawn when a switch is on, and when it is off."""

SWITCH = 18
"""Pixels of one switch."""

VALUE = 46
"""Pixels of the value."""

STRIP = 3 * GRID
"""Height of what is written in a head; the rest of a higher line stays empty."""

INDENT = 12
FOLD = 14


@dataclass(frozen=True)
class HeadLook:
    """How a head is to be drawn.

    Attributes
    ----------
    value : under the playhead, as text; empty for a line without one
    hovered, chosen : whether the pointer is on it, and whether it is chosen
    over : what of it the pointer is on: a switch, ``value``, ``fold`` or nothing
    """

    value: str = ""
    hovered: bool = False
    chosen: bool = False
    over: str = ""


def value_area(line: Line, area: QRectF) -> QRectF:
    """Where the value under the playhead is; nowhere for a line without one."""
    wide = VALUE if line.kind == "track" else 0
    return QRectF(area.right() - GRID - wide, area.y(), wide, min(area.height(), STRIP))


def switch_area(line: Line, area: QRectF, place: int, count: int) -> QRectF:
    """Where one of so many switches is, before the value."""
    value = value_area(line, area)
    return QRectF(value.x() - 2 - SWITCH * (count - place), area.y(), SWITCH, value.height())


def fold_area(line: Line, area: QRectF) -> QRectF:
    """Where the triangle is that folds the line."""
    return QRectF(area.x() + INDENT * line.depth, area.y(), FOLD, min(area.height(), STRIP))


def paint_head(painter: QPainter, line: Line, area: QRectF, animation: Animation, look: HeadLook, theme: Theme) -> None:
    """One head."""
    painter.fillRect(area, _ground(line, look, theme))
    if line.foldable:
        _paint_triangle(painter, fold_area(line, area), line.folded, theme)
    value = value_area(line, area)
    if look.value:
        _paint_value(painter, value, look, theme)
    switches = switches_of(line, animation)
    right = value.x() - 2
    for place, (name, on) in enumerate(switches.items()):
        if look.hovered or on:
            spot = switch_area(line, area, place, len(switches))
            right = min(right, spot.x())
            _paint_switch(painter, spot, name, on, look.over == name, theme)
    room = QRectF(area.x(), area.y(), right - area.x(), value.height())
    _paint_name(painter, line, room, look, bool(switches.get("muted")), theme)
    painter.setPen(QPen(blend(theme.panel, theme.line, 0.6), 1.0))
    painter.drawLine(QLineF(area.x(), area.bottom() - 0.5, area.right(), area.bottom() - 0.5))


def _ground(line: Line, look: HeadLook, theme: Theme) -> QColor:
    if look.chosen:
        return blend(theme.panel, theme.accent, 0.22)
    if look.hovered:
        return QColor(theme.hover)
    return blend(theme.panel, theme.muted, 0.08) if line.kind in ("group", "expressions") else QColor(theme.panel)


def _paint_name(painter: QPainter, line: Line, room: QRectF, look: HeadLook, muted: bool, theme: Theme) -> None:
    painter.setFont(interface_font(SMALL_TYPE if line.kind in ("group", "layer") else TYPE))
    x = room.x() + INDENT * line.depth + FOLD + 6
    if line.side != "both":
        painter.fillRect(QRectF(x - 6, room.center().y() - 5, 2, 10), QColor(getattr(theme, line.side)))
    quiet = muted or line.kind == "layer"
    ink = quiet_ink(theme, look.chosen)
    painter.setPen(ink)
    if line.number:
        wide = painter.fontMetrics().horizontalAdvance("00")
        align = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(QRectF(x, room.y(), wide, room.height()), align, line.number)
        x += wide + 6
    painter.setPen(ink if quiet or line.kind == "group" else QColor(theme.text))
    title = line.title.upper() if line.kind == "group" else line.title
    wide = max(room.right() - x - 4, 0)
    text = painter.fontMetrics().elidedText(title, Qt.TextElideMode.ElideRight, int(wide))
    painter.drawText(QRectF(x, room.y(), wide, room.height()), Qt.AlignmentFlag.AlignVCenter, text)


def _paint_value(painter: QPainter, place: QRectF, look: HeadLook, theme: Theme) -> None:
    painter.setFont(interface_font(SMALL_TYPE))
    if look.over == "value":
        painter.fillRect(place.adjusted(2, 3, 4, -3), QColor(theme.raised))
    painter.setPen(QColor(theme.text) if look.hovered else quiet_ink(theme, look.chosen))
    painter.drawText(place, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, look.value)


def _paint_switch(painter: QPainter, place: QRectF, name: Switch, on: bool, over: bool, theme: Theme) -> None:
    colours = {"muted": theme.warn, "solo": theme.accent, "locked": theme.text}
    colour = QColor(colours[name]) if on else QColor(theme.text if over else theme.muted)
    painter.setPen(colour)
    painter.setFont(qtawesome.font(FAMILY, 14))
    glyph = GLYPHS[name][0 if on else 1]
    painter.drawText(place, Qt.AlignmentFlag.AlignCenter, qtawesome.charmap(f"{FAMILY}.{glyph}"))


def _paint_triangle(painter: QPainter, place: QRectF, folded: bool, theme: Theme) -> None:
    centre = place.center() + QPointF(2, 0)
    long, short = 4.0, 2.5
    unfolded, shut = [(-long, -short), (long, -short), (0.0, short)], [(-short, -long), (short, 0.0), (-short, long)]
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(theme.muted))
    painter.drawPolygon(QPolygonF([centre + QPointF(x, y) for x, y in (shut if folded else unfolded)]))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
