"""Rows of a list that are dragged to another place: a line says where, the rest of the list stays as it is."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QApplication

from ui.theme.apply import current_theme
from ui.theme.metrics import ROW

LINE = 2
SCROLL = 6
"""Pixels of scrolling for every movement near an edge."""


@dataclass(frozen=True)
class Drop:
    """A place that a row can be let go at.

    Attributes
    ----------
    target : what it means to the list
    y : where the line is drawn, pixels from the top of what is seen
    """

    target: object
    y: int


class RowDrag:
    """Mixed into an item view with a signal ``dropped(object, object)``: the row that was dragged, and a target.

    The view says what a row is by `row_at` and where rows can go by `drop_at`.
    """

    _pressed: QPoint | None = None
    _dragged: object = None
    _drop: Drop | None = None

    def row_at(self, place: QPoint) -> object:
        """What can be dragged from a place; None where nothing can."""
        raise NotImplementedError

    def drop_at(self, place: QPoint) -> Drop | None:
        """Where a row that is let go at a place comes to stand."""
        raise NotImplementedError

    def take_back(self) -> bool:
        """Leave the row in hand where it is; whether there was one."""
        held, self._pressed = self._pressed is not None, None
        self._end_drag()
        return held

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose a row, which may be about to be dragged."""
        super().mousePressEvent(event)  # type: ignore[misc]
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed = event.position().toPoint()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the row, once it is farther than a click trembles."""
        place = event.position().toPoint()
        if self._pressed is None or not event.buttons() & Qt.MouseButton.LeftButton:
            super().mouseMoveEvent(event)  # type: ignore[misc]
            return
        if self._dragged is None:
            far = (place - self._pressed).manhattanLength() >= QApplication.startDragDistance()
            self._dragged = self.row_at(self._pressed) if far else None
        if self._dragged is not None:
            self._scroll(place)
            self._drop = self.drop_at(place)
            self.viewport().setCursor(Qt.CursorShape.ClosedHandCursor)
            self.viewport().update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let the row go where the line is."""
        dragged, drop = self._dragged, self._drop
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed = None
        if dragged is None or self._pressed is not None:
            super().mouseReleaseEvent(event)  # type: ignore[misc]
            return
        self._end_drag()
        if drop is not None:
            self.dropped.emit(dragged, drop.target)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The rows, and the line between them."""
        super().paintEvent(event)  # type: ignore[misc]
        if self._drop is not None:
            painter = QPainter(self.viewport())
            y = min(max(self._drop.y - LINE // 2, 0), self.viewport().height() - LINE)
            painter.fillRect(0, y, self.viewport().width(), LINE, QColor(current_theme().accent))

    def _scroll(self, place: QPoint) -> None:
        """Bring on what is beyond the edge that the pointer is at."""
        bar = self.verticalScrollBar()
        if place.y() < ROW:
            bar.setValue(bar.value() - SCROLL)
        elif place.y() > self.viewport().height() - ROW:
            bar.setValue(bar.value() + SCROLL)

    def _end_drag(self) -> None:
        self._dragged = self._drop = None
        self.viewport().unsetCursor()
        self.viewport().update()
