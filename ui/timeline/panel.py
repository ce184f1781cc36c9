"""The body of the timeline: heads at the left, the ruler and the sheet under it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLineEdit,
    QScrollBar,
    QSplitter,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.timeline.keying import insert_key
from app.timeline.state import TimelineState
from app.timeline.switches import flip_clips
from facemodel.errors import RisoriusError
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW
from ui.timeline.empty_hint import EmptyHint
from ui.timeline.graph import Graph
from ui.timeline.heads import Heads
from ui.timeline.hits import Hit
from ui.timeline.inspector.inspector import Inspector
from ui.timeline.keys import action_of
from ui.timeline.line_paint import LinePainter
from ui.timeline.menus import TimelineMenus
from ui.timeline.paint.ruler import HEIGHT
from ui.timeline.ruler import Ruler
from ui.timeline.sheet import Sheet
from ui.timeline.view import TimelineView
from ui.window.action_binding import ActionBinding

HEADS_WIDTH = 31 * GRID

ROOM_FOR_FIELDS = 84 * GRID
"""Pixels below which the fields at the right are left out unless they are asked for."""


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
    inspector : the column of fields at the right
    """

    advised = Signal(str)
    failed = Signal(str)

    def __init__(self, view: TimelineView, binding: ActionBinding, painter: LinePainter, inspector: Inspector) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        timeline = self._timeline = view.timeline
        self._binding, self.view = binding, view
        self.heads, self.ruler = Heads(self.view), Ruler(self.view)
        self.sheet, self.graph = Sheet(self.view, painter), Graph(self.view)
        self.inspector = inspector
        self.menus = TimelineMenus(self, timeline, binding)
        self.empty = EmptyHint(self.sheet, timeline, binding)
        self.search = SearchLines()
        self.scroll = QScrollBar(Qt.Orientation.Vertical)
        self._lay_out()
        for part in (self.heads, self.ruler, self.sheet, self.graph):
            part.advised.connect(self.advised)
            part.failed.connect(self.failed)
        for part in (self.heads, self.sheet, self.graph):
            part.key_pressed.connect(self._press_key)
            part.installEventFilter(self)
        for canvas in (self.sheet, self.graph):
            canvas.asked.connect(self.menus.about_hit)
            canvas.opened.connect(self._open_hit)
        self.heads.asked.connect(self.menus.about_line)
        self.ruler.asked.connect(self.menus.about_time)
        self.ruler.opened.connect(self._open_moment)
        self.search.textChanged.connect(lambda text: timeline.change(sought=text))
        self.scroll.valueChanged.connect(self.view.scroll)
        for signal in (self.view.moved, self.view.relaid):
            signal.connect(self._follow_scroll)
        timeline.playhead.moved.connect(self._reveal)
        timeline.changed.connect(self._follow_mode)

    def eventFilter(self, _watched: object, event: QEvent) -> bool:
        """Keep the keys that mean something here, before a shortcut of the window takes them."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and action_of(event):
            event.accept()
            return True
        return False

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where there is little room, the fields make way for what they are about."""
        super().resizeEvent(event)
        self.inspector.suit(event.size().width() >= ROOM_FOR_FIELDS)

    def _lay_out(self) -> None:
        self.stack = QStackedWidget()
        self.stack.addWidget(self.sheet)
        self.stack.addWidget(self.graph)
        self.split = QSplitter(Qt.Orientation.Horizontal)
        self.split.setHandleWidth(3)
        self.split.setChildrenCollapsible(False)
        self.split.addWidget(_column(self._corner(), self.heads))
        self.split.addWidget(_column(self.ruler, self.stack))
        self.split.setStretchFactor(1, 1)
        self.split.setSizes([HEADS_WIDTH, 100 * GRID])
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(_rule("line"))
        row = QHBoxLayout()
        row.setSpacing(0)
        row.addWidget(self.split, 1)
        for widget in (self.scroll, _rule("upright"), self.inspector):
            row.addWidget(widget)
        layout.addLayout(row, 1)

    def _corner(self) -> QWidget:
        """What stands above the heads: the search."""
        self.search.setPlaceholderText("Filter")
        self.search.setAccessibleName("Filter tracks")
        self.search.setClearButtonEnabled(True)
        self.search.addAction(icon("magnify"), QLineEdit.ActionPosition.LeadingPosition)
        corner = QWidget()
        corner.setFixedHeight(HEIGHT)
        room = QVBoxLayout(corner)
        room.setContentsMargins(GRID, (HEIGHT - ROW) // 2, GRID, (HEIGHT - ROW) // 2)
        room.addWidget(self.search)
        return corner

    def _open_hit(self, found: Hit, time: float) -> None:
        """A double click: a key on an empty place of a track, else the fields about what is there."""
        line = found.line
        if found.kind == "nothing" and line is not None and line.kind == "track":
            self._insert_key(line.channel, time)
        elif found.kind == "clip":
            flip_clips(self._timeline, found.chosen.events)
        elif found.chosen:
            self._timeline.change(fields=True)

    def _insert_key(self, channel: str, time: float) -> None:
        try:
            insert_key(self._timeline, channel, time)
        except RisoriusError as error:
            self.failed.emit(str(error))

    def _open_moment(self, time: float) -> None:
        """A double click on the strip of marks: a marker there."""
        self._timeline.playhead.go(max(time, 0.0), snap="frames" in self._timeline.state.snaps)
        if not (self._timeline.chosen.markers or self._timeline.chosen.ranges):
            self._binding.perform("timeline.marker")
        self._timeline.change(fields=True)

    def _follow_mode(self, now: TimelineState, before: TimelineState) -> None:
        if now.mode != before.mode:
            self.stack.setCurrentWidget(self.sheet if now.mode == "keys" else self.graph)

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
        """Wherever the playhead goes it is seen, but under a hand that holds it nothing is turned over."""
        if self._timeline.playhead.playing or not self.ruler.hands.busy:
            self.view.reveal(time)


def _column(top: QWidget, below: QWidget) -> QWidget:
    """One widget above another that takes the room."""
    column = QWidget()
    layout = QVBoxLayout(column)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(0)
    layout.addWidget(top)
    layout.addWidget(below, 1)
    return column


def _rule(role: str) -> QFrame:
    rule = QFrame()
    rule.setProperty("role", role)
    return rule
