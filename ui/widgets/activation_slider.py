"""A filled bar that carries its name and its number: the control for a weight."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QEnterEvent,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QAbstractSlider, QSizePolicy, QWidget

from app.weights import LARGEST_WEIGHT
from ui.theme.apply import current_theme
from ui.theme.metrics import GRID, ROW
from ui.widgets.bar_paint import Bar, Fill, paint_bar
from ui.widgets.number_edit import NumberEdit
from ui.widgets.weight_gestures import Drag, dragged, stepped

FillSide = Literal["left", "right", "both"]

OWN_KEYS = frozenset(
    {
        Qt.Key.Key_Left,
        Qt.Key.Key_Right,
        Qt.Key.Key_Up,
        Qt.Key.Key_Down,
        Qt.Key.Key_Home,
        Qt.Key.Key_End,
        Qt.Key.Key_PageUp,
        Qt.Key.Key_PageDown,
        Qt.Key.Key_Backspace,
        Qt.Key.Key_Delete,
        Qt.Key.Key_Return,
        Qt.Key.Key_Enter,
        Qt.Key.Key_F2,
    }
)
"""Keys that act on the bar in focus, whatever the window has bound them to."""

PERCENT = 100
"""Steps of the integer value that assistive technology reads: percent of full contraction."""


class ActivationSlider(QAbstractSlider):
    """Shows one weight, or those of left and right together, and lets the hand change it.

    Dragging is relative: the fill follows the pointer.  Ctrl goes past 1, Shift is finer, Esc restores.  Arrow keys
    step, Home and End go to 0 and 1, Enter or a double click edits the number, Backspace or a right click resets.

    Signals
    -------
    previewed(float) : the weight while it is being changed
    committed() : the change is over and stays
    cancelled() : the change is over and is taken back
    hovered(bool) : the pointer came, or it went or took hold
    """

    previewed = Signal(float)
    committed = Signal()
    cancelled = Signal()
    hovered = Signal(bool)

    def __init__(self, label: str, side: FillSide = "both", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.label = label
        self.side: FillSide = side
        self._weights = (0.0, 0.0)
        self._drag: Drag | None = None
        self._stepping = False
        self._editor: NumberEdit | None = None
        self.setOrientation(Qt.Orientation.Horizontal)
        self.setRange(0, int(LARGEST_WEIGHT * PERCENT))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(label)

    @property
    def weight(self) -> float:
        """The weight that a gesture starts from: the larger one where left and right differ."""
        return max(self._weights)

    @property
    def held(self) -> bool:
        """Whether a hand is dragging it."""
        return self._drag is not None and self._drag.moving

    @property
    def number(self) -> str:
        """The number as it is written on the bar."""
        left, right = self._weights
        return f"{left:.2f}" if left == right else f"{left:.2f} · {right:.2f}"

    def set_weight(self, weight: float) -> None:
        """Show a weight; emits nothing."""
        self.set_weights(weight, weight)

    def set_weights(self, left: float, right: float) -> None:
        """Show the weights of the two sides, which may differ; emits nothing."""
        if self._weights == (left, right):
            return
        self._weights = (left, right)
        self.blockSignals(True)
        self.setValue(round(self.weight * PERCENT))
        self.blockSignals(False)
        self.update()

    def set_now(self, weight: float) -> None:
        """Change the weight as one finished gesture."""
        self._show_and_tell(weight)
        self.committed.emit()

    def reset(self) -> None:
        """Back to zero."""
        if self._weights != (0.0, 0.0):
            self.set_now(0.0)

    def cancel(self) -> None:
        """Take the gesture in progress back."""
        drag, self._drag = self._drag, None
        if drag is not None and drag.moving:
            self.set_weights(*drag.start)
            self.cancelled.emit()
        self.update()

    def edit(self) -> None:
        """Open the number for typing."""
        if self._editor is None and self.isEnabled():
            self._editor = NumberEdit(self, f"{self.weight:g}")
            self._editor.entered.connect(self._enter)
            self._editor.dismissed.connect(self._close_editor)

    def sliderChange(self, change: QAbstractSlider.SliderChange) -> None:
        """A value set by assistive technology counts as a gesture."""
        super().sliderChange(change)
        if change == QAbstractSlider.SliderChange.SliderValueChange and not self.signalsBlocked():
            self.set_now(self.value() / PERCENT)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold; the right button resets, or cancels a drag that is under way."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag = Drag(event.position().x(), self._weights, self.weight)
            self.hovered.emit(False)
        elif event.button() == Qt.MouseButton.RightButton and self._drag is not None:
            self.cancel()
        elif event.button() == Qt.MouseButton.RightButton:
            self.reset()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The fill follows the pointer."""
        if self._drag is None:
            return
        self._drag = dragged(self._drag, event.position().x(), self.width(), event.modifiers())
        if self._drag.moving:
            self._show_and_tell(self._drag.weight)

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
        """The wheel scrolls the panel and never changes a face by accident."""
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
        elif (target := stepped(self.weight, key, event.modifiers())) is not None:
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
        return QSize(9 * GRID, ROW - 2)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the bar."""
        theme = current_theme()
        left, right = self._weights
        if self.side == "both" and left != right:
            fills: tuple[Fill, ...] = (Fill(left, theme.left), Fill(right, theme.right))
        else:
            fills = (Fill(self.weight, getattr(theme, self.side)),)
        bar = Bar(
            label=self.label,
            number=self.number,
            fills=fills,
            hovered=self.underMouse(),
            active=self.hasFocus() or self.held,
            enabled=self.isEnabled(),
        )
        paint_bar(QPainter(self), QRectF(self.rect()), bar, theme)

    def _show_and_tell(self, weight: float) -> None:
        self.set_weight(weight)
        self.previewed.emit(weight)

    def _finish_steps(self) -> None:
        if self._stepping:
            self._stepping = False
            self.committed.emit()

    def _enter(self, value: float) -> None:
        self._close_editor()
        self.set_now(min(max(value, 0.0), LARGEST_WEIGHT))

    def _close_editor(self) -> None:
        editor, self._editor = self._editor, None
        if editor is not None:
            editor.hide()
            editor.deleteLater()
            self.setFocus(Qt.FocusReason.OtherFocusReason)
