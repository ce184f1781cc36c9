"""How a pad that blends is drawn: a quiet ground, portraits as knots, and the pointer with a thread to each of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen

from ui.theme.apply import current_theme, interface_font
from ui.theme.colour import blend
from ui.theme.metrics import RADIUS, SMALL_TYPE
from ui.theme.roles import Theme
from ui.widgets.portrait_paint import paint_portrait

if TYPE_CHECKING:
    from ui.widgets.blend_pad import BlendPad, Knot

KNOB = 20
"""Radius of a knot, pixels."""

POINTER = 6
CAPTION = 13
THINNEST, THICKEST = 0.5, 3.5
"""Width of the thread from the pointer to a knot of which nothing is meant, and to one that is all that is meant."""

EMPTY = "Drag expressions here from the list"


def paint_pad(pad: BlendPad, carried: tuple[str, QPointF] | None) -> None:
    """Draw all of a pad; what is carried is drawn where the hand has it."""
    theme, area = current_theme(), QRectF(pad.rect())
    painter = QPainter(pad)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    ground = QPainterPath()
    ground.addRoundedRect(area, RADIUS, RADIUS)
    painter.fillPath(ground, QColor(theme.raised if theme.name == "dark" else theme.hover))
    _paint_grid(painter, pad, theme)
    movable = [knot for knot in pad.knots if not knot.fixed]
    if movable:
        for knot in pad.knots:
            _paint_thread(painter, pad, knot, theme)
    for knot in pad.knots:
        if carried is None or carried[0] != knot.name:
            _paint_knot(painter, knot, pad.spot(knot.place), knot.name == pad.picked and bool(pad.picked), theme)
    if carried is not None:
        known = next((knot for knot in pad.knots if knot.name == carried[0]), None)
        _paint_carried(painter, known, carried[1], theme)
    if movable:
        _paint_pointer(painter, pad.spot(pad.pointer), pad.meant, theme)
    elif carried is None:
        painter.setPen(QColor(theme.muted))
        painter.drawText(area.adjusted(0, 2 * KNOB, 0, 0), Qt.AlignmentFlag.AlignHCenter, EMPTY)
    if pad.hasFocus():
        painter.setPen(QPen(QColor(theme.accent), 1.0))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)


def _paint_grid(painter: QPainter, pad: BlendPad, theme: Theme) -> None:
    painter.setPen(QPen(blend(theme.raised, theme.line, 0.7), 1.0))
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        painter.drawLine(pad.spot((share, 0.0)), pad.spot((share, 1.0)))
        painter.drawLine(pad.spot((0.0, share)), pad.spot((1.0, share)))


def _paint_thread(painter: QPainter, pad: BlendPad, knot: Knot, theme: Theme) -> None:
    share = pad.shares.get(knot.name, 0.0)
    colour = QColor(theme.accent)
    colour.setAlphaF(0.15 + 0.75 * share)
    painter.setPen(QPen(colour, THINNEST + share * (THICKEST - THINNEST)))
    painter.drawLine(pad.spot(pad.pointer), pad.spot(knot.place))


def _paint_knot(painter: QPainter, knot: Knot, at: QPointF, picked: bool, theme: Theme) -> None:
    shape = QPainterPath()
    shape.addEllipse(at, KNOB, KNOB)
    paint_portrait(painter, shape, knot.picture, 0.42)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(QColor(theme.accent if picked else theme.line), 2.0 if picked else 1.0))
    painter.drawEllipse(at, KNOB, KNOB)
    painter.setFont(interface_font(SMALL_TYPE))
    painter.setPen(QColor(theme.text if picked else theme.muted))
    below = QRectF(at.x() - 2 * KNOB, at.y() + KNOB, 4 * KNOB, CAPTION)
    words = painter.fontMetrics().elidedText(knot.title, Qt.TextElideMode.ElideRight, int(below.width()))
    painter.drawText(below, Qt.AlignmentFlag.AlignCenter, words)


def _paint_carried(painter: QPainter, knot: Knot | None, at: QPointF, theme: Theme) -> None:
    if knot is not None:
        _paint_knot(painter, knot, at, True, theme)
        return
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(QColor(theme.accent), 2.0, Qt.PenStyle.DashLine))
    painter.drawEllipse(at, KNOB, KNOB)


def _paint_pointer(painter: QPainter, at: QPointF, meant: bool, theme: Theme) -> None:
    """A full disc where the face shows the blend, else a ring."""
    painter.setPen(QPen(QColor(theme.window), 3.0))
    painter.setBrush(QColor(theme.window))
    painter.drawEllipse(at, POINTER, POINTER)
    painter.setPen(QPen(QColor(theme.accent), 2.0))
    painter.setBrush(QColor(theme.accent) if meant else QColor(theme.panel))
    painter.drawEllipse(at, POINTER, POINTER)
