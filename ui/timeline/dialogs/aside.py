"""Where a page stands over a window that stays in reach."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog

from ui.theme.metrics import GRID


def stand_aside(page: QDialog) -> None:
    """Put a page at the upper right of its window, so that the face and the timeline can be seen to move."""
    window = page.parentWidget().window().frameGeometry()
    page.move(window.right() - page.width() - 2 * GRID, window.top() + 5 * GRID)
