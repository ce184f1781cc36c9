"""The heads of the lines at the left: names and values, folds and switches; a value that is dragged becomes a key."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from app.timeline.gestures import Spot
from app.timeline.gestures.values import DragValue
from app.timeline.lines import Line
from app.timeline.switches import flip_fold, flip_switch, switches_of
from app.timeline.values import key_value, value_of, value_text
from facemodel.errors import RisoriusError
from ui.theme.apply import current_theme
from ui.theme.metrics import GRID
from ui.timeline.hands import Grip, Hands
from ui.timeline.navigation import NOTCH, ROWS, STEP
from ui.timeline.paint.heads import VALUE, HeadLook, fold_area, paint_head, switch_area, value_area
from ui.timeline.row_layout import Placed
from ui.timeline.view import TimelineView
from ui.widgets.number_edit import NumberEdit
from ui.widgets.paced import Paced

Keys = Qt.KeyboardModifier


class Heads(QWidget):
    """Shows the heads of the lines of a view.

    Signals
    -------
    advised(str), failed(str) : as those of the sheet
    asked(object, QPoint) : the menu for a Line is wanted at a place of the screen
    key_pressed(QKeyEvent) : a key that means nothing here
    """

    advised = Signal(str)
    failed = Signal(str)
    asked = Signal(object, object)
    key_pressed = Signal(object)

    def __init__(self, view: TimelineView) -> None:
        super().__init__()
        self._view, self._timeline = view, view.timeline
        self._over: tuple[str, str] = ("", "")
        self._editor: NumberEdit | None = None
        self._anchor = ""
        self.hands = Hands(self._spot, self._grasp, self.advised.emit, self.failed.emit)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName("Tracks")
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        for signal in (view.moved, view.relaid, view.content):
            signal.connect(self.update)
        self._pace = Paced(self._revalue, self)
        self._timeline.playhead.moved.connect(self._pace.offer)
        self._timeline.document.expression_changed.connect(self._pace.offer)

    def sizeHint(self) -> QSize:
        """Room for the name of a unit, its value and its switches."""
        return QSize(33 * GRID, 24 * GRID)

    def minimumSizeHint(self) -> QSize:
        """Room for a number and a value."""
        return QSize(16 * GRID, 4 * GRID)

    def area(self, placed: Placed) -> QRectF:
        """Where a head is."""
        return QRectF(0, placed.top - self._view.top, self.width(), placed.height)

    def part_at(self, place: QPointF) -> tuple[Placed | None, str]:
        """The head under a point, and what of it: a switch, ``value``, ``fold`` or nothing."""
        placed = self._view.layout.at(place.y() + self._view.top)
        if placed is None:
            return None, ""
        area = self.area(placed)
        if placed.line.foldable and fold_area(placed.line, area).contains(place):
            return placed, "fold"
        switches = list(switches_of(placed.line, self._timeline.animation))
        for number, name in enumerate(switches):
            if switch_area(placed.line, area, number, len(switches)).contains(place):
                return placed, name
        if value_area(placed.line, area).contains(place):
            return placed, "value"
        return placed, ""

    def edit_value(self, line: Line) -> None:
        """Open the value of a track for typing; what is typed becomes a key."""
        placed = self._view.layout.of(line.key)
        if placed is None or self._editor is not None:
            return
        value = value_of(self._timeline, line.channel)
        self._editor = NumberEdit(self, f"{value:g}")
        area = value_area(line, self.area(placed)).adjusted(-12, 0, 4, 0)
        self._editor.setGeometry(area.toRect())
        self._editor.entered.connect(lambda value: self._enter(line, value))
        self._editor.dismissed.connect(self._close_editor)

    def take_back(self) -> bool:
        """End the gesture under way as if it had never been; whether there was one."""
        return self.hands.cancel()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Turn a switch over, or take hold of the head or its value."""
        if event.button() == Qt.MouseButton.LeftButton:
            placed, part = self.part_at(event.position())
            if placed is not None and part == "fold":
                flip_fold(self._timeline, placed.line)
            elif placed is not None and part in ("muted", "solo", "locked"):
                flip_switch(self._timeline, placed.line, part)
            else:
                self.hands.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with what is held, or show what is under the pointer."""
        if self.hands.busy:
            self.hands.move(event)
            return
        placed, part = self.part_at(event.position())
        self._hover((placed.line.key if placed is not None else "", part))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.hands.release(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Type a value, or fold a group."""
        placed, part = self.part_at(event.position())
        if placed is None:
            return
        if part == "value":
            self.edit_value(placed.line)
        elif placed.line.foldable and not part:
            flip_fold(self._timeline, placed.line)
        else:
            self.mousePressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll the lines; with Ctrl make tracks higher or lower."""
        notches = event.angleDelta().y() / NOTCH
        if event.modifiers() & Keys.ControlModifier:
            self._view.stretch(STEP**notches)
        else:
            self._view.scroll(self._view.top - ROWS * notches)
        event.accept()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A menu about the line under the pointer, which is chosen first."""
        placed, _ = self.part_at(QPointF(event.pos()))
        if placed is not None and placed.line.key not in self._timeline.state.lines:
            self._choose(placed.line, Spot(0.0))
        self.asked.emit(placed.line if placed is not None else None, event.globalPos())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows go from line to line."""
        if event.key() in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            self._step(-1 if event.key() == Qt.Key.Key_Up else 1, bool(event.modifiers() & Keys.ShiftModifier))
            return
        self.hands.keys(event.modifiers())
        event.ignore()
        self.key_pressed.emit(event)

    def leaveEvent(self, _event: QEvent) -> None:
        """Nothing is under the pointer."""
        self._hover(("", ""))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the heads in sight."""
        theme, animation = current_theme(), self._timeline.animation
        painter = QPainter(self)
        painter.fillRect(self.rect(), theme.panel)
        key, part = self._over
        for placed in self._view.layout.between(self._view.top, self._view.top + self.height()):
            line = placed.line
            value = value_text(self._timeline, line.channel) if line.kind == "track" else ""
            hovered = line.key == key
            look = HeadLook(value, hovered, line.key in self._timeline.state.lines, part if hovered else "")
            paint_head(painter, line, self.area(placed), animation, look, theme)
        painter.setPen(theme.line)
        painter.drawLine(self.width() - 1, 0, self.width() - 1, self.height())

    def _spot(self, place: QPointF, held: Keys = Keys.NoModifier) -> Spot:
        return Spot(
            self._timeline.playhead.time,
            shift=bool(held & Keys.ShiftModifier),
            control=bool(held & Keys.ControlModifier),
            x=place.x(),
            y=place.y(),
        )

    def _grasp(self, place: QPointF, _spot: Spot) -> Grip:
        placed, part = self.part_at(place)
        if placed is None:
            return Grip(click=lambda _: self._timeline.change(lines=frozenset()))
        line = placed.line
        if part == "value":
            return Grip(lambda first: DragValue(self._timeline, line.channel, first))
        return Grip(click=lambda spot: self._choose(line, spot))

    def _choose(self, line: Line, spot: Spot) -> None:
        """Choose a line alone, with Ctrl as well, with Shift all from the last one on."""
        chosen = self._timeline.state.lines
        keys = [each.key for each in self._view.lines]
        if spot.shift and self._anchor in keys:
            first, last = sorted((keys.index(self._anchor), keys.index(line.key)))
            chosen = frozenset(keys[first : last + 1])
        elif spot.control:
            chosen = chosen ^ {line.key}
        else:
            chosen = frozenset() if chosen == {line.key} else frozenset((line.key,))
        if not spot.shift:
            self._anchor = line.key
        self._timeline.change(lines=chosen)

    def _step(self, way: int, several: bool) -> None:
        """To the next line, or back."""
        keys = [each.key for each in self._view.lines]
        here = keys.index(self._anchor) if self._anchor in keys else -1 if way > 0 else len(keys)
        there = min(max(here + way, 0), len(keys) - 1)
        before = self._timeline.state.lines if several else frozenset()
        self._anchor = keys[there]
        self._timeline.change(lines=before | {self._anchor})

    def _enter(self, line: Line, value: float) -> None:
        self._close_editor()
        try:
            key_value(self._timeline, line.channel, value)
        except RisoriusError as error:
            self.failed.emit(str(error))

    def _close_editor(self) -> None:
        editor, self._editor = self._editor, None
        if editor is not None:
            editor.go_away()

    def _revalue(self, _now: object) -> None:
        """Other values are seen: nothing but their column is drawn anew."""
        left = self.width() - GRID - VALUE
        self.update(left, 0, VALUE + GRID, self.height())

    def _hover(self, over: tuple[str, str]) -> None:
        if over != self._over:
            self._over = over
            self.setCursor(Qt.CursorShape.SizeHorCursor if over[1] == "value" else Qt.CursorShape.ArrowCursor)
            self.update()
