"""Speech: words over the sounds that they are made of, each sound in the shade of how much the lips do for it."""

from __future__ import annotations

from bisect import bisect_left, bisect_right

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.timeline.lines import Line
from facemodel.animation.speech import VisemeTable
from facemodel.animation.visemes import mouth_table
from ui.theme.apply import interface_font
from ui.theme.colour import blend
from ui.theme.metrics import SMALL_TYPE
from ui.timeline.paint.ground import Pane, elided

WORDS = 15
"""Pixels of the strip of words above the sounds."""

LEAST_WRITTEN = 9
"""Pixels below which a sound has no room for its symbol."""

LEAST_WORD = 26
"""Pixels below which a word has no room for its first letters."""


def sounds_area(area: QRectF) -> QRectF:
    """The strip of the sounds in the line."""
    return area.adjusted(0, WORDS, 0, -3)


def paint_speech(painter: QPainter, pane: Pane, _line: Line, area: QRectF) -> None:
    """All sounds and words in sight."""
    speech = pane.animation.speech
    table = VisemeTable(speech.visemes or mouth_table().visemes)
    strip = sounds_area(area)
    painter.setFont(interface_font(SMALL_TYPE))
    begin, end = pane.scale.begin, pane.scale.end(pane.width)
    first = max(bisect_left(speech.phonemes, begin, key=lambda each: each.start) - 1, 0)
    last = bisect_right(speech.phonemes, end, key=lambda each: each.start)
    for place in range(first, last):
        sound = speech.phonemes[place]
        x = pane.scale.x(sound.start)
        body = QRectF(x, strip.y(), max(pane.scale.x(sound.end) - x, 1.0), strip.height())
        viseme = table.find(sound.symbol)
        shade = 0.06 if viseme is None else 0.14 + 0.3 * viseme.dominance
        _paint_sound(painter, pane, body, sound.symbol, shade, place in pane.chosen.sounds)
    for word in speech.words:
        if word.end >= begin and word.start <= end:
            _paint_word(painter, pane, QRectF(pane.scale.x(word.start), area.y() + 1, 0, WORDS), word.text, word.end)


def _paint_sound(painter: QPainter, pane: Pane, body: QRectF, symbol: str, shade: float, chosen: bool) -> None:
    theme = pane.theme
    fill = QColor(theme.accent) if chosen else blend(pane.ground, theme.ok, shade)
    painter.fillRect(body.adjusted(0, 0, -1, 0) if body.width() > 2 else body, fill)
    if body.width() >= LEAST_WRITTEN:
        painter.setPen(QColor(theme.on_accent if chosen else theme.text))
        painter.drawText(body, Qt.AlignmentFlag.AlignCenter, elided(painter, symbol, body.width()))


def _paint_word(painter: QPainter, pane: Pane, place: QRectF, text: str, end: float) -> None:
    left, right = place.x(), pane.scale.x(end)
    painter.setPen(QPen(blend(pane.ground, pane.theme.muted, 0.5), 1.0))
    painter.drawLine(int(left), int(place.bottom()) - 1, int(max(right - 2, left)), int(place.bottom()) - 1)
    if right - left < LEAST_WORD:
        return
    room = QRectF(left, place.y(), max(right - left - 2, 0), place.height() - 2)
    painter.setPen(QColor(pane.theme.text))
    painter.drawText(
        room, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, elided(painter, text, room.width())
    )
