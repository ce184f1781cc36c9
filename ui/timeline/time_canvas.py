"""A surface over time: drawn anew when something changes, under a playhead that only moves; hands work on it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QWidget

from app.timeline.chosen import NOTHING
from app.timeline.gestures import Spot
from app.timeline.gestures.box import Box
from ui.theme.apply import current_theme
from ui.theme.metrics import GRID
from ui.timeline.hands import Grip, Hands
from ui.timeline.hits import FINGER, Hit
from ui.timeline.navigation import Navigator
from ui.timeline.paint.ground import Pane, paint_playhead
from ui.timeline.view import TimelineView

Keys = Qt.KeyboardModifier
Cursor = Qt.CursorShape


class TimeCanvas(QWidget):
    """What sheet and graph have in common.

    A kind of it says what lies under a point (`hit`), what a press there takes hold of (`grasp`), what is drawn
    (`draw`), and may say what values are at a point (`value_at`).

    Signals
    -------
    advised(str) : what keys change about the gesture under way; empty when it is over
    failed(str) : why a gesture came to nothing
    asked(object, QPoint) : the menu for a Hit is wanted at a place of the screen
    opened(object, float) : a Hit was double-clicked at a time, seconds
    key_pressed(QKeyEvent) : a key that means nothing to the gesture under way

    Parameters
    ----------
    view : what part of the timeline is seen
    """

    advised = Signal(str)
    failed = Signal(str)
    asked = Signal(object, object)
    opened = Signal(object, float)
    key_pressed = Signal(object)

    def __init__(self, view: TimelineView) -> None:
        super().__init__()
        self.view, self.timeline = view, view.timeline
        self._drawn: QPixmap | None = None
        self._box: QRectF | None = None
        self._playhead = 0.0
        self.navigator = Navigator(view)
        self.hands = Hands(self.spot, self._take, self.advised.emit, self.failed.emit)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        for signal in (view.moved, view.relaid, view.content):
            signal.connect(self.refresh)
        self.timeline.playhead.moved.connect(self._move_playhead)

    def hit(self, place: QPointF) -> Hit:
        """What lies under a point."""
        raise NotImplementedError

    def grasp(self, found: Hit, spot: Spot) -> Grip:
        """What a press on something takes hold of."""
        raise NotImplementedError

    def draw(self, painter: QPainter, pane: Pane) -> None:
        """Draw all but the playhead."""
        raise NotImplementedError

    def value_at(self, _place: QPointF) -> float:
        """The value at a point, for what is held there."""
        return 0.0

    def cursor_over(self, _found: Hit) -> Cursor:
        """What the pointer looks like over something."""
        return Cursor.ArrowCursor

    def refresh(self) -> None:
        """Draw everything anew at the next frame."""
        self._drawn = None
        self.update()

    def pane(self) -> Pane:
        """What painters need to know, as things are now."""
        project, state = self.timeline.document.project, self.timeline.state
        theme, ratio = current_theme(), self.devicePixelRatioF()
        scale, width = self.view.scale, self.width()
        return Pane(project.animation, project.units, state.chosen, scale, width, state.style, theme, ratio)

    def spot(self, place: QPointF, held: Keys = Keys.NoModifier) -> Spot:
        """Where in time a point is, with the keys that are held."""
        scale = self.view.scale
        return Spot(
            scale.time(place.x()),
            self.value_at(place),
            scale.seconds(FINGER),
            abs(self.value_at(place) - self.value_at(place + QPointF(0, FINGER))),
            bool(held & Keys.ShiftModifier),
            bool(held & Keys.ControlModifier),
            bool(held & Keys.AltModifier),
            place.x(),
            place.y(),
        )

    def show_box(self, box: Box | None) -> None:
        """Draw the box of a choice, or none."""
        self._box = None if box is None else QRectF(box[0], box[1], box[2] - box[0], box[3] - box[1])
        self.update()

    def sizeHint(self) -> QSize:
        """A few lines high."""
        return QSize(60 * GRID, 24 * GRID)

    def minimumSizeHint(self) -> QSize:
        """Whatever there is room for."""
        return QSize(10 * GRID, 4 * GRID)

    def take_back(self) -> bool:
        """End the gesture under way as if it had never been; whether there was one."""
        return self.hands.cancel()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of what is under the pointer."""
        if self.navigator.press(event):
            self.setCursor(Cursor.ClosedHandCursor)
        elif event.button() == Qt.MouseButton.LeftButton:
            self.hands.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with what is held, or look at what is under the pointer."""
        if self.navigator.move(event):
            return
        if self.hands.busy:
            self.hands.move(event)
        elif event.buttons() == Qt.MouseButton.NoButton:
            self.setCursor(self.cursor_over(self.hit(event.position())))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if self.navigator.release(event):
            self.setCursor(self.cursor_over(self.hit(event.position())))
        elif event.button() == Qt.MouseButton.LeftButton:
            self.hands.release(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Open what is under the pointer."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.opened.emit(self.hit(event.position()), self.view.scale.time(event.position().x()))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom to the pointer, or go along."""
        self.navigator.turn(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A menu about what is under the pointer, which is chosen first."""
        found = self.hit(QPointF(event.pos()))
        if not self.timeline.chosen.holds(found.chosen):
            self.timeline.choose(found.chosen)
        self.asked.emit(found, event.globalPos())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc lets go of what is chosen; other keys are for the timeline."""
        if event.key() == Qt.Key.Key_Escape:
            self.timeline.choose(NOTHING)
            return
        self.hands.keys(event.modifiers())
        event.ignore()
        self.key_pressed.emit(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """A key that changes the gesture under way."""
        self.hands.keys(event.modifiers())
        event.ignore()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """See more or less."""
        self.view.resize(event.size().width(), event.size().height())
        self.refresh()

    def changeEvent(self, event: QEvent) -> None:
        """Another theme."""
        if event.type() == QEvent.Type.PaletteChange:
            self.refresh()

    def paintEvent(self, event: QPaintEvent) -> None:
        """What was drawn, and over it what moves."""
        if self._drawn is None:
            self._drawn = self._draw()
        painter = QPainter(self)
        ratio, part = self.devicePixelRatioF(), event.rect()
        source = QRectF(part.x() * ratio, part.y() * ratio, part.width() * ratio, part.height() * ratio)
        painter.drawPixmap(QRectF(part), self._drawn, source)
        theme = current_theme()
        if self._box is not None:
            veil = QColor(theme.accent)
            veil.setAlphaF(0.14)
            painter.setPen(QPen(QColor(theme.accent), 1.0))
            painter.setBrush(veil)
            painter.drawRect(self._box.adjusted(0.5, 0.5, -0.5, -0.5))
        self._playhead = self.view.scale.x(self.timeline.playhead.time)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        paint_playhead(painter, self._playhead, self.height(), theme)

    def _draw(self) -> QPixmap:
        ratio = self.devicePixelRatioF()
        pixmap = QPixmap(round(self.width() * ratio), round(self.height() * ratio))
        pixmap.setDevicePixelRatio(ratio)
        painter = QPainter(pixmap)
        self.draw(painter, self.pane())
        painter.end()
        return pixmap

    def _take(self, place: QPointF, spot: Spot) -> Grip:
        return self.grasp(self.hit(place), spot)

    def _move_playhead(self, _time: float) -> None:
        for x in (self._playhead, self.view.scale.x(self.timeline.playhead.time)):
            self.update(QRect(int(x) - 2, 0, 5, self.height()))
