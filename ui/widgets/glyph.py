"""A glyph of the icon font as a widget, in a colour of the theme."""

from __future__ import annotations

import qtawesome
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.theme.apply import current_theme
from ui.theme.icons import FAMILY
from ui.theme.metrics import ICON


class Glyph(QWidget):
    """One glyph; ``role`` names its colour in the theme."""

    def __init__(self, glyph: str, role: str = "muted", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.glyph = glyph
        self.role = role
        self.setFixedSize(QSize(ICON, ICON))

    def become(self, glyph: str, role: str) -> None:
        """Show another glyph or colour."""
        self.glyph, self.role = glyph, role
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the glyph."""
        painter = QPainter(self)
        painter.setPen(QColor(getattr(current_theme(), self.role)))
        painter.setFont(qtawesome.font(FAMILY, ICON))
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, qtawesome.charmap(f"{FAMILY}.{self.glyph}"))
