"""The graph: lines of values, curves, their keys and handles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from facemodel.animation.displacement import regions
from fem.types import FloatArray
from ui.theme.apply import interface_font
from ui.theme.colour import blend
from ui.theme.metrics import SMALL_TYPE
from ui.timeline.graph_curves import GraphCurve, bezier_ends
from ui.timeline.paint.ground import Pane, paint_grid, paint_key, paint_outside
from ui.timeline.paint.tracks import track_run
from ui.timeline.value_scale import ValueScale

MOST_KEYS = 400
"""Keys of one curve that are drawn; more lie closer than anybody could take."""

MOST_HANDLES = 120
"""Chosen keys whose handles are drawn."""

HANDLE = 3.4


def paint_graph(painter: QPainter, pane: Pane, curves: Sequence[GraphCurve], values: ValueScale, height: int) -> None:
    """Everything but the playhead."""
    paint_grid(painter, pane, height)
    _paint_values(painter, pane, values, height)
    for curve in curves:
        _paint_regions(painter, pane, curve, height)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for curve in curves:
        _paint_curve(painter, pane, curve, values)
    paint_outside(painter, pane, height)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for curve in curves:
        _paint_keys(painter, pane, curve, values)
    _paint_names(painter, pane, curves)


def key_places(pane: Pane, curve: GraphCurve, values: ValueScale) -> Iterator[tuple[int, QPointF]]:
    """The keys of a curve in sight, and where they are."""
    keys = curve.keys
    begin, end = pane.scale.time(-8), pane.scale.time(pane.width + 8)
    first, last = np.searchsorted(keys.times, [begin, end]).tolist()
    step = max((last - first) // MOST_KEYS, 1)
    for place in range(first, last, step):
        x, y = pane.scale.x(float(keys.times[place])), values.y(curve.factor * float(keys.values[place]))
        yield place, QPointF(x, y)


def handle_places(pane: Pane, curve: GraphCurve, values: ValueScale) -> Iterator[tuple[int, bool, QPointF]]:
    """The handles of the chosen keys of a curve: of which key, whether ahead of it, and where."""
    chosen = pane.chosen.keys.get(curve.row, ())
    for place in chosen[:MOST_HANDLES]:
        if place < len(curve.keys):
            for ahead, end in enumerate(bezier_ends(curve.keys, place)):
                if end is not None:
                    yield place, bool(ahead), QPointF(pane.scale.x(end[0]), values.y(curve.factor * end[1]))


def _paint_values(painter: QPainter, pane: Pane, values: ValueScale, height: int) -> None:
    painter.setFont(interface_font(SMALL_TYPE))
    weak, strong = blend(pane.ground, pane.theme.line, 0.5), blend(pane.ground, pane.theme.muted, 0.45)
    for value in values.lines(height):
        y = round(values.y(value)) + 0.5
        bold = abs(value) < 1e-9 or abs(value - 1.0) < 1e-9
        painter.setPen(QPen(strong if bold else weak, 1.0))
        painter.drawLine(QLineF(0, y, pane.width, y))
        painter.setPen(QColor(pane.theme.muted))
        painter.drawText(QPointF(4, y - 3), f"{value + 0.0:g}" if abs(value) > 1e-9 else "0")


def _paint_regions(painter: QPainter, pane: Pane, curve: GraphCurve, height: int) -> None:
    """Where the layer that is worked on may change its curve."""
    if curve.row[1] == 0:
        return
    tint = QColor(pane.theme.warn)
    tint.setAlphaF(0.08)
    for begin, end in regions(curve.track.layers[curve.row[1] - 1]):
        x = pane.scale.x(begin)
        painter.fillRect(QRectF(x, 0, pane.scale.x(end) - x, height), tint)


def _paint_curve(painter: QPainter, pane: Pane, curve: GraphCurve, values: ValueScale) -> None:
    times: FloatArray = pane.scale.begin + np.arange(pane.width + 2) / pane.scale.per_second
    low, high = track_run(curve.track, times)
    colour = QColor(curve.colour)
    colour.setAlphaF(0.4 if curve.track.muted else 1.0)
    if curve.track.captured is not None and curve.track.layers:
        _paint_captured(painter, pane, curve, values, times)
    painter.setPen(QPen(colour, 1.6))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawPolyline(_run(curve.factor * low, curve.factor * high, values))


def _paint_captured(painter: QPainter, pane: Pane, curve: GraphCurve, values: ValueScale, times: FloatArray) -> None:
    """What was captured, below what its layers make of it."""
    samples = curve.track.captured
    assert samples is not None
    shown = samples.at((times[:-1] + times[1:]) / 2)
    painter.setPen(QPen(blend(pane.ground, curve.colour, 0.45), 1.0, Qt.PenStyle.DotLine))
    painter.drawPolyline(_run(curve.factor * shown, curve.factor * shown, values))


def _run(low: FloatArray, high: FloatArray, values: ValueScale) -> QPolygonF:
    """A line pixel by pixel, up and down where there are many values under one."""
    lows, highs = ((values.top - each) * values.per_unit for each in (low, high))
    if np.allclose(lows, highs, atol=0.5):
        return QPolygonF([QPointF(x + 0.5, y) for x, y in enumerate(((lows + highs) / 2).tolist())])
    pairs = zip(lows.tolist(), highs.tolist(), strict=True)
    return QPolygonF([QPointF(x + 0.5, y) for x, pair in enumerate(pairs) for y in pair])


def _paint_keys(painter: QPainter, pane: Pane, curve: GraphCurve, values: ValueScale) -> None:
    chosen = set(pane.chosen.keys.get(curve.row, ()))
    own = dict(key_places(pane, curve, values))
    keys = curve.keys
    pen = QPen(blend(pane.ground, pane.theme.text, 0.6), 1.0)
    for place, _, end in handle_places(pane, curve, values):
        at = QPointF(pane.scale.x(float(keys.times[place])), values.y(curve.factor * float(keys.values[place])))
        painter.setPen(pen)
        painter.drawLine(at, end)
        painter.setBrush(QColor(pane.theme.text))
        painter.drawEllipse(end, HANDLE, HANDLE)
    for place, at in own.items():
        if place not in chosen:
            paint_key(painter, at.x(), at.y(), False, pane, locked=curve.track.locked)
    for place, at in own.items():
        if place in chosen:
            paint_key(painter, at.x(), at.y(), True, pane, 5.2)


def _paint_names(painter: QPainter, pane: Pane, curves: Sequence[GraphCurve]) -> None:
    """What is seen, in the upper right corner."""
    painter.setFont(interface_font(SMALL_TYPE))
    metrics = painter.fontMetrics()
    for number, curve in enumerate(curves[:8]):
        text = f"{curve.title} {curve.side if curve.side != 'both' else ''}".strip()
        wide = metrics.horizontalAdvance(text)
        x, y = pane.width - wide - 12, 16 + 15 * number
        painter.setPen(QPen(curve.colour, 2.0))
        painter.drawLine(QLineF(x - 16, y - 4, x - 6, y - 4))
        painter.setPen(QColor(pane.theme.muted))
        painter.drawText(QPointF(x, y), text)
