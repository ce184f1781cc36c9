"""A number without an end: one coordinate of a place, dragged slowly over a wide range."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize
from PySide6.QtGui import QMouseEvent, QPainter

from ui.theme.metrics import GRID
from ui.theme.roles import Theme
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

WIDE = 400.0
"""Millimetres about the middle of a head between which any place of it lies."""

SLOW = 16
"""Times its own width that a hand drags to go through the whole range: about a millimetre in two pixels."""


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

    def _paint_fill(self, painter: QPainter, area: QRectF, theme: Theme) -> None:
        """Nothing: only the number is read."""
