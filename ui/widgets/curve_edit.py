"""A curve through knots that a hand draws: drag them, double-click for a new one, right-click takes one out."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QContextMenuEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from facemodel.laying.profiles import Axes, grown, moved, shrunk
from facemodel.muscles import Profile
from ui.theme.apply import current_theme, interface_font
from ui.theme.colour import blend
from ui.theme.metrics import GRID, RADIUS, SMALL_TYPE

HEIGHT = 15 * GRID
MARGIN = GRID
FINGER = 9.0
"""Pixels from a knot within which it is taken."""
KNOT = 4.0
SAMPLES = 160
STEP, FINE_STEP = 0.05, 0.01

Key = Qt.Key

OWN = frozenset(
    (
        *(Key.Key_Left, Key.Key_Right, Key.Key_Up, Key.Key_Down),
        *(Key.Key_Delete, Key.Key_Backspace, Key.Key_PageUp, Key.Key_PageDown),
    )
)
"""Keys that mean something to a curve in focus."""


class CurveEdit(QWidget):
    """Shows a profile and lets a hand change it.

    Signals
    -------
    previewed(object) : the Profile while it is being changed
    committed() : the change is over and stays
    cancelled() : the change is over and is taken back
    knot_changed() : another knot is in hand, or it is elsewhere

    Attributes
    ----------
    profile : what is shown
    knot : number of the knot in hand
    """

    previewed = Signal(object)
    committed = Signal()
    cancelled = Signal()
    knot_changed = Signal()

    def __init__(self, label: str, profile: Profile, axes: Axes) -> None:
        super().__init__()
        self.profile, self.axes, self.knot = profile, axes, 0
        self._before: Profile | None = None
        self._moved = self._stepping = False
        self.setAccessibleName(label)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    @property
    def held(self) -> bool:
        """Whether a hand is changing it."""
        return self._stepping or self._before is not None

    def set_profile(self, profile: Profile) -> None:
        """Show another profile; emits nothing but that the knot in hand may be elsewhere."""
        if profile != self.profile:
            self.profile = profile
            self.knot = min(self.knot, len(profile.at) - 1)
            self.update()
            self.knot_changed.emit()

    def set_knot(self, at: float, value: float) -> None:
        """Move the knot in hand as part of a gesture that somebody else ends."""
        self._show_and_tell(moved(self.profile, self.knot, at, value, self.axes))

    def place_of(self, knot: int) -> QPointF:
        """Where a knot is drawn."""
        return self._pixel(self.profile.at[knot], self.profile.values[knot])

    def take_back(self) -> bool:
        """End the drag under way as if it had never been; whether there was one."""
        before, self._before = self._before, None
        if before is not None:
            self.set_profile(before)
            if self._moved:
                self.cancelled.emit()
        self.update()
        return before is not None

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take a knot in hand; the right button takes one out."""
        knot = self._under(event.position())
        if knot is not None:
            self._take(knot)
            if event.button() == Qt.MouseButton.LeftButton:
                self._before, self._moved = self.profile, False
            elif event.button() == Qt.MouseButton.RightButton:
                self._remove()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The knot follows the pointer; with Shift ten times slower."""
        if self._before is None:
            return
        at, value = self._meant(event.position())
        was = self.profile.at[self.knot], self.profile.values[self.knot]
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            at, value = was[0] + (at - was[0]) / 10, was[1] + (value - was[1]) / 10
        new = moved(self.profile, self.knot, at, value, self.axes)
        if new != self.profile:
            self._moved = True
            self._show_and_tell(new)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go: a drag is kept."""
        if event.button() == Qt.MouseButton.LeftButton and self._before is not None:
            self._before = None
            if self._moved:
                self.committed.emit()
            self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """A new knot where there is none."""
        if event.button() == Qt.MouseButton.LeftButton and self._under(event.position()) is None:
            made = grown(self.profile, *self._meant(event.position()), self.axes)
            if made is not None:
                self._show_and_tell(made[0])
                self._take(made[1])
                self.committed.emit()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """No menu: the right button has a meaning of its own."""
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows move the knot in hand, Page keys take the next one, Delete takes it out."""
        ways = {Key.Key_Left: (-1, 0), Key.Key_Right: (1, 0), Key.Key_Up: (0, 1), Key.Key_Down: (0, -1)}
        key = Key(event.key())
        if key in (Key.Key_Delete, Key.Key_Backspace):
            self._remove()
        elif key in (Key.Key_PageDown, Key.Key_PageUp):
            self._take((self.knot + (1 if key == Key.Key_PageDown else -1)) % len(self.profile.at))
        elif key in ways:
            step = FINE_STEP if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else STEP
            self._stepping = True
            x, y = (step * way for way in ways[key])
            self.set_knot(self.profile.at[self.knot] + x, self.profile.values[self.knot] + y)
        else:
            event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """A key held down is one gesture."""
        if self._stepping and not event.isAutoRepeat():
            self._stepping = False
            self.committed.emit()
        event.ignore()

    def event(self, event: QEvent) -> bool:
        """Keep the keys that mean something here, before a shortcut of the window takes them."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and event.key() in OWN:
            event.accept()
            return True
        return super().event(event)

    def sizeHint(self) -> QSize:
        """As wide as the panel."""
        return QSize(30 * GRID, HEIGHT)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the axes, the curve and its knots."""
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(theme.accent if self.hasFocus() else theme.line), 1.0))
        painter.setBrush(blend(theme.panel, theme.window, 0.6))
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)
        painter.setOpacity(1.0 if self.isEnabled() else 0.5)
        self._paint_axes(painter)
        line = np.linspace(0.0, self.axes.reach, SAMPLES)
        run = QPolygonF([self._pixel(x, y) for x, y in zip(line, self.profile(line), strict=True)])
        painter.setPen(QPen(QColor(theme.accent), 1.6))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPolyline(run)
        for knot in range(len(self.profile.at)):
            mine = knot == self.knot
            painter.setPen(QPen(QColor(theme.accent), 1.6))
            painter.setBrush(QColor(theme.accent if mine else theme.panel))
            painter.drawEllipse(self.place_of(knot), KNOT, KNOT)

    def _paint_axes(self, painter: QPainter) -> None:
        theme = current_theme()
        mark, name = self.axes.mark
        painter.setPen(QPen(blend(theme.panel, theme.muted, 0.5), 1.0))
        painter.drawLine(self._pixel(0.0, 0.0), self._pixel(self.axes.reach, 0.0))
        painter.setPen(QPen(blend(theme.panel, theme.muted, 0.35), 1.0, Qt.PenStyle.DashLine))
        painter.drawLine(self._pixel(mark, self.axes.least), self._pixel(mark, self.axes.most))
        painter.setFont(interface_font(SMALL_TYPE))
        painter.setPen(QColor(theme.muted))
        top, foot = self._pixel(0.0, self.axes.most), self._pixel(self.axes.reach, self.axes.least)
        write = painter.drawText
        left, right = Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignRight
        write(QRectF(top.x() + 4, top.y() - 4, 40, 14), left, f"{self.axes.most:g}")
        write(QRectF(top.x() + 4, foot.y() - 11, 40, 14), left, f"{self.axes.least:g}")
        write(QRectF(foot.x() - 80, foot.y() - 11, 80, 14), right, f"{self.axes.reach:g}")
        write(QRectF(self._pixel(mark, 0.0).x() + 4, foot.y() - 11, 90, 14), left, name)

    def _take(self, knot: int) -> None:
        self.knot = knot
        self.update()
        self.knot_changed.emit()

    def _remove(self) -> None:
        less = shrunk(self.profile, self.knot)
        if less is not None:
            self._show_and_tell(less)
            self.committed.emit()

    def _show_and_tell(self, profile: Profile) -> None:
        self.set_profile(profile)
        self.previewed.emit(profile)

    def _under(self, place: QPointF) -> int | None:
        away = [(self.place_of(k) - place).manhattanLength() for k in range(len(self.profile.at))]
        nearest = int(np.argmin(away))
        return nearest if away[nearest] <= FINGER else None

    def _room(self) -> QRectF:
        return QRectF(self.rect()).adjusted(MARGIN, MARGIN, -MARGIN, -MARGIN)

    def _pixel(self, at: float, value: float) -> QPointF:
        room, axes = self._room(), self.axes
        up = (value - axes.least) / (axes.most - axes.least)
        return QPointF(room.x() + at / axes.reach * room.width(), room.bottom() - up * room.height())

    def _meant(self, place: QPointF) -> tuple[float, float]:
        """Distance and value at a pixel."""
        room, axes = self._room(), self.axes
        at = (place.x() - room.x()) / room.width() * axes.reach
        return at, axes.least + (room.bottom() - place.y()) / room.height() * (axes.most - axes.least)
