"""A line to type what one wants, and the list of what matches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QPainter, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QLineEdit,
    QListView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from ui.theme.apply import current_theme
from ui.theme.chosen import chosen_ground, quiet_ink
from ui.theme.colour import blend
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW

WIDTH = 64 * GRID
MOST_ROWS = 12
KEYS = 16 * GRID
"""Room for the keys, at the right of the section."""
ENTRY = Qt.ItemDataRole.UserRole + 1


@dataclass(frozen=True)
class PaletteEntry:
    """One line of the palette.

    Attributes
    ----------
    title : what it does
    section : where it belongs
    keys : how it is also reached
    letters : places in the title of the letters that were typed
    enabled : whether it can be run now
    payload : what `CommandPalette.chosen` carries
    """

    title: str
    section: str
    keys: str = ""
    letters: tuple[int, ...] = ()
    enabled: bool = True
    payload: object = None


Rank = Callable[[str], Sequence[PaletteEntry]]
"""The entries that match what was typed, the best first; all of them for nothing typed."""


class CommandPalette(QFrame):
    """Lies over a window; Enter runs the marked line, Esc and a click elsewhere close it.

    Signals
    -------
    chosen(object) : payload of the entry to run
    """

    chosen = Signal(object)

    def __init__(self, host: QWidget, rank: Rank) -> None:
        super().__init__(host)
        self.setProperty("role", "card")
        self.setAccessibleName("Command palette")
        self._rank = rank
        self.line = _Line()
        self.line.setPlaceholderText("Type a command")
        self.line.setAccessibleName("Command")
        self.line.addAction(icon("chevron-right"), QLineEdit.ActionPosition.LeadingPosition)
        self._model = QStandardItemModel(self)
        self.list = QListView()
        self.list.setModel(self._model)
        self.list.setItemDelegate(_EntryDelegate(self.list))
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.list.setMouseTracking(True)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setUniformItemSizes(True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, GRID, GRID, GRID)
        layout.setSpacing(GRID)
        layout.addWidget(self.line)
        layout.addWidget(self.list)
        self.line.textChanged.connect(self._refill)
        self.line.moved.connect(self._move)
        self.line.accepted.connect(self._run_current)
        self.line.abandoned.connect(self.close_palette)
        self.list.clicked.connect(self._run)
        self.hide()

    def open_palette(self) -> None:
        """Appear over the upper middle of the window, empty."""
        self.line.clear()
        self._refill("")
        self.show()
        self.raise_()
        self.line.setFocus(Qt.FocusReason.PopupFocusReason)

    def close_palette(self) -> None:
        """Go away and give the keyboard back."""
        if self.isVisible():
            self.hide()
            self.parentWidget().setFocus(Qt.FocusReason.PopupFocusReason)

    def place(self) -> None:
        """Take the place and size that suit the window and the number of entries."""
        host = self.parentWidget().rect()
        width = min(WIDTH, host.width() - 4 * GRID)
        rows = min(max(self._model.rowCount(), 1), MOST_ROWS)
        height = rows * ROW + ROW + 3 * GRID + 2
        self.setGeometry(QRect((host.width() - width) // 2, 8 * GRID, width, min(height, host.height() - 12 * GRID)))

    def _refill(self, text: str) -> None:
        self._model.clear()
        for entry in self._rank(text):
            item = QStandardItem(entry.title)
            item.setData(entry, ENTRY)
            item.setEnabled(entry.enabled)
            self._model.appendRow(item)
        self._move(0)
        self.place()

    def _move(self, steps: int) -> None:
        """Mark another line; steps wrap round and skip what cannot be run now."""
        rows = self._model.rowCount()
        here = self.list.currentIndex().row() if steps else -1
        direction = -1 if steps < 0 else 1
        for n in range(1, rows + 1):
            row = (here + direction * n) % rows
            if self._model.item(row).isEnabled():
                self.list.setCurrentIndex(self._model.index(row, 0))
                return

    def _run_current(self) -> None:
        self._run(self.list.currentIndex())

    def _run(self, index: QModelIndex) -> None:
        entry = index.data(ENTRY)
        if entry is not None and entry.enabled:
            self.close_palette()
            self.chosen.emit(entry.payload)


class _Line(QLineEdit):
    """Typing, and the keys that walk through the list."""

    moved = Signal(int)
    accepted = Signal()
    abandoned = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        if key in (Qt.Key.Key_Down, Qt.Key.Key_Up):
            self.moved.emit(1 if key == Qt.Key.Key_Down else -1)
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.accepted.emit()
        elif key == Qt.Key.Key_Escape:
            self.abandoned.emit()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        if event.reason() not in (Qt.FocusReason.ActiveWindowFocusReason, Qt.FocusReason.PopupFocusReason):
            self.abandoned.emit()


class _EntryDelegate(QStyledItemDelegate):
    """Title at the left, section and keys at the right."""

    def sizeHint(self, _option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex) -> QSize:
        return QSize(WIDTH // 2, ROW)

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        entry: PaletteEntry = index.data(ENTRY)
        theme = current_theme()
        marked = option.state & option.state.State_Selected
        if marked:
            painter.fillRect(option.rect, chosen_ground(theme))
        elif option.state & option.state.State_MouseOver:
            painter.fillRect(option.rect, QColor(theme.hover))
        line = option.rect.adjusted(GRID, 0, -GRID, 0)
        painter.setFont(QApplication.font())
        centre = Qt.AlignmentFlag.AlignVCenter
        faint = blend(theme.panel, theme.muted, 0.55)
        painter.setPen(QColor(theme.text) if entry.enabled else faint)
        title = line.adjusted(0, 0, -_told_width(painter, entry), 0)
        shown = painter.fontMetrics().elidedText(entry.title, Qt.TextElideMode.ElideRight, title.width())
        painter.drawText(title, centre | Qt.AlignmentFlag.AlignLeft, shown)
        _underline(painter, title, entry)
        painter.setPen(quiet_ink(theme, marked) if entry.enabled else faint)
        painter.drawText(line, centre | Qt.AlignmentFlag.AlignRight, entry.keys)
        room = line.adjusted(0, 0, -KEYS, 0)
        painter.drawText(room, centre | Qt.AlignmentFlag.AlignRight, entry.section)


def _told_width(painter: QPainter, entry: PaletteEntry) -> int:
    """What section and keys of a line take of its width, with air before them."""
    metrics = painter.fontMetrics()
    section = KEYS + metrics.horizontalAdvance(entry.section) if entry.section else 0
    return max(section, metrics.horizontalAdvance(entry.keys)) + 2 * GRID


def _underline(painter: QPainter, line: QRect, entry: PaletteEntry) -> None:
    """A thin line in the accent under the letters that were typed."""
    metrics = painter.fontMetrics()
    y = line.center().y() + metrics.ascent() // 2 + 3
    painter.setPen(QColor(current_theme().accent))
    for place in entry.letters:
        left = line.left() + metrics.horizontalAdvance(entry.title[:place])
        right = line.left() + metrics.horizontalAdvance(entry.title[: place + 1])
        if right <= line.right():
            painter.drawLine(left, y, right - 1, y)
