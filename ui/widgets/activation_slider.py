"""A filled bar that carries its name and its number: the control for a weight."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QMouseEvent,
    QPainter,
    QPaintEvent,
)
from PySide6.QtWidgets import QAbstractSlider, QWidget

from app.weights import LARGEST_WEIGHT
from ui.theme.apply import current_theme
from ui.theme.metrics import GRID, ROW
from ui.widgets.bar_hands import BarHands
from ui.widgets.bar_paint import Bar, Fill, paint_bar
from ui.widgets.weight_gestures import USUAL, Drag, WeightScale, dragged, stepped

FillSide = Literal["left", "right", "both"]

PERCENT = 100
"""Steps of the integer value that assistive technology reads: percent of full contraction."""


class ActivationSlider(BarHands, QAbstractSlider):
    """Shows one weight, or those of left and right together, and lets the hand change it.

    Dragging is relative: the fill follows the pointer.  Ctrl goes past 1, Shift is finer, Esc restores.  Arrow keys
    step, Home and End go to the ends of the bar, Enter or a double click edits the number, Backspace or a right click
    resets.

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
        self._label = label
        self.side: FillSide = side
        self._scale = USUAL
        self._weights = (0.0, 0.0)
        self.setOrientation(Qt.Orientation.Horizontal)
        self.setRange(0, int(LARGEST_WEIGHT * PERCENT))
        self._get_ready(label)

    @property
    def label(self) -> str:
        """What stands on the bar."""
        return self._label

    @label.setter
    def label(self, label: str) -> None:
        if label != self._label:
            self._label = label
            self.update()

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
        left, right = map(self._scale.text, self._weights)
        return left if self._weights[0] == self._weights[1] else f"{left} · {right}"

    @property
    def scale(self) -> WeightScale:
        """How far it goes, and how its weight is told and typed."""
        return self._scale

    @scale.setter
    def scale(self, scale: WeightScale) -> None:
        self._scale = scale
        self.blockSignals(True)
        self.setRange(0, round(scale.limit * PERCENT))
        self.setValue(round(self.weight * PERCENT))
        self.blockSignals(False)
        self.update()

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

    def sliderChange(self, change: QAbstractSlider.SliderChange) -> None:
        """A value set by assistive technology counts as a gesture."""
        super().sliderChange(change)
        if change == QAbstractSlider.SliderChange.SliderValueChange and not self.signalsBlocked():
            self.set_now(self.value() / PERCENT)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The fill follows the pointer."""
        if self._drag is None:
            return
        self._drag = dragged(self._drag, event.position().x(), self.width(), event.modifiers(), self._scale)
        if self._drag.moving:
            self._show_and_tell(self._drag.weight)

    def minimumSizeHint(self) -> QSize:
        """One row, wide enough for the number."""
        return QSize(9 * GRID, ROW - 2)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the bar."""
        theme = current_theme()
        left, right = self._weights
        full = self._scale.full
        if self.side == "both" and left != right:
            fills: tuple[Fill, ...] = (Fill(left / full, theme.left), Fill(right / full, theme.right))
        else:
            fills = (Fill(self.weight / full, getattr(theme, self.side)),)
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

    def _enter(self, value: float) -> None:
        self._close_editor()
        self.set_now(min(max(value, 0.0), self._scale.limit))

    def _written(self) -> str:
        return f"{self.weight:g}"

    def _stepped(self, key: int, modifiers: Qt.KeyboardModifier) -> float | None:
        return stepped(self.weight, key, modifiers, self._scale)

    def _read(self, text: str) -> float:
        return self._scale.read(text)

    def _grasp(self, x: float) -> Drag:
        self.hovered.emit(False)
        return Drag(x, self._weights, self.weight)

    def _restore(self, drag: Drag) -> None:
        self.set_weights(*drag.start)
