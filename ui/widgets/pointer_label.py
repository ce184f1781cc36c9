"""A few words beside the pointer."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QWidget

from ui.theme.metrics import GRID
from ui.widgets.plain_label import PlainLabel


class PointerLabel(PlainLabel):
    """Lies over its parent, follows the pointer and never takes the mouse from what is below."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent=parent)
        self.setProperty("role", "pointer")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def say(self, text: str, pointer: QPoint) -> None:
        """Show a text beside a point of the parent, inside of it; nothing for an empty text."""
        if not text:
            self.hide()
            return
        self.setText(text)
        self.adjustSize()
        room = self.parentWidget().rect()
        x = min(pointer.x() + 2 * GRID, room.right() - self.width() - GRID)
        y = pointer.y() + 2 * GRID
        if y + self.height() > room.bottom() - GRID:
            y = pointer.y() - self.height() - GRID
        self.move(max(GRID, x), max(GRID, y))
        self.show()
        self.raise_()
