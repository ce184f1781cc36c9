"""A number of one axis in a row of three: dragged slowly over a wide range, marked with the colour of its axis."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize
from PySide6.QtGui import QColor, QMouseEvent, QPainter

from ui.theme.metrics import GRID, ROW
from ui.theme.roles import Theme
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

AXIS_COLOURS = {"x": "#e85c5e", "y": "#78bf61", "z": "#5499f0"}
"""As the handles in the picture."""

MARK = 3
"""Pixels."""


class AxisBar(NumberBar):
    """Shows the number of an axis.

    Parameters
    ----------
    axis : ``x``, ``y`` or ``z``
    scale : its range
    slow : times its own width that a hand drags to go through the whole range
    """

    def __init__(self, axis: str, scale: NumberScale, slow: float) -> None:
        super().__init__(axis, scale)
        self._slow = slow

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The number follows the pointer slowly."""
        if self._drag is None:
            return
        drag = self._drag = self._drag.moved(event.position().x(), self._slow * self.width(), event.modifiers())
        if drag.moving:
            self._show_and_tell(self.scale.rounded(self.scale.value(drag.reached), finer=int(drag.fine)))

    def sizeHint(self) -> QSize:
        """Room for three beside each other."""
        return QSize(11 * GRID, ROW - 2)

    def _paint_fill(self, painter: QPainter, area: QRectF, theme: Theme) -> None:
        """Only the mark of the axis: the number is read, and its place in so wide a range says nothing."""
        colour = QColor(AXIS_COLOURS[self.label]) if self.isEnabled() else QColor(theme.line)
        painter.fillRect(QRectF(area.x(), area.y(), MARK, area.height()), colour)
