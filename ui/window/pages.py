"""Pages to read: all keys, and what this program is."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QFrame, QGridLayout, QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from app.actions.action import Action
from ui.theme.metrics import GRID
from ui.window.action_binding import ActionBinding

HANDS = (
    ("Right drag, Alt drag", "Turn about the head"),
    ("Middle drag", "Move the picture"),
    ("Wheel", "Zoom to the pointer"),
    ("Drag a bar", "Set a weight; Shift is finer, Ctrl goes past 1, Esc takes it back"),
    ("Double-click a bar, Enter", "Type a number or a sum"),
    ("Right-click a bar, Backspace", "Reset it"),
    ("Arrows on a bar", "Step by 0.05, with Shift by 0.01"),
    ("Click an emotion", "Show all of it; drag across it for less"),
)
"""What the mouse does, which no table of keys lists."""


def shortcuts_page(parent: QWidget, binding: ActionBinding) -> QDialog:
    """All keys by menu, in two columns."""
    columns = (QVBoxLayout(), QVBoxLayout())
    sections = _key_sections(binding)
    half = sum(len(lines) + 2 for _, lines in sections) / 2
    filled = 0
    for title, lines in sections:
        column = columns[0] if filled < half else columns[1]
        filled += len(lines) + 2
        column.addWidget(_heading(title))
        column.addLayout(_key_table(lines))
    inside = QWidget()
    inside.setProperty("role", "panel")
    across = QHBoxLayout(inside)
    across.setContentsMargins(3 * GRID, GRID, 3 * GRID, 3 * GRID)
    across.setSpacing(6 * GRID)
    for column in columns:
        column.addStretch(1)
        across.addLayout(column, 1)
    page = QDialog(parent)
    page.setWindowTitle("Keyboard shortcuts")
    area = QScrollArea()
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidget(inside)
    area.setWidgetResizable(True)
    layout = QVBoxLayout(page)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.addWidget(area)
    room = parent.size()
    page.resize(min(112 * GRID, room.width() - 8 * GRID), min(88 * GRID, room.height() - 8 * GRID))
    return page


def about_page(parent: QWidget) -> QDialog:
    """Name, version, licence and where the data come from."""
    page = QDialog(parent)
    page.setWindowTitle("About Risorius")
    layout = QVBoxLayout(page)
    layout.setContentsMargins(4 * GRID, 3 * GRID, 4 * GRID, 3 * GRID)
    layout.setSpacing(GRID)
    title = QLabel("Risorius")
    title.setProperty("role", "title")
    layout.addWidget(title)
    layout.addWidget(_muted(f"Version {_version()}"))
    for text in (
        "An editor for facial expression: muscles pull on skin, the skin is solved with finite elements, "
        "and sliders mix the solutions in real time.",
        "Program under the MIT licence. The shipped faces derive from MakeHuman's base mesh and targets, CC0.",
        "Drawn with VTK and Qt; computed with NumPy, SciPy and libigl.",
    ):
        words = QLabel(text)
        words.setWordWrap(True)
        words.setMinimumWidth(48 * GRID)
        layout.addWidget(words)
    return page


def _key_sections(binding: ActionBinding) -> list[tuple[str, list[tuple[str, str]]]]:
    sections: dict[str, list[tuple[str, str]]] = {}
    for action in binding.actions:
        keys = binding.keys(action)
        if keys:
            sections.setdefault(_section(action), []).append((keys, action.title.rstrip("…")))
    return [("Mouse", list(HANDS)), *sections.items()]


def _section(action: Action) -> str:
    return action.menu[0] if action.menu else "Elsewhere"


def _key_table(lines: Sequence[tuple[str, str]]) -> QGridLayout:
    grid = QGridLayout()
    grid.setHorizontalSpacing(2 * GRID)
    grid.setVerticalSpacing(GRID // 2)
    grid.setColumnStretch(1, 1)
    for row, (keys, title) in enumerate(lines):
        words = QLabel(title)
        words.setWordWrap(True)
        grid.addWidget(_muted(keys), row, 0, Qt.AlignmentFlag.AlignTop)
        grid.addWidget(words, row, 1)
    return grid


def _heading(text: str) -> QLabel:
    heading = QLabel(text.upper())
    heading.setProperty("role", "heading")
    heading.setContentsMargins(0, 2 * GRID, 0, GRID // 2)
    return heading


def _muted(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "muted")
    return label


def _version() -> str:
    try:
        return version("risorius")
    except PackageNotFoundError:
        return "from source"
