"""The sound of the animation as a waveform."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter

from app.timeline.lines import Line
from app.timeline.sounds import SoundShelf
from facemodel.sameness import Kept
from ui.theme.apply import interface_font
from ui.theme.colour import blend
from ui.theme.metrics import SMALL_TYPE
from ui.timeline.paint.ground import Pane, elided
from ui.timeline.paint.runs import draw_strip, run_image


class SoundPainter:
    """Paints the sound on a shelf, and remembers the strip as long as it is the same.

    Parameters
    ----------
    shelf : where the sound is
    """

    def __init__(self, shelf: SoundShelf) -> None:
        self._shelf = shelf
        self._strip: Kept[QImage] = Kept()

    def paint(self, painter: QPainter, pane: Pane, _line: Line, area: QRectF) -> None:
        """The waveform, or why there is none."""
        audio, heard = pane.animation.audio, self._shelf.heard
        if audio is None:
            return
        if heard is None:
            self._say(painter, pane, area, self._shelf.complaint or "Reading the sound …")
            return
        x, right = pane.scale.x(audio.start), pane.scale.x(audio.start + heard.sound.duration)
        body = QRectF(x, area.y() + 2, right - x, area.height() - 5)
        painter.fillRect(body.intersected(area), blend(pane.ground, pane.theme.ok, 0.10))
        key = (heard.outline.rate, len(heard.outline.samples), audio.start, audio.muted, pane.scale, pane.width)
        look = (area.height(), pane.theme.name, pane.ratio, str(heard.path))
        draw_strip(painter, area, self._strip.get((*key, *look), lambda: self._made(pane, area)))

    def _made(self, pane: Pane, area: QRectF) -> QImage:
        audio, heard = pane.animation.audio, self._shelf.heard
        assert audio is not None
        assert heard is not None
        width, height = round(area.width() * pane.ratio), round(area.height() * pane.ratio)
        begin, end = pane.scale.begin - audio.start, pane.scale.end(pane.width) - audio.start
        peaks = heard.outline.peaks(begin, end, width).astype(np.float64)
        loudest = float(np.abs(heard.outline.samples).max(initial=0.0)) or 1.0
        middle = height / 2
        scale = (middle - 3.0) / loudest
        colour = QColor(pane.theme.ok)
        colour.setAlphaF(0.3 if audio.muted else 0.85)
        times = np.linspace(begin, end, width)
        outside = (times < 0) | (times > heard.sound.duration)
        low, high = middle - scale * peaks[:, 0], middle - scale * peaks[:, 1]
        low[outside] = high[outside] = np.nan
        return run_image(low, high, middle, height, colour, 0.5)

    def _say(self, painter: QPainter, pane: Pane, area: QRectF, text: str) -> None:
        painter.setFont(interface_font(SMALL_TYPE))
        painter.setPen(QColor(pane.theme.warn if self._shelf.complaint else pane.theme.muted))
        room = area.adjusted(max(pane.scale.x(0.0), 0.0) + 8, 0, -8, 0)
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter, elided(painter, text, room.width()))
