"""A filled bar that carries its name and a number with a unit: the control for everything that has a range."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QWidget

from ui.theme.apply import current_theme
from ui.theme.colour import blend
from ui.theme.metrics import GRID, RADIUS, ROW
from ui.theme.roles import Theme
from ui.widgets.bar_hands import BarHands
from ui.widgets.bar_paint import EDGE, fill_colour
from ui.widgets.number_scale import NumberDrag, NumberScale


class NumberBar(BarHands, QWidget):
    """Shows one number and lets the hand change it.

    Dragging is relative: the fill follows the pointer.  Shift is finer, Esc restores.  Arrow keys step, Enter or a
    double click edits the number (arithmetic is understood), Backspace or a right click resets.

    Signals
    -------
    previewed(float) : the number while it is being changed
    committed() : the change is over and stays
    cancelled() : the change is over and is taken back
    hovered(bool) : the pointer came or went
    """

    previewed = Signal(float)
    committed = Signal()
    cancelled = Signal()
    hovered = Signal(bool)

    def __init__(self, label: str, scale: NumberScale, role: str = "both", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.label, self.scale, self.role = label, scale, role
        self._value = scale.default
        self._mixed = False
        self._get_ready(label)

    @property
    def value(self) -> float:
        """The number that is shown."""
        return self._value

    @property
    def held(self) -> bool:
        """Whether a hand is changing it."""
        return self._stepping or (self._drag is not None and self._drag.moving)

    def set_value(self, value: float, mixed: bool = False) -> None:
        """Show a number, which stands for several different ones where it is mixed; emits nothing."""
        if (value, mixed) != (self._value, self._mixed):
            self._value, self._mixed = value, mixed
            self.update()

    def set_now(self, value: float) -> None:
        """Change the number as one finished gesture."""
        self._show_and_tell(self.scale.clamped(value))
        self.committed.emit()

    def reset(self) -> None:
        """Back to the default."""
        if self._value != self.scale.default or self._mixed:
            self.set_now(self.scale.default)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The fill follows the pointer."""
        if self._drag is None:
            return
        drag = self._drag = self._drag.moved(event.position().x(), self.width(), event.modifiers())
        if drag.moving:
            self._show_and_tell(self.scale.rounded(self.scale.value(drag.reached), finer=int(drag.fine)))

    def minimumSizeHint(self) -> QSize:
        """One row, wide enough for the number."""
        return QSize(10 * GRID, ROW - 2)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the bar."""
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = QRectF(self.rect())
        shape = QPainterPath()
        shape.addRoundedRect(area, RADIUS, RADIUS)
        painter.fillPath(shape, self._ground(theme))
        painter.save()
        painter.setClipPath(shape)
        self._paint_fill(painter, area, theme)
        painter.restore()
        if self.hasFocus() or self.held:
            painter.setPen(QPen(QColor(theme.accent), 1.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)
        self._paint_text(painter, area.adjusted(GRID, 0, -GRID, 0), theme)

    def _ground(self, theme: Theme) -> QColor:
        if self.underMouse() and self.isEnabled():
            return QColor(theme.hover)
        return QColor(theme.raised) if theme.name == "dark" else blend(theme.panel, theme.line, 0.34)

    def _paint_fill(self, painter: QPainter, area: QRectF, theme: Theme) -> None:
        """From the zero of the scale, or its lower end, to the value."""
        zero = self.scale.share(0.0) if self.scale.least < 0 < self.scale.most else 0.0
        at = self.scale.share(self._value)
        low, high = sorted((zero, at))
        role = getattr(theme, self.role) if self.isEnabled() else theme.line
        left, right = area.x() + low * area.width(), area.x() + high * area.width()
        painter.fillRect(QRectF(left, area.y(), right - left, area.height()), fill_colour(role, theme))
        if zero > 0:
            painter.fillRect(QRectF(area.x() + zero * area.width(), area.y(), 1, area.height()), QColor(theme.muted))
        if high > low:
            edge = right - EDGE if at > zero else left
            painter.fillRect(QRectF(edge, area.y(), EDGE, area.height()), QColor(role))

    def _paint_text(self, painter: QPainter, inner: QRectF, theme: Theme) -> None:
        number = "mixed" if self._mixed else self.scale.text(self._value)
        centre = Qt.AlignmentFlag.AlignVCenter
        painter.setPen(QColor(theme.text if self.isEnabled() else theme.muted))
        painter.drawText(inner, centre | Qt.AlignmentFlag.AlignRight, number)
        metrics = painter.fontMetrics()
        room = inner.width() - metrics.horizontalAdvance(number) - GRID
        name = metrics.elidedText(self.label, Qt.TextElideMode.ElideRight, int(room))
        painter.drawText(inner, centre | Qt.AlignmentFlag.AlignLeft, name)

    def _show_and_tell(self, value: float) -> None:
        self.set_value(value)
        self.previewed.emit(value)

    def _enter(self, value: float) -> None:
        self._close_editor()
        self.set_now(self.scale.rounded(value, finer=2))

    def _written(self) -> str:
        return f"{self._value:g}"

    def _stepped(self, key: int, modifiers: Qt.KeyboardModifier) -> float | None:
        return self.scale.stepped(self._value, key, modifiers)

    def _grasp(self, x: float) -> NumberDrag:
        return NumberDrag(x, self._value, self.scale.share(self._value))

    def _restore(self, drag: NumberDrag) -> None:
        self.set_value(drag.start)
