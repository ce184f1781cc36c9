"""What an empty list says: what could be in it, and how it comes there."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QAbstractItemView

from ui.theme.apply import current_theme
from ui.theme.metrics import GRID


def paint_empty(view: QAbstractItemView, words: str) -> None:
    """Write some words in the middle of a list; to be called while it is painted."""
    painter = QPainter(view.viewport())
    painter.setPen(QColor(current_theme().muted))
    room = QRectF(view.viewport().rect()).adjusted(3 * GRID, GRID, -3 * GRID, -GRID)
    painter.drawText(room, Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, words)
