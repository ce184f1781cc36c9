"""The ruler above the lines: scrub on it, set what is played, mark moments and ranges, stretch what is chosen."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF, QRect, QSize, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.timeline.gestures import Spot
from ui.theme.apply import current_theme
from ui.theme.metrics import GRID
from ui.timeline.hands import Grip, Hands
from ui.timeline.hits import FINGER
from ui.timeline.navigation import Navigator
from ui.timeline.paint.ground import Pane
from ui.timeline.paint.ruler import HEAD_REACH, HEIGHT, MARKS, TIMES, paint_head, paint_ruler
from ui.timeline.ruler_grips import goes_sideways, grasp, mark_at
from ui.timeline.view import TimelineView

Keys = Qt.KeyboardModifier
SIDEWAYS = Qt.CursorShape.SizeHorCursor


class Ruler(QWidget):
    """Shows times over a sheet.

    Signals
    -------
    advised(str), failed(str) : as those of the sheet
    asked(object, QPoint) : the menu for a moment, seconds, is wanted at a place of the screen
    opened(float) : the strip of marks was double-clicked at a time, seconds
    """

    advised = Signal(str)
    failed = Signal(str)
    asked = Signal(object, object)
    opened = Signal(float)

    def __init__(self, view: TimelineView) -> None:
        super().__init__()
        self._view, self._timeline = view, view.timeline
        self._navigator = Navigator(view)
        self.hands = Hands(self.spot, self._grasp, self.advised.emit, self.failed.emit)
        self.setFixedHeight(HEIGHT)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAccessibleName("Ruler")
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self._head = 0
        view.moved.connect(self.update)
        view.content.connect(self.update)
        self._timeline.playhead.moved.connect(self._move_head)

    def pane(self) -> Pane:
        """What painters need to know, as things are now."""
        project = self._timeline.document.project
        state = self._timeline.state
        return Pane(
            project.animation, project.units, state.chosen, self._view.scale, self.width(), state.style, current_theme()
        )

    def spot(self, place: QPointF, held: Keys = Keys.NoModifier) -> Spot:
        """Where in time a point is; beside the ruler, what its edge shows."""
        scale = self._view.scale
        return Spot(
            scale.time(min(max(place.x(), 0.0), float(self.width()))),
            reach=scale.seconds(FINGER),
            shift=bool(held & Keys.ShiftModifier),
            control=bool(held & Keys.ControlModifier),
            alt=bool(held & Keys.AltModifier),
            x=place.x(),
            y=place.y(),
        )

    def sizeHint(self) -> QSize:
        """As wide as the sheet."""
        return QSize(100 * GRID, HEIGHT)

    def take_back(self) -> bool:
        """End the gesture under way as if it had never been; whether there was one."""
        return self.hands.cancel()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold."""
        if self._navigator.press(event):
            return
        if event.button() == Qt.MouseButton.LeftButton:
            self.hands.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with what is held, or show what a press would take hold of."""
        if self._navigator.move(event):
            return
        if self.hands.busy:
            self._view.follow(event.position().x())
            self.hands.move(event)
        else:
            sideways = goes_sideways(self.pane(), event.position())
            self.setCursor(SIDEWAYS if sideways else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if not self._navigator.release(event) and event.button() == Qt.MouseButton.LeftButton:
            self.hands.release(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """A new marker, or another name for what is there."""
        if event.button() == Qt.MouseButton.LeftButton and TIMES <= event.position().y() < TIMES + MARKS:
            self.opened.emit(self._view.scale.time(event.position().x()))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom to the pointer, or go along."""
        self._navigator.turn(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A menu about the moment under the pointer."""
        place = QPointF(event.pos())
        mark = mark_at(self.pane(), place.x())
        if mark and place.y() >= TIMES:
            self._timeline.choose(mark)
        self.asked.emit(self._view.scale.time(place.x()), event.globalPos())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """A key that changes the gesture under way."""
        self.hands.keys(event.modifiers())
        event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """A key that changes the gesture under way."""
        self.hands.keys(event.modifiers())
        event.ignore()

    def changeEvent(self, event: QEvent) -> None:
        """Another theme."""
        if event.type() == QEvent.Type.PaletteChange:
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the ruler and the head of the playhead."""
        painter, pane = QPainter(self), self.pane()
        paint_ruler(painter, pane)
        paint_head(painter, pane, self._timeline.playhead.time)
        self._head = int(pane.scale.x(self._timeline.playhead.time))

    def _grasp(self, place: QPointF, _spot: Spot) -> Grip:
        return grasp(self._timeline, self.pane(), place)

    def _move_head(self, _time: float) -> None:
        now = int(self._view.scale.x(self._timeline.playhead.time))
        for x in (self._head, now):
            self.update(QRect(x - HEAD_REACH, 0, 2 * HEAD_REACH, HEIGHT))
