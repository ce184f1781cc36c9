"""What all lines are drawn upon: the colours of the timeline, the pane, the lines of the ruler, the playhead."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from app.timeline.chosen import Chosen
from app.timeline.lines import Side
from facemodel.actions import ActionUnit
from facemodel.animation.clip import Animation
from facemodel.animation.timecode import TimeStyle
from ui.theme.colour import blend
from ui.theme.roles import Theme
from ui.timeline.time_scale import TimeScale, ticks

KEY = 4.6
"""Half the height of a key."""


@dataclass(frozen=True, eq=False)
class Pane:
    """What painters need to know.

    Attributes
    ----------
    animation, units : what is drawn
    chosen : what of it is chosen
    scale, width : the stretch of time, and the pixels for it
    style : how times are written
    theme : its colours
    ratio : pixels of the screen in one of ours
    """

    animation: Animation
    units: tuple[ActionUnit, ...]
    chosen: Chosen
    scale: TimeScale
    width: int
    style: TimeStyle
    theme: Theme
    ratio: float = 1.0

    def side(self, side: Side) -> QColor:
        """The colour of a side of the face."""
        return QColor(getattr(self.theme, side))

    @property
    def ground(self) -> QColor:
        """The colour behind the lines."""
        return (
            QColor(self.theme.window) if self.theme.name == "dark" else blend(self.theme.panel, self.theme.window, 0.5)
        )

    @property
    def faint(self) -> QColor:
        """Lines that part lines."""
        return blend(self.ground, self.theme.line, 0.75)


def paint_grid(painter: QPainter, pane: Pane, height: float) -> None:
    """The ground with the lines of the ruler, darker where nothing is played."""
    painter.fillRect(QRectF(0, 0, pane.width, height), pane.ground)
    strong, weak = blend(pane.ground, pane.theme.line, 0.75), blend(pane.ground, pane.theme.line, 0.3)
    loud, quiet = [], []
    for tick in ticks(pane.scale, pane.width, pane.animation.rate, pane.style):
        x = round(pane.scale.x(tick.time)) + 0.5
        (loud if tick.label else quiet).append(QLineF(x, 0, x, height))
    for colour, lines in ((weak, quiet), (strong, loud)):
        painter.setPen(QPen(colour, 1.0))
        painter.drawLines(lines)


def paint_outside(painter: QPainter, pane: Pane, height: float) -> None:
    """A veil over what is not played."""
    veil = QColor(0, 0, 0, 70) if pane.theme.name == "dark" else QColor(40, 50, 60, 26)
    start, end = pane.scale.x(pane.animation.start), pane.scale.x(pane.animation.end)
    if start > 0:
        painter.fillRect(QRectF(0, 0, start, height), veil)
    if end < pane.width:
        painter.fillRect(QRectF(max(end, 0), 0, pane.width - max(end, 0), height), veil)


def paint_playhead(painter: QPainter, x: float, height: float, theme: Theme) -> None:
    """The line of the playhead."""
    painter.setPen(QPen(QColor(theme.accent), 1.4))
    painter.drawLine(QLineF(x, 0, x, height))


def diamond(x: float, y: float, size: float = KEY) -> QPolygonF:
    """A key as it is drawn."""
    return QPolygonF([QPointF(x, y - size), QPointF(x + size, y), QPointF(x, y + size), QPointF(x - size, y)])


def paint_key(
    painter: QPainter, x: float, y: float, chosen: bool, pane: Pane, size: float = KEY, locked: bool = False
) -> None:
    """One key; a locked one recedes. The pen is left changed."""
    theme = pane.theme
    fill = QColor(theme.accent) if chosen else blend(pane.ground, theme.muted, 0.4) if locked else key_colour(pane)
    painter.setPen(QPen(blend(pane.ground, "#000000" if theme.name == "dark" else "#ffffff", 0.65), 1.0))
    painter.setBrush(fill)
    painter.drawPolygon(diamond(x, y, size))


def key_colour(pane: Pane) -> QColor:
    """Keys that are not chosen."""
    return blend(pane.theme.muted, pane.theme.text, 0.45)


def elided(painter: QPainter, text: str, room: float) -> str:
    """A text that fits."""
    return painter.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, int(max(room, 0)))
