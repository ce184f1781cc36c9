"""Tracks and layers: the curve drawn small, keys upon it, and where a layer may change what it lies over."""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from app.timeline.lines import Line
from facemodel.animation.captured import displacement
from facemodel.animation.channels import channel_of
from facemodel.animation.curve import Curve
from facemodel.animation.displacement import Splines, regions
from facemodel.animation.editing.selection import Row, curve_of_row, unlocked
from facemodel.animation.keyed import values_of
from facemodel.animation.track import Track
from fem.types import FloatArray
from ui.theme.colour import blend
from ui.timeline.envelope import envelope
from ui.timeline.paint.ground import Pane, paint_key
from ui.timeline.paint.runs import draw_strip, run_image

MARGIN = 3
"""Pixels above and below a curve in its line."""

MOST_KEYS = 0.25
"""Keys per pixel beyond which they would be a solid bar: then only the chosen ones are drawn."""


def track_run(track: Track, times: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Lowest and highest value (n,) of a track between times (n + 1,), or its value where samples lie wider apart."""
    centres = (times[:-1] + times[1:]) / 2
    keyed = values_of(track.curve, centres)
    samples = track.captured
    if samples is None or not len(samples.values):
        return keyed, keyed
    bent = keyed + Splines([displacement(track)]).at(centres)[:, 0]
    if samples.rate * (times[-1] - times[0]) < len(centres):
        bent = bent + samples.at(centres)
        return bent, bent
    low, high = envelope(samples).between((times - samples.start) * samples.rate)
    return low + bent, high + bent


_reaches: WeakKeyDictionary[Track, tuple[float, float]] = WeakKeyDictionary()


def reach_of_track(track: Track, full: float, rigid: bool) -> tuple[float, float]:
    """The values that are drawn from the bottom to the top of a line: from rest to full, and whatever goes beyond."""
    found = _reaches.get(track)
    if found is None:
        ends = [0.0] if rigid else [0.0, full]
        for keys in (track.curve, *(layer.keys for layer in track.layers)):
            ends += [float(keys.values.min()), float(keys.values.max())] if len(keys) else []
        if track.captured is not None and len(track.captured.values):
            ends += [float(track.captured.values.min()), float(track.captured.values.max())]
        low, high = min(ends), max(ends)
        found = _reaches[track] = (low, high) if high - low > 1e-6 else (low - 1.0, high + 1.0)
    return found


class TrackPainter:
    """Paints tracks, and remembers the strips of those that are still the same."""

    def __init__(self) -> None:
        self._strips: dict[str, tuple[Track, tuple[object, ...], QImage]] = {}

    def paint(self, painter: QPainter, pane: Pane, line: Line, area: QRectF) -> None:
        """A track or a layer in its line."""
        track = pane.animation.track(line.channel)
        if track is None:
            return
        if line.kind == "layer":
            self._paint_region(painter, pane, track, line.layer, area)
        else:
            self._paint_curve(painter, pane, track, line, area)
        paint_keys(painter, pane, ((line.channel, line.layer),), area)

    def _paint_curve(self, painter: QPainter, pane: Pane, track: Track, line: Line, area: QRectF) -> None:
        height, width = round(area.height() * pane.ratio), round(area.width() * pane.ratio)
        look = (pane.scale, width, height, pane.theme.name)
        kept = self._strips.get(line.key)
        if kept is None or kept[0] is not track or kept[1] != look:
            kept = (track, look, self._strip(pane, track, line, width, height))
            self._strips[line.key] = kept
        draw_strip(painter, area, kept[2])

    def _strip(self, pane: Pane, track: Track, line: Line, width: int, height: int) -> QImage:
        channel = channel_of(track.channel, pane.units)
        times = pane.scale.begin + np.arange(width + 1) / (pane.scale.per_second * pane.ratio)
        low, high = reach_of_track(track, min(channel.high, 1.0), channel.rigid)
        margin = MARGIN * pane.ratio
        scale = (height - 2 * margin) / (high - low)
        below, above = ((height - margin) - scale * (each - low) for each in track_run(track, times))
        colour = pane.side(line.side)
        colour.setAlphaF(0.35 if track.muted else 0.9)
        return run_image(below, above, height - margin + scale * low, height, colour)

    def _paint_region(self, painter: QPainter, pane: Pane, track: Track, number: int, area: QRectF) -> None:
        """Where a layer may change the curve, and its knots."""
        layer = track.layers[number - 1]
        colour = QColor(pane.theme.warn)
        for begin, end in regions(layer):
            x, right = pane.scale.x(begin), pane.scale.x(end)
            if right < 0 or x > pane.width:
                continue
            region = QRectF(x, area.y() + 3, right - x, area.height() - 6)
            painter.fillRect(region, blend(pane.ground, colour, 0.10 if layer.muted else 0.24))
            self._paint_knots(painter, pane, (begin, end, layer.spacing), region)
            painter.setPen(QPen(blend(pane.ground, colour, 0.4 if layer.muted else 0.9), 1.0))
            painter.drawLine(region.topLeft(), region.bottomLeft())
            painter.drawLine(region.topRight(), region.bottomRight())

    def _paint_knots(self, painter: QPainter, pane: Pane, knots: tuple[float, float, float], region: QRectF) -> None:
        begin, end, spacing = knots
        if spacing * pane.scale.per_second < 6:
            return
        painter.setPen(QPen(blend(pane.ground, pane.theme.warn, 0.4), 1.0))
        for number in range(1, round((end - begin) / spacing)):
            x = pane.scale.x(begin + number * spacing)
            painter.drawLine(round(x), round(region.bottom()) - 4, round(x), round(region.bottom()))


def paint_keys(painter: QPainter, pane: Pane, rows: tuple[Row, ...], area: QRectF, size: float = 4.6) -> None:
    """Keys of some rows in one line: those of a row, or the sum of several."""
    inner = area.height() / 2 + area.y()
    held, free, marked = set[int](), set[int](), set[int]()
    changeable = unlocked(pane.animation, rows)
    for row in rows:
        curve = curve_of_row(pane.animation, row)
        marked |= _columns(pane, curve, np.array(pane.chosen.keys.get(row, ()), dtype=np.int64))
        seen = free if row in changeable else held
        seen |= _columns(pane, curve, np.arange(len(curve)))
    if len(held | free) > MOST_KEYS * pane.width:
        _paint_crowd(painter, pane, (held | free) - marked, inner)
        held, free = set(), set()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for x in sorted((held | free) - marked):
        paint_key(painter, x, inner, False, pane, size, x not in free)
    for x in sorted(marked):
        paint_key(painter, x, inner, True, pane, size)


def _columns(pane: Pane, curve: Curve, places: np.ndarray) -> set[int]:
    """The pixels at which some keys of a curve are seen."""
    if not len(places):
        return set()
    times = curve.times[places[places < len(curve)]]
    begin, end = pane.scale.time(-6), pane.scale.time(pane.width + 6)
    seen = times[(times >= begin) & (times <= end)]
    return set(np.unique(np.rint((seen - pane.scale.begin) * pane.scale.per_second).astype(np.int64)).tolist())


def _paint_crowd(painter: QPainter, pane: Pane, columns: set[int], y: float) -> None:
    """Keys too close to be told apart."""
    painter.setPen(Qt.PenStyle.NoPen)
    colour = blend(pane.ground, pane.theme.muted, 0.7)
    for x in columns:
        painter.fillRect(QRectF(x - 0.5, y - 2, 1, 4), colour)
