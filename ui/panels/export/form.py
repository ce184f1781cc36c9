"""Rows of a form: a caption, and what is chosen beside it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QGridLayout, QLabel, QWidget

from ui.theme.metrics import GRID, ROW, TYPE

CAPTION = 12 * GRID
"""Width of the captions."""


class Form(QGridLayout):
    """Captions on the left, fields on the right, and headings over groups of them."""

    def __init__(self) -> None:
        super().__init__()
        self.setContentsMargins(0, 0, 0, 0)
        self.setHorizontalSpacing(GRID)
        self.setVerticalSpacing(GRID // 2)
        self.setColumnMinimumWidth(0, CAPTION)
        self.setColumnStretch(1, 1)
        self.setColumnStretch(2, 1)

    def head(self, text: str) -> None:
        """A heading over the rows that follow."""
        heading = QLabel(text.upper())
        heading.setProperty("role", "heading")
        heading.setContentsMargins(0, TYPE, 0, 0)
        self.addWidget(heading, self.rowCount(), 0, 1, 3)

    def row(self, caption: str, field: QWidget, beside: QWidget | None = None) -> None:
        """A caption with one field, or with two side by side."""
        name = QLabel(caption)
        name.setProperty("role", "muted")
        name.setBuddy(field)
        line = self.rowCount()
        self.setRowMinimumHeight(line, ROW)
        self.addWidget(name, line, 0, Qt.AlignmentFlag.AlignVCenter)
        self.addWidget(field, line, 1, 1, 1 if beside is not None else 2)
        if beside is not None:
            self.addWidget(beside, line, 2)


def choice(name: str, options: Mapping[str, str], tip: str = "") -> QComboBox:
    """A list to choose one of some keys from, each with its title."""
    box = QComboBox()
    box.setAccessibleName(name)
    box.setToolTip(tip)
    for key, title in options.items():
        box.addItem(title, key)
    return box


def choose(box: QComboBox, key: str) -> None:
    """Show a key in a list."""
    box.setCurrentIndex(max(0, box.findData(key)))


def part_groups(box: QComboBox, keys: Iterable[str]) -> None:
    """Draw a line in a list before each of some keys."""
    for key in keys:
        box.insertSeparator(box.findData(key))
