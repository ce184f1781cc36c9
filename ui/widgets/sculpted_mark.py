"""The mark in the margin of a row whose action unit somebody has sculpted."""

from __future__ import annotations

from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QPainter

from ui.theme.apply import current_theme

WIDTH = 3
GAP = 3
"""Pixels left free above and below."""


def paint_sculpted(painter: QPainter, row: QRectF) -> None:
    """A bar along the left edge of a row."""
    painter.fillRect(QRectF(row.x(), row.y() + GAP, WIDTH, row.height() - 2 * GAP), QColor(current_theme().ok))
