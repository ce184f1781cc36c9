"""The table of depths: a line for each landmark, what is wanted, and what is on both sides."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from facemodel.skull.naming import SIDES, spoken
from facemodel.skull.tissue_depths import LandmarkDepth
from ui.theme.apply import current_theme, interface_font
from ui.theme.metrics import GRID, SMALL_TYPE
from ui.theme.roles import Theme

LINE = 20
"""Pixels."""

COLUMN = 56
"""Pixels of a column of numbers."""

NOTABLE, GRAVE = 2.0, 5.0
"""Millimetres off from which a depth is marked: people differ by the first, hardly by the second."""

TITLES = ("wanted", "right", "left")


@dataclass(frozen=True)
class _Line:
    """A landmark of the midline, or both of a pair."""

    title: str
    wanted: float
    right: LandmarkDepth | None
    left: LandmarkDepth | None


class DepthTable(QWidget):
    """Draws the lines and tells where the pointer is.

    Signals
    -------
    pointed(str) : the landmark under the pointer, empty for none
    asked(str) : a landmark was double-clicked, to be brought near
    """

    pointed = Signal(str)
    asked = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._lines: tuple[_Line, ...] = ()
        self._pointed = ""
        self.setMouseTracking(True)
        self.setAccessibleName("Depths at landmarks, millimetres")
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_landmarks(self, landmarks: Sequence[LandmarkDepth]) -> None:
        """Show other depths."""
        self._lines = _lines(landmarks)
        self.setFixedHeight(LINE * (len(self._lines) + 1) if self._lines else 0)
        self.update()

    @property
    def lines(self) -> tuple[str, ...]:
        """What is written, line by line."""
        return tuple(f"{line.title}: {', '.join(_cells(line))}" for line in self._lines)

    def landmark_at(self, x: float, y: float) -> str:
        """The landmark whose number is at a place; that of the midline, or of the right side, where only a name is."""
        row = int(y // LINE) - 1
        if not 0 <= row < len(self._lines):
            return ""
        line = self._lines[row]
        on_left = x >= self.width() - COLUMN and line.left is not None
        found = line.left if on_left else line.right or line.left
        return found.name if found is not None else ""

    def sizeHint(self) -> QSize:
        """As wide as there is room."""
        return QSize(30 * GRID, LINE * (len(self._lines) + 1))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Say what is under the pointer."""
        self._point(self.landmark_at(event.position().x(), event.position().y()))

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Bring it near."""
        name = self.landmark_at(event.position().x(), event.position().y())
        if name:
            self.asked.emit(name)

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is under the pointer."""
        super().leaveEvent(event)
        self._point("")

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw heading and lines."""
        if not self._lines:
            return
        painter, theme = QPainter(self), current_theme()
        painter.setFont(interface_font(SMALL_TYPE))
        painter.setPen(QColor(theme.muted))
        for column, title in enumerate(TITLES):
            painter.drawText(self._cell(column, 0), RIGHT, title)
        painter.drawText(self._name(0), LEFT, "mm")
        painter.setFont(self.font())
        for row, line in enumerate(self._lines, start=1):
            self._paint_line(painter, theme, row, line)

    def _paint_line(self, painter: QPainter, theme: Theme, row: int, line: _Line) -> None:
        for column, own in ((1, line.right), (2, line.left)):
            if own is not None and own.name == self._pointed:
                whole = self._cell(1, row).united(self._cell(2, row)) if line.left is line.right else None
                painter.fillRect(whole or self._cell(column, row), QColor(theme.hover))
        painter.setPen(QColor(theme.text))
        painter.drawText(self._name(row), LEFT, line.title)
        painter.setPen(QColor(theme.muted))
        wanted, *cells = _cells(line)
        painter.drawText(self._cell(0, row), RIGHT, wanted)
        places = [self._cell(1, row).united(self._cell(2, row))] if len(cells) == 1 else [self._cell(1, row)]
        places += [self._cell(2, row)] if len(cells) == 2 else []
        for place, text, own in zip(places, cells, (line.right, line.left), strict=False):
            painter.setPen(QColor(_colour(theme, own)))
            centred = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignHCenter
            painter.drawText(place, centred if len(cells) == 1 else RIGHT, text)

    def _cell(self, column: int, row: int) -> QRectF:
        return QRectF(self.width() - (3 - column) * COLUMN, row * LINE, COLUMN - GRID // 2, LINE)

    def _name(self, row: int) -> QRectF:
        return QRectF(0, row * LINE, self.width() - 3 * COLUMN, LINE)

    def _point(self, name: str) -> None:
        if name != self._pointed:
            self._pointed = name
            self.pointed.emit(name)
            self.update()


LEFT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
RIGHT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight


def _lines(landmarks: Sequence[LandmarkDepth]) -> tuple[_Line, ...]:
    """Both sides of a pair in one line."""
    found: dict[str, _Line] = {}
    for each in landmarks:
        side = SIDES.get(each.name[-2:])
        name = each.name[:-2] if side else each.name
        title = spoken(name)[:1].upper() + spoken(name)[1:]
        before = found.get(name)
        right = each if side != "left" else before and before.right
        left = each if side != "right" else before and before.left
        found[name] = _Line(title, each.wanted, right or None, left or None)
    return tuple(found.values())


def _cells(line: _Line) -> list[str]:
    own = [line.right] if line.right is line.left else [line.right, line.left]
    return [f"{line.wanted:.1f}", *("–" if each is None else f"{each.measured:.1f}" for each in own)]


def _colour(theme: Theme, landmark: LandmarkDepth | None) -> str:
    off = 0.0 if landmark is None else abs(landmark.off)
    return theme.error if off >= GRAVE else theme.warn if off >= NOTABLE else theme.text
