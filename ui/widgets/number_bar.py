"""A filled bar that carries its name and a number with a unit: the control for everything that has a range."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QEnterEvent,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.theme.apply import current_theme
from ui.theme.colour import blend
from ui.theme.metrics import GRID, RADIUS, ROW
from ui.theme.roles import Theme
from ui.widgets.activation_slider import OWN_KEYS
from ui.widgets.bar_paint import EDGE, fill_colour
from ui.widgets.number_edit import NumberEdit
from ui.widgets.number_scale import NumberDrag, NumberScale


class NumberBar(QWidget):
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
        self._drag: NumberDrag | None = None
        self._stepping = False
        self._editor: NumberEdit | None = None
        self._mixed = False
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(label)

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

    def cancel(self) -> None:
        """Take the gesture in progress back."""
        drag, self._drag = self._drag, None
        if drag is not None and drag.moving:
            self.set_value(drag.start)
            self.cancelled.emit()
        self.update()

    def edit(self) -> None:
        """Open the number for typing."""
        if self._editor is None and self.isEnabled():
            self._editor = NumberEdit(self, f"{self._value:g}")
            self._editor.entered.connect(self._enter)
            self._editor.dismissed.connect(self._close_editor)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold; the right button resets, or cancels a drag that is under way."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag = NumberDrag(event.position().x(), self._value, self.scale.share(self._value))
        elif event.button() == Qt.MouseButton.RightButton and self._drag is not None:
            self.cancel()
        elif event.button() == Qt.MouseButton.RightButton:
            self.reset()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The fill follows the pointer."""
        if self._drag is None:
            return
        drag = self._drag = self._drag.moved(event.position().x(), self.width(), event.modifiers())
        if drag.moving:
            self._show_and_tell(self.scale.rounded(self.scale.value(drag.reached), finer=int(drag.fine)))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go: a drag is kept."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        drag, self._drag = self._drag, None
        self.update()
        if drag is not None and drag.moving:
            self.committed.emit()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Edit the number."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag = None
            self.edit()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """No menu: the right button has a meaning of its own."""
        event.accept()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """The wheel scrolls the panel and never changes a number by accident."""
        event.ignore()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Step, edit, reset or cancel."""
        key = event.key()
        if key == Qt.Key.Key_Escape and self._drag is not None:
            self.cancel()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2):
            self.edit()
        elif key in (Qt.Key.Key_Backspace, Qt.Key.Key_Delete):
            self.reset()
        elif (target := self.scale.stepped(self._value, key, event.modifiers())) is not None:
            self._stepping = True
            self._show_and_tell(target)
        else:
            event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """A key held down is one gesture."""
        if not event.isAutoRepeat():
            self._finish_steps()
        event.ignore()

    def event(self, event: QEvent) -> bool:
        """Keep the keys that mean something here, before a shortcut of the window takes them."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            wanted = event.key() in OWN_KEYS or (event.key() == Qt.Key.Key_Escape and self._drag is not None)
            if wanted:
                event.accept()
                return True
        return super().event(event)

    def enterEvent(self, event: QEnterEvent) -> None:
        """Say that the pointer came."""
        super().enterEvent(event)
        self.hovered.emit(True)

    def leaveEvent(self, event: QEvent) -> None:
        """Say that the pointer went."""
        super().leaveEvent(event)
        self.hovered.emit(False)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Finish what the keys began."""
        super().focusOutEvent(event)
        self._finish_steps()

    def sizeHint(self) -> QSize:
        """One row, wide enough for a short name."""
        return QSize(20 * GRID, ROW - 2)

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

    def _finish_steps(self) -> None:
        if self._stepping:
            self._stepping = False
            self.committed.emit()

    def _enter(self, value: float) -> None:
        self._close_editor()
        self.set_now(self.scale.rounded(value, finer=2))

    def _close_editor(self) -> None:
        editor, self._editor = self._editor, None
        if editor is not None:
            editor.hide()
            editor.deleteLater()
            self.setFocus(Qt.FocusReason.OtherFocusReason)
