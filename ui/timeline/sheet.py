"""The sheet: all lines over time on one surface.  It is drawn anew when something changes; the playhead only moves."""

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

from app.timeline.chosen import NOTHING, Chosen
from app.timeline.gestures import Spot
from app.timeline.gestures.box import Box
from ui.theme.apply import current_theme
from ui.theme.metrics import GRID
from ui.timeline.hands import Grip, Hands
from ui.timeline.hits import FINGER, Hit, event_scale, hit, inside
from ui.timeline.line_paint import LinePainter
from ui.timeline.navigation import Navigator
from ui.timeline.paint.events import EventScale
from ui.timeline.paint.ground import Pane, paint_grid, paint_outside, paint_playhead
from ui.timeline.row_layout import Placed
from ui.timeline.sheet_grips import SheetGrips
from ui.timeline.view import TimelineView

Keys = Qt.KeyboardModifier


class Sheet(QWidget):
    """Shows the lines of a timeline and lets hands work on them.

    Signals
    -------
    advised(str) : what keys change about the gesture under way; empty when it is over
    failed(str) : why a gesture came to nothing
    asked(object, QPoint) : the menu for a Hit is wanted at a place of the screen
    opened(object) : a Hit was double-clicked
    key_pressed(QKeyEvent) : a key that means nothing to the gesture under way

    Parameters
    ----------
    view : what part of the timeline is seen
    painter : paints the lines
    """

    advised = Signal(str)
    failed = Signal(str)
    asked = Signal(object, object)
    opened = Signal(object)
    key_pressed = Signal(object)

    def __init__(self, view: TimelineView, painter: LinePainter) -> None:
        super().__init__()
        self._view, self._timeline, self._lines = view, view.timeline, painter
        self._drawn: QPixmap | None = None
        self._box: QRectF | None = None
        self._values: EventScale | None = None
        self._hovered = Hit()
        self._navigator = Navigator(view)
        self.grips = SheetGrips(self._timeline, self._inside, self._show_box)
        self.hands = Hands(self.spot, self._grasp, self.advised.emit, self.failed.emit)
        self.setAccessibleName("Keys over time")
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self._playhead = 0.0
        for signal in (view.moved, view.relaid, view.content, painter.refreshed):
            signal.connect(self.refresh)
        self._timeline.playhead.moved.connect(self._move_playhead)

    def refresh(self) -> None:
        """Draw everything anew at the next frame."""
        self._drawn = None
        self.update()

    def pane(self) -> Pane:
        """What painters need to know, as things are now."""
        project = self._timeline.document.project
        return Pane(
            project.animation,
            project.units,
            self._timeline.chosen,
            self._view.scale,
            self.width(),
            self._timeline.state.style,
            current_theme(),
            self.devicePixelRatioF(),
        )

    def spot(self, place: QPointF, held: Keys = Keys.NoModifier) -> Spot:
        """Where in time a point is; the value is that of the event whose handle is held."""
        scale = self._view.scale
        value = 0.0 if self._values is None else self._values.value(place.y())
        return Spot(
            scale.time(place.x()),
            value,
            scale.seconds(FINGER),
            0.0,
            bool(held & Keys.ShiftModifier),
            bool(held & Keys.ControlModifier),
            bool(held & Keys.AltModifier),
            place.x(),
            place.y(),
        )

    def hit(self, place: QPointF) -> Hit:
        """What lies under a point."""
        placed = self._view.layout.at(place.y() + self._view.top)
        return hit(self.pane(), placed.line, self.area(placed), place) if placed is not None else Hit()

    def area(self, placed: Placed) -> QRectF:
        """Where a line is on the sheet."""
        return QRectF(0, placed.top - self._view.top, self.width(), placed.height)

    def sizeHint(self) -> QSize:
        """A few lines high."""
        return QSize(100 * GRID, 24 * GRID)

    def minimumSizeHint(self) -> QSize:
        """Whatever there is room for."""
        return QSize(10 * GRID, 4 * GRID)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of what is under the pointer; the right button ends a gesture."""
        if self._navigator.press(event):
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif event.button() == Qt.MouseButton.RightButton:
            self.hands.cancel()
        elif event.button() == Qt.MouseButton.LeftButton:
            self.hands.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with what is held, or look at what is under the pointer."""
        if self._navigator.move(event):
            return
        if self.hands.busy:
            self.hands.move(event)
        elif event.buttons() == Qt.MouseButton.NoButton:
            self._hover(self.hit(event.position()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if self._navigator.release(event):
            self._hover(self.hit(event.position()))
        elif event.button() == Qt.MouseButton.LeftButton:
            self.hands.release(event)
            self._values = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Open what is under the pointer."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.opened.emit(self.hit(event.position()))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom to the pointer, or go along."""
        self._navigator.turn(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A menu about what is under the pointer, which is chosen first."""
        if self.hands.busy:
            return
        found = self.hit(QPointF(event.pos()))
        if found.chosen and self._timeline.chosen.joined(found.chosen) != self._timeline.chosen:
            self._timeline.choose(found.chosen)
        self.asked.emit(found, event.globalPos())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc ends a gesture, then lets go of what is chosen; other keys are for the timeline."""
        if event.key() == Qt.Key.Key_Escape:
            if not self.hands.cancel():
                self._timeline.choose(NOTHING)
            return
        self.hands.keys(event.modifiers())
        event.ignore()
        self.key_pressed.emit(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """A key that changes the gesture under way."""
        self.hands.keys(event.modifiers())
        event.ignore()

    def leaveEvent(self, _event: QEvent) -> None:
        """Nothing is under the pointer."""
        self._hover(Hit())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """See more or less."""
        self._view.resize(event.size().width(), event.size().height())
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
        ratio = self.devicePixelRatioF()
        part = event.rect()
        source = QRectF(part.x() * ratio, part.y() * ratio, part.width() * ratio, part.height() * ratio)
        painter.drawPixmap(QRectF(part), self._drawn, source)
        theme = current_theme()
        if self._box is not None:
            veil = QColor(theme.accent)
            veil.setAlphaF(0.14)
            painter.setPen(QPen(QColor(theme.accent), 1.0))
            painter.setBrush(veil)
            painter.drawRect(self._box.adjusted(0.5, 0.5, -0.5, -0.5))
        self._playhead = self._view.scale.x(self._timeline.playhead.time)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        paint_playhead(painter, self._playhead, self.height(), theme)

    def _draw(self) -> QPixmap:
        ratio = self.devicePixelRatioF()
        pixmap = QPixmap(round(self.width() * ratio), round(self.height() * ratio))
        pixmap.setDevicePixelRatio(ratio)
        pane = self.pane()
        painter = QPainter(pixmap)
        paint_grid(painter, pane, self.height())
        for placed in self._view.layout.between(self._view.top, self._view.top + self.height()):
            self._lines.paint(painter, pane, placed.line, self.area(placed))
        paint_outside(painter, pane, self.height())
        painter.end()
        return pixmap

    def _grasp(self, place: QPointF, spot: Spot) -> Grip:
        found = self.hit(place)
        placed = None if found.line is None else self._view.layout.of(found.line.key)
        if found.kind == "handle" and placed is not None:
            # The scale as it is now: while the peak is dragged it must not run away under the hand.
            self._values = event_scale(self.pane(), found.chosen, self.area(placed))
        return self.grips.grasp(found, spot)

    def _inside(self, box: Box) -> Chosen:
        """What lies in a box."""
        left, top, right, bottom = box
        pane, found = self.pane(), NOTHING
        for placed in self._view.layout.between(top + self._view.top, bottom + self._view.top):
            area = QRectF(left, top, right - left, bottom - top)
            found = found.joined(inside(pane, placed.line, self.area(placed), area))
        return found

    def _show_box(self, box: Box | None) -> None:
        self._box = None if box is None else QRectF(box[0], box[1], box[2] - box[0], box[3] - box[1])
        self.update()

    def _hover(self, found: Hit) -> None:
        self._hovered = found
        self.setCursor(CURSORS.get(found.kind, Qt.CursorShape.ArrowCursor))

    def _move_playhead(self, _time: float) -> None:
        before, now = self._playhead, self._view.scale.x(self._timeline.playhead.time)
        for x in (before, now):
            self.update(QRect(int(x) - 2, 0, 5, self.height()))


CURSORS = {
    "region": Qt.CursorShape.SplitHCursor,
    "bound": Qt.CursorShape.SplitHCursor,
    "handle": Qt.CursorShape.SizeAllCursor,
}
"""What the pointer looks like over what a drag does something special with."""
