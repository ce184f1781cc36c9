"""A button with a glyph and no words, which says what it does when asked."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QToolButton

from ui.theme.icons import icon
from ui.theme.metrics import ICON


def tool_button(glyph: str, text: str, act: Callable[[], None]) -> QToolButton:
    """A button that calls ``act`` when it is clicked."""
    button = QToolButton()
    button.setIcon(icon(glyph))
    button.setIconSize(QSize(ICON, ICON))
    button.setToolTip(text)
    button.setAccessibleName(text.partition(":")[0])
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.clicked.connect(lambda _checked=False: act())
    return button
