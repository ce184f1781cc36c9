"""The body of the timeline: heads at the left, the ruler and the sheet under it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLineEdit, QScrollBar, QSplitter, QVBoxLayout, QWidget

from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW
from ui.timeline.heads import Heads
from ui.timeline.keys import action_of
from ui.timeline.line_paint import LinePainter
from ui.timeline.paint.ruler import HEIGHT
from ui.timeline.ruler import Ruler
from ui.timeline.sheet import Sheet
from ui.timeline.view import TimelineView
from ui.window.action_binding import ActionBinding

HEADS_WIDTH = 31 * GRID


class SearchLines(QLineEdit):
    """Searches among the lines; Esc empties it."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc leads away, the rest is typing."""
        if event.key() == Qt.Key.Key_Escape and self.text():
            self.clear()
        else:
            super().keyPressEvent(event)


class TimelinePanel(QWidget):
    """Everything below the transport.

    Signals
    -------
    advised(str) : what keys change about the gesture under way; empty when it is over
    failed(str) : why a gesture came to nothing

    Parameters
    ----------
    view : what part of which timeline is seen
    binding : the actions of the window
    painter : paints the lines
    """

    advised = Signal(str)
    failed = Signal(str)

    def __init__(self, view: TimelineView, binding: ActionBinding, painter: LinePainter) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        timeline = self._timeline = view.timeline
        self._binding, self.view = binding, view
        self.heads, self.ruler = Heads(self.view), Ruler(self.view)
        self.sheet = Sheet(self.view, painter)
        self.search = SearchLines()
        self.scroll = QScrollBar(Qt.Orientation.Vertical)
        self._lay_out()
        for part in (self.heads, self.ruler, self.sheet):
            part.advised.connect(self.advised)
            part.failed.connect(self.failed)
        for part in (self.heads, self.sheet):
            part.key_pressed.connect(self._press_key)
            part.installEventFilter(self)
        self.search.textChanged.connect(lambda text: timeline.change(sought=text))
        self.scroll.valueChanged.connect(self.view.scroll)
        for signal in (self.view.moved, self.view.relaid):
            signal.connect(self._follow_scroll)
        timeline.playhead.moved.connect(self._reveal)

    def eventFilter(self, _watched: object, event: QEvent) -> bool:
        """Keep the keys that mean something here, before a shortcut of the window takes them."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and action_of(event):
            event.accept()
            return True
        return False

    def _lay_out(self) -> None:
        self.search.setPlaceholderText("Filter")
        self.search.setAccessibleName("Filter tracks")
        self.search.setClearButtonEnabled(True)
        self.search.addAction(icon("magnify"), QLineEdit.ActionPosition.LeadingPosition)
        corner = QWidget()
        corner.setFixedHeight(HEIGHT)
        room = QVBoxLayout(corner)
        room.setContentsMargins(GRID, (HEIGHT - ROW) // 2, GRID, (HEIGHT - ROW) // 2)
        room.addWidget(self.search)
        left, right = QWidget(), QWidget()
        for side, parts in ((left, (corner, self.heads)), (right, (self.ruler, self.sheet))):
            column = QVBoxLayout(side)
            column.setContentsMargins(0, 0, 0, 0)
            column.setSpacing(0)
            column.addWidget(parts[0])
            column.addWidget(parts[1], 1)
        self.split = QSplitter(Qt.Orientation.Horizontal)
        self.split.setHandleWidth(3)
        self.split.setChildrenCollapsible(False)
        self.split.addWidget(left)
        self.split.addWidget(right)
        self.split.setStretchFactor(1, 1)
        self.split.setSizes([HEADS_WIDTH, 100 * GRID])
        top = QFrame()
        top.setProperty("role", "line")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(top)
        row = QHBoxLayout()
        row.setSpacing(0)
        row.addWidget(self.split, 1)
        row.addWidget(self.scroll)
        layout.addLayout(row, 1)

    def _press_key(self, event: QKeyEvent) -> None:
        """A key that means something to the timeline while it has the focus."""
        key = action_of(event)
        if key:
            event.accept()
            self._binding.perform(key)

    def _follow_scroll(self) -> None:
        self.scroll.blockSignals(True)
        self.scroll.setRange(0, self.view.lowest)
        self.scroll.setPageStep(self.view.height)
        self.scroll.setValue(self.view.top)
        self.scroll.blockSignals(False)
        self.scroll.setVisible(self.view.lowest > 0)

    def _reveal(self, time: float) -> None:
        if self._timeline.playhead.playing:
            self.view.reveal(time)
