"""A number without an end: one coordinate of a place, dragged slowly over a wide range."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QMouseEvent, QPainter

from ui.theme.metrics import GRID
from ui.theme.roles import Theme
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

WIDE = 400.0
"""Millimetres about the middle of a head between which any place of it lies."""

SLOW = 16
"""Times its own width that a hand drags to go through the whole range: about a millimetre in two pixels."""


STEP, FINE_STEP = 0.5, 0.1
"""Millimetres of an arrow key; PageUp and PageDown go ten of them."""

Key = Qt.Key


class CoordinateBar(NumberBar):
    """Shows x, y or z in millimetres.  Nothing resets it, for it has no default, and it has no fill, for zero is
    nowhere in particular.
    """

    def __init__(self, axis: str) -> None:
        super().__init__(axis, NumberScale(-WIDE, WIDE, 0.0))

    def minimumSizeHint(self) -> QSize:
        """Narrow: three of them stand in one row."""
        return QSize(7 * GRID, super().minimumSizeHint().height())

    def reset(self) -> None:
        """Stay: no place is more usual than another."""

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The number follows the pointer slowly."""
        if self._drag is None:
            return
        drag = self._drag = self._drag.moved(event.position().x(), SLOW * self.width(), event.modifiers())
        if drag.moving:
            self._show_and_tell(self.scale.rounded(self.scale.value(drag.reached), finer=1))

    def _stepped(self, key: int, modifiers: Qt.KeyboardModifier) -> float | None:
        """Half a millimetre a step, with Shift a fifth of that; there is no end to go to."""
        ways = {Key.Key_Right: 1, Key.Key_Up: 1, Key.Key_Left: -1, Key.Key_Down: -1}
        ways |= {Key.Key_PageUp: 10, Key.Key_PageDown: -10}
        if key not in ways:
            return None
        step = FINE_STEP if modifiers & Qt.KeyboardModifier.ShiftModifier else STEP
        return self.scale.rounded(self._value + step * ways[Key(key)], finer=2)

    def _paint_fill(self, painter: QPainter, area: QRectF, theme: Theme) -> None:
        """Nothing: only the number is read."""
