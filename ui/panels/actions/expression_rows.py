"""Rows of named expressions: portrait, name and recipe; they are dragged to another place, or out onto the pad."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QPoint, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QKeySequence, QMouseEvent, QPainter, QPainterPath, QPaintEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QListWidget,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from ui.theme.apply import current_theme, interface_font
from ui.theme.chosen import chosen_ground, quiet_ink
from ui.theme.metrics import GRID, RADIUS, SMALL_TYPE
from ui.widgets.empty_view import paint_empty
from ui.widgets.portrait_paint import paint_portrait
from ui.widgets.row_drag import Drop, RowDrag

NAME = Qt.ItemDataRole.UserRole + 1
RECIPE = Qt.ItemDataRole.UserRole + 2
"""What an expression is made of, as a short text."""

PORTRAIT = Qt.ItemDataRole.UserRole + 3
"""Its picture; none before it was taken."""

SHOWN = Qt.ItemDataRole.UserRole + 4
"""Whether the face shows it."""

PLACED = Qt.ItemDataRole.UserRole + 5
"""Whether it lies on the pad."""

EMPTY = "No expression yet. Move some sliders, then keep them with the plus below."
ROW_HEIGHT = 48
PICTURE = QSize(40, 44)
TEXT_LEFT = PICTURE.width() + 2 * GRID
DOT = 5.0

Cell = QModelIndex | QPersistentModelIndex
STEPS = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}


class ExpressionCells(QStyledItemDelegate):
    """Draws an expression, and lets its name be edited where it stands."""

    def sizeHint(self, _option: QStyleOptionViewItem, _index: Cell) -> QSize:
        """One row of any width."""
        return QSize(0, ROW_HEIGHT)

    def updateEditorGeometry(self, editor: QWidget, option: QStyleOptionViewItem, _index: Cell) -> None:
        """Beside the picture."""
        area = option.rect.adjusted(TEXT_LEFT - GRID, 0, -GRID, 0)
        editor.setGeometry(QRect(area.x(), area.y() + 2, area.width(), 26))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Cell) -> None:
        """Draw one row."""
        theme, area = current_theme(), QRectF(option.rect)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        chosen = bool(option.state & QStyle.StateFlag.State_Selected)
        if chosen:
            painter.fillRect(area, chosen_ground(theme))
        elif option.state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(area, QColor(theme.hover))
        if index.data(SHOWN):
            painter.fillRect(QRectF(area.x(), area.y(), 2, area.height()), QColor(theme.accent))
        shape = QPainterPath()
        place = QRectF(area.x() + GRID, area.y() + (area.height() - PICTURE.height()) / 2, PICTURE.width(), 44)
        shape.addRoundedRect(place, RADIUS, RADIUS)
        paint_portrait(painter, shape, index.data(PORTRAIT))
        self._paint_words(painter, area.adjusted(TEXT_LEFT, 5, -GRID, -5), index, chosen)
        painter.restore()

    def _paint_words(self, painter: QPainter, room: QRectF, index: Cell, chosen: bool) -> None:
        theme = current_theme()
        if index.data(PLACED):
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(theme.muted))
            painter.drawEllipse(QRectF(room.right() - DOT, room.y() + 7, DOT, DOT))
        left, top = Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignTop
        painter.setPen(QColor(theme.text))
        painter.drawText(
            room, left | top, _short(painter, index.data(Qt.ItemDataRole.DisplayRole), room.width() - 2 * GRID)
        )
        painter.setFont(interface_font(SMALL_TYPE))
        painter.setPen(quiet_ink(theme, chosen))
        painter.drawText(room, left | Qt.AlignmentFlag.AlignBottom, _short(painter, index.data(RECIPE), room.width()))


class ExpressionRows(RowDrag, QListWidget):
    """The list itself.

    Signals
    -------
    deleted(), shown_now(), copied(), pasted() : the keys Delete, Enter, Ctrl+C and Ctrl+V were pressed
    stepped(int) : Alt and an arrow were pressed, up -1 or down 1
    dropped(object, object) : the name of a row that was dragged, and the place in the list that it goes to
    carried(object, object) : a row is dragged outside the list, over a QPoint of the screen, or None: no longer
    carried_off(object, QPoint) : it was let go there
    """

    deleted = Signal()
    shown_now = Signal()
    copied = Signal()
    pasted = Signal()
    stepped = Signal(int)
    dropped = Signal(object, object)
    carried = Signal(object, object)
    carried_off = Signal(object, QPoint)

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName("Expressions")
        self.setItemDelegate(ExpressionCells(self))
        self.setMouseTracking(True)
        self.setMinimumHeight(2 * ROW_HEIGHT)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setEditTriggers(QAbstractItemView.EditTrigger.EditKeyPressed)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keys mean the chosen expression; while a name is edited they are its own."""
        key, alt = event.key(), bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
        if self.state() == QAbstractItemView.State.EditingState:
            super().keyPressEvent(event)
        elif alt and key in STEPS:
            self.stepped.emit(STEPS[Qt.Key(key)])
        elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.deleted.emit()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.shown_now.emit()
        elif event.matches(QKeySequence.StandardKey.Copy):
            self.copied.emit()
        elif event.matches(QKeySequence.StandardKey.Paste):
            self.pasted.emit()
        else:
            super().keyPressEvent(event)

    def take_back(self) -> bool:
        """Leave the row in hand where it is, and off whatever it is over; whether there was one."""
        self.carried.emit(self._dragged, None)
        return super().take_back()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """A row that leaves the list is carried over whatever is there."""
        super().mouseMoveEvent(event)
        place = event.position().toPoint()
        if self._dragged is not None and not self.viewport().rect().contains(place):
            self._drop = None
            self.viewport().update()
            self.carried.emit(self._dragged, self.viewport().mapToGlobal(place))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let the row go here or there."""
        place, dragged = event.position().toPoint(), self._dragged
        super().mouseReleaseEvent(event)
        if dragged is not None and not self.viewport().rect().contains(place):
            self.carried_off.emit(dragged, self.viewport().mapToGlobal(place))

    def paintEvent(self, event: QPaintEvent) -> None:
        """The rows, or what to do to have some."""
        super().paintEvent(event)
        if not self.count():
            paint_empty(self, EMPTY)

    def row_at(self, place: QPoint) -> object:
        """The name of the expression at a place."""
        item = self.itemAt(place)
        return item.data(NAME) if item is not None else None

    def drop_at(self, place: QPoint) -> Drop | None:
        """In front of the expression or behind it, whichever half the pointer is on."""
        if not self.viewport().rect().contains(place):
            return None
        item = self.itemAt(place)
        if item is None:
            last = self.item(self.count() - 1)
            return Drop(self.count(), self.visualItemRect(last).bottom()) if last is not None else None
        area, row = self.visualItemRect(item), self.row(item)
        return Drop(row, area.top()) if place.y() < area.center().y() else Drop(row + 1, area.bottom() + 1)


def _short(painter: QPainter, words: str, room: float) -> str:
    return painter.fontMetrics().elidedText(words, Qt.TextElideMode.ElideRight, int(room))
