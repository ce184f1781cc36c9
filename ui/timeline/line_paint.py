"""One line of the sheet, whatever kind it is of."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QLineF, QObject, QRectF, Signal
from PySide6.QtGui import QColor, QPainter, QPen

from app.timeline.lines import Line, rows_of
from ui.theme.colour import blend
from ui.timeline.paint.events import paint_event, paint_events
from ui.timeline.paint.expressions import Pictures, paint_expressions
from ui.timeline.paint.ground import Pane
from ui.timeline.paint.life import LifePainter
from ui.timeline.paint.speech import paint_speech
from ui.timeline.paint.tracks import TrackPainter, paint_keys

Paint = Callable[[QPainter, Pane, Line, QRectF], None]


class LinePainter(QObject):
    """Paints lines; what takes a while to make it remembers.

    Signals
    -------
    refreshed() : something is to be drawn anew, such as a portrait that was taken

    Parameters
    ----------
    pictures : portraits of key expressions
    """

    refreshed = Signal()

    def __init__(self, pictures: Pictures) -> None:
        super().__init__()
        tracks, life = TrackPainter(), LifePainter()
        self._painters: dict[str, Paint] = {
            "expressions": lambda painter, pane, line, area: paint_expressions(painter, pane, line, area, pictures),
            "speech": paint_speech,
            "life": life.paint,
            "events": paint_events,
            "event": paint_event,
            "group": paint_group,
            "track": tracks.paint,
            "layer": tracks.paint,
        }

    def add(self, kind: str, paint: Paint) -> None:
        """Let another function paint a kind of lines."""
        self._painters[kind] = paint

    def paint(self, painter: QPainter, pane: Pane, line: Line, area: QRectF) -> None:
        """A line with its ground and the hair line below it."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        if line.kind in ("group", "expressions"):
            painter.fillRect(area, band(pane))
        if line.kind in self._painters:
            self._painters[line.kind](painter, pane, line, area)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(QPen(pane.faint, 1.0))
        painter.drawLine(QLineF(area.x(), area.bottom() - 0.5, area.right(), area.bottom() - 0.5))
        painter.restore()


def band(pane: Pane) -> QColor:
    """The ground of a line that sums up others."""
    colour = QColor(blend(pane.ground, pane.theme.muted, 0.14))
    colour.setAlphaF(0.6)
    return colour


def paint_group(painter: QPainter, pane: Pane, line: Line, area: QRectF) -> None:
    """The keys of all lines of a group together."""
    paint_keys(painter, pane, rows_of(line, pane.animation), area, 3.6)
