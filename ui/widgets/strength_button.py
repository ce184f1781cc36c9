"""A face that is a button and a bar at the same time: a click is full strength, a drag across it is any other."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QWidget

from ui.widgets.face_button import FaceButton
from ui.widgets.weight_gestures import THRESHOLD


class StrengthButton(FaceButton):
    """Shows how strongly something is on, from 0 to 1.

    Signals
    -------
    previewed(float) : the strength under a dragging pointer
    committed() : the drag is over and stays
    cancelled() : the drag is over and is taken back
    pressed_fully(bool) : clicked; true where it was not fully on before
    """

    previewed = Signal(float)
    committed = Signal()
    cancelled = Signal()
    pressed_fully = Signal(bool)

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(title, parent)
        self.setCheckable(True)
        self._pressed_at: float | None = None
        self._dragging = False
        self.clicked.connect(self._click)

    def set_strength(self, strength: float) -> None:
        """Show a strength; emits nothing."""
        self._strength = strength
        self.setChecked(strength > 0)
        self.update()

    def caption(self) -> str:
        """The word, or the number while it is dragged."""
        return f"{self._strength:.2f}" if self._dragging else self.text()

    def nextCheckState(self) -> None:
        """A click alone checks nothing: what is shown follows the face."""

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed_at = event.position().x()
            self._dragging = False
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Past the threshold the pointer sets the strength."""
        if self._pressed_at is None:
            return
        x = event.position().x()
        if not self._dragging and abs(x - self._pressed_at) < THRESHOLD:
            return
        self._dragging = True
        strength = round(min(max(x / max(1, self.width()), 0.0), 1.0), 2)
        self.set_strength(strength)
        self.previewed.emit(strength)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A drag is kept, a press without one is a click."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        dragging, self._dragging, self._pressed_at = self._dragging, False, None
        if dragging:
            self.setDown(False)
            self.committed.emit()
            self.update()
        else:
            super().mouseReleaseEvent(event)

    def take_back(self) -> bool:
        """End the drag under way, or the click, as if it had never been; whether there was one."""
        held, dragging = self._pressed_at is not None, self._dragging
        self._dragging, self._pressed_at = False, None
        self.setDown(False)
        if dragging:
            self.cancelled.emit()
        return held

    def _click(self) -> None:
        self.pressed_fully.emit(self._strength != 1.0)
