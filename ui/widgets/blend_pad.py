"""A pad: things lie on it, and where the pointer is says how much of each is meant."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QImage, QKeyEvent, QMouseEvent, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.theme.metrics import GRID
from ui.widgets.pad_paint import KNOB, paint_pad

Place = tuple[float, float]

NUDGE, FINE = 0.02, 0.005
"""What an arrow key moves the pointer by, and with Shift."""

FAR = 4
"""Pixels that the mouse has to go before a press on a knot drags it."""

ARROWS: Mapping[Qt.Key, tuple[int, int]] = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, 1),
    Qt.Key.Key_Down: (0, -1),
}


@dataclass(frozen=True, eq=False)
class Knot:
    """Something that lies on the pad.

    Attributes
    ----------
    name, title : unique, and for people
    place : 0 to 1 to the right and up
    picture : of it, if there is one
    fixed : whether no hand can move it
    """

    name: str
    title: str
    place: Place
    picture: QImage | None = None
    fixed: bool = False


class BlendPad(QWidget):
    """Shows knots and the pointer, and lets the hand drag both.

    Signals
    -------
    pointed(float, float) : the pointer is dragged or stepped to a place
    kept(), dropped() : it was let go, or Esc took the drag back
    placed(str, object) : a knot was let go at a place; none where it left the pad
    chosen(str) : a knot was pressed, or with an empty name the ground
    """

    pointed = Signal(float, float)
    kept = Signal()
    dropped = Signal()
    placed = Signal(str, object)
    chosen = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.knots: tuple[Knot, ...] = ()
        self.shares: Mapping[str, float] = {}
        self.pointer: Place = (0.5, 0.5)
        self.meant = False
        self.picked = ""
        self._before: Place = self.pointer
        self._drag: Literal["", "pointer", "knot"] = ""
        self._pressed = QPoint()
        self._carried: tuple[str, QPointF] | None = None
        self._stepping = False
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName("Pad that blends between expressions")
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.setMaximumHeight(self.sizeHint().height())

    def show_knots(self, knots: Sequence[Knot]) -> None:
        """Show other knots."""
        self.knots = tuple(knots)
        self.update()

    def show_blend(self, pointer: Place, shares: Mapping[str, float], meant: bool) -> None:
        """Show where the pointer is, how much of each knot that is, and whether the face shows it."""
        self.pointer, self.shares, self.meant = pointer, shares, meant
        self.update()

    def pick(self, name: str) -> None:
        """Mark a knot; an empty name marks none."""
        if name != self.picked:
            self.picked = name
            self.update()

    @property
    def held(self) -> bool:
        """Whether a hand drags the pointer."""
        return self._drag == "pointer"

    def carry(self, name: str, over: QPoint | None) -> None:
        """Show something that is dragged here from elsewhere, over a place of the screen; none ends it."""
        inside = over is not None and self.rect().contains(self.mapFromGlobal(over))
        self._carried = (name, QPointF(self.mapFromGlobal(over))) if inside and over is not None else None
        self.update()

    def place_at(self, over: QPoint) -> Place | None:
        """The place of the pad at a place of the screen; none beside it."""
        at = self.mapFromGlobal(over)
        return self._place(QPointF(at)) if self.rect().contains(at) else None

    def take_back(self) -> bool:
        """End the drag under way as if it had never been; whether there was one."""
        drag, self._drag, self._carried = self._drag, "", None
        if drag == "pointer":
            self.pointer = self._before
            self.dropped.emit()
        self.update()
        return bool(drag)

    @property
    def field(self) -> QRectF:
        """Where places lie; knots at its edge still lie whole on the pad."""
        return QRectF(self.rect()).adjusted(KNOB, KNOB - 4, -KNOB, -KNOB - 6)

    def spot(self, place: Place) -> QPointF:
        """Where a place is, in pixels."""
        field = self.field
        return QPointF(field.x() + place[0] * field.width(), field.bottom() - place[1] * field.height())

    def knot_at(self, at: QPointF) -> Knot | None:
        """The knot under a place in pixels; of several the one on top."""
        for knot in reversed(self.knots):
            if (self.spot(knot.place) - at).manhattanLength() <= KNOB:
                return knot
        return None

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a knot, or bring the pointer here."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        self._finish_steps()
        knot = self.knot_at(event.position())
        on_pointer = (self.spot(self.pointer) - event.position()).manhattanLength() < GRID
        self._pressed = event.position().toPoint()
        if knot is not None and not knot.fixed and not on_pointer:
            self._drag = "knot"
            self.pick(knot.name)
            self.chosen.emit(knot.name)
        else:
            self._drag, self._before = "pointer", self.pointer
            self.pick("")
            self.chosen.emit("")
            self._point(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag what was taken hold of."""
        at = event.position()
        if self._drag == "pointer":
            self._point(at)
        elif self._drag == "knot" and (at.toPoint() - self._pressed).manhattanLength() >= FAR:
            self._carried = self.picked, at
            self.update()
        elif not self._drag:
            knot = self.knot_at(at)
            movable = knot is not None and not knot.fixed
            self.setCursor(Qt.CursorShape.OpenHandCursor if movable else Qt.CursorShape.CrossCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        drag, carried = self._drag, self._carried
        self._drag, self._carried = "", None
        if drag == "pointer":
            self.kept.emit()
        elif drag == "knot" and carried is not None:
            inside = self.rect().contains(event.position().toPoint())
            self.placed.emit(carried[0], self._place(event.position()) if inside else None)
        self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Bring the pointer onto a knot, which is then seen alone."""
        knot = self.knot_at(event.position())
        if knot is not None:
            self._drag = ""
            self.pointed.emit(*knot.place)
            self.kept.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows step the pointer, Delete takes the marked knot off."""
        key = Qt.Key(event.key())
        if key in ARROWS:
            by = FINE if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else NUDGE
            x, y = (_within(now + by * way) for now, way in zip(self.pointer, ARROWS[key], strict=True))
            self._stepping = True
            self.pointed.emit(x, y)
        elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace) and self.picked:
            self.placed.emit(self.picked, None)
        else:
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Steps of one key that was held are one gesture."""
        if Qt.Key(event.key()) in ARROWS and not event.isAutoRepeat():
            self._finish_steps()
        super().keyReleaseEvent(event)

    def focusOutEvent(self, event: object) -> None:
        """Finish what the keys began."""
        self._finish_steps()
        super().focusOutEvent(event)  # type: ignore[arg-type]

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the pad."""
        paint_pad(self, self._carried)

    def sizeHint(self) -> QSize:
        """Wider than high, as the panel is."""
        return QSize(38 * GRID, 30 * GRID)

    def minimumSizeHint(self) -> QSize:
        """Room for two knots one above the other."""
        return QSize(20 * GRID, 16 * GRID)

    def _point(self, at: QPointF) -> None:
        self.pointed.emit(*self._place(at))

    def _place(self, at: QPointF) -> Place:
        field = self.field
        return _within((at.x() - field.x()) / field.width()), _within((field.bottom() - at.y()) / field.height())

    def _finish_steps(self) -> None:
        if self._stepping:
            self._stepping = False
            self.kept.emit()


def _within(share: float) -> float:
    return min(max(round(float(share), 4), 0.0), 1.0)
