"""A dock with a quiet title."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QHBoxLayout, QLabel, QToolButton, QWidget

from ui.theme.icons import icon
from ui.theme.metrics import GRID

AIR = 4
"""Pixels above and below the title; a dock takes the height of its title from this layout alone."""


class Dock(QDockWidget):
    """Can be moved, floated and closed; its name keeps its place in a saved layout."""

    def __init__(self, name: str, title: str, content: QWidget) -> None:
        super().__init__(title)
        self.setObjectName(name)
        self.setWidget(content)
        self.setTitleBarWidget(self._title(title))

    def retitle(self, title: str) -> None:
        """Take another title; the name stays."""
        self.setWindowTitle(title)
        self._words.setText(title.upper())

    def _title(self, title: str) -> QWidget:
        words = self._words = QLabel(title.upper())
        words.setProperty("role", "heading")
        line = QWidget()
        line.setProperty("role", "panel")
        line.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        layout = QHBoxLayout(line)
        layout.setContentsMargins(GRID, AIR, GRID // 2, AIR)
        layout.setSpacing(0)
        layout.addWidget(words, 1)
        for button in self._title_buttons(title):
            layout.addWidget(button)
        return line

    def _title_buttons(self, title: str) -> tuple[QToolButton, ...]:
        return (
            _button("dock-window", f"Float {title}", lambda: self.setFloating(not self.isFloating())),
            _button("close", f"Close {title}", self.close),
        )


def _button(glyph: str, text: str, act: object) -> QToolButton:
    button = QToolButton()
    button.setIcon(icon(glyph))
    button.setProperty("role", "small")
    button.setToolTip(text)
    button.setAccessibleName(text)
    button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    button.clicked.connect(act)
    return button
