"""Idle life: where the lids blink, and how the breath goes."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter

from app.timeline.lines import Line
from facemodel.animation.event import Event
from facemodel.animation.idle import blink_events, idle_curves
from facemodel.animation.keyed import values_of
from facemodel.sameness import Kept
from fem.types import FloatArray
from ui.theme.colour import blend
from ui.timeline.paint.ground import Pane
from ui.timeline.paint.runs import draw_strip, run_image


class LifePainter:
    """Paints the idle life of an animation, and remembers what it was made of."""

    def __init__(self) -> None:
        self._blinks: Kept[tuple[Event, ...]] = Kept()

    def paint(self, painter: QPainter, pane: Pane, _line: Line, area: QRectF) -> None:
        """Blinks as ticks over the course of the breath."""
        idle, end = pane.animation.idle, pane.animation.end
        if idle is None:
            return
        share = 0.35 if idle.muted else 1.0
        self._paint_breath(painter, pane, area, share)
        painter.setPen(Qt.PenStyle.NoPen)
        colour = blend(pane.ground, pane.theme.both, 0.9 * share)
        for blink in self._blinks.get((idle, end), lambda: blink_events(idle, end)):
            x = pane.scale.x(blink.begins)
            if -4 < x < pane.width:
                width = max((blink.ends - blink.begins) * pane.scale.per_second, 2.0)
                painter.fillRect(QRectF(x, area.y() + 5, width, area.height() - 10), colour)

    def _paint_breath(self, painter: QPainter, pane: Pane, area: QRectF, share: float) -> None:
        idle = pane.animation.idle
        assert idle is not None
        curve = idle_curves(idle, pane.animation.end).get("head.y")
        if curve is None:
            return
        width, height = round(pane.width * pane.ratio), round(area.height() * pane.ratio)
        times: FloatArray = pane.scale.begin + np.arange(width) / (pane.scale.per_second * pane.ratio)
        values = values_of(curve, times)
        values[(times < 0) | (times > pane.animation.end)] = np.nan
        top = float(curve.values.max()) or 1.0
        heights = height - 4 * pane.ratio - (height - 8 * pane.ratio) * values / top
        colour = QColor(pane.theme.both)
        colour.setAlphaF(0.35 * share)
        draw_strip(painter, area, run_image(heights, heights, float(height), height, colour))
