"""All keys, by menu; each can be changed."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QGridLayout,
    QHBoxLayout,
    QKeySequenceEdit,
    QLabel,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.actions.action import Action, shortcuts_of
from app.settings import UserSettings
from ui.theme.icons import icon
from ui.theme.metrics import GRID
from ui.widgets.plain_label import PlainLabel
from ui.window.action_binding import ActionBinding
from ui.window.shortcut_keys import with_keys

KEY_WIDTH = 20 * GRID

HANDS = (
    ("Right-drag, Alt-drag", "Turn about the head"),
    ("Middle-drag", "Move the picture"),
    ("Wheel", "Zoom to the pointer"),
    ("Drag a bar", "Set a weight: Shift is finer, Ctrl goes past 1, Esc takes it back"),
    ("Double-click a bar", "Type a number or a sum (also Enter)"),
    ("Right-click a bar", "Reset it (also Backspace)"),
    ("Arrows on a bar", "Step by 0.05, with Shift by 0.01"),
    ("Drag across an emotion", "Show some of it; a click shows all of it"),
)
"""What the hand does, which the table of actions does not list."""


class ShortcutPage(QDialog):
    """Lists the keys of every action in a menu and lets them be changed."""

    def __init__(self, parent: QWidget, binding: ActionBinding, settings: UserSettings) -> None:
        super().__init__(parent)
        self.setWindowTitle("Keyboard shortcuts")
        self._binding = binding
        self._settings = settings
        self.edits: dict[str, QKeySequenceEdit] = {}
        self._lines: list[tuple[str, tuple[QWidget, ...]]] = []
        self.search = QLineEdit()
        self.search.setPlaceholderText("Search actions and keys")
        self.search.addAction(icon("magnify"), QLineEdit.ActionPosition.LeadingPosition)
        self.search.textChanged.connect(self._filter)
        self.note = QLabel("Click a field and press the keys.")
        self.note.setProperty("role", "muted")
        defaults = QPushButton("Restore defaults")
        defaults.setAutoDefault(False)
        defaults.clicked.connect(self._restore)
        area = QScrollArea()
        area.setWidget(self._listing())
        area.setWidgetResizable(True)
        foot = QHBoxLayout()
        foot.addWidget(self.note, 1)
        foot.addWidget(defaults)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        layout.setSpacing(GRID)
        layout.addWidget(self.search)
        layout.addWidget(area, 1)
        layout.addLayout(foot)
        room = parent.size()
        self.resize(min(72 * GRID, room.width() - 8 * GRID), min(88 * GRID, room.height() - 8 * GRID))

    def _listing(self) -> QWidget:
        inside = QWidget()
        grid = QGridLayout(inside)
        grid.setContentsMargins(0, 0, GRID, 0)
        grid.setHorizontalSpacing(2 * GRID)
        grid.setVerticalSpacing(2)
        grid.setColumnStretch(0, 1)
        self._add_heading(grid, "Mouse")
        for hand, effect in HANDS:
            words = QLabel(hand)
            words.setProperty("role", "muted")
            self._add_line(grid, effect, words)
        menu = ""
        for action in self._binding.actions:
            if not action.menu or action.id.startswith("file.recent."):
                continue
            if action.menu[0] != menu:
                menu = action.menu[0]
                self._add_heading(grid, menu)
            self._add_line(grid, " › ".join((*action.menu[1:], action.title.rstrip("…"))), self._edit(action))
        grid.setRowStretch(grid.rowCount(), 1)
        return inside

    def _add_heading(self, grid: QGridLayout, text: str) -> None:
        heading = QLabel(text.upper())
        heading.setProperty("role", "heading")
        heading.setContentsMargins(0, 2 * GRID, 0, GRID // 2)
        grid.addWidget(heading, grid.rowCount(), 0, 1, 2)
        self._lines.append(("", (heading,)))

    def _add_line(self, grid: QGridLayout, title: str, keys: QWidget) -> None:
        words = PlainLabel(title)
        words.setWordWrap(True)
        keys.setFixedWidth(KEY_WIDTH)
        row = grid.rowCount()
        grid.addWidget(words, row, 0)
        grid.addWidget(keys, row, 1, Qt.AlignmentFlag.AlignRight)
        self._lines.append((title, (words, keys)))

    def _edit(self, action: Action) -> QKeySequenceEdit:
        edit = QKeySequenceEdit()
        edit.setMaximumSequenceLength(1)
        edit.setClearButtonEnabled(True)
        edit.setAccessibleName(f"Keys of {action.title}")
        edit.editingFinished.connect(lambda: self._change(action))
        self.edits[action.id] = edit
        self._show(action)
        return edit

    def _show(self, action: Action) -> None:
        keys = shortcuts_of(action, self._settings.preferences)
        self.edits[action.id].setKeySequence(QKeySequence(keys[0] if keys else ""))

    def _change(self, action: Action) -> None:
        preferences = self._settings.preferences
        keys = self.edits[action.id].keySequence().toString(QKeySequence.SequenceFormat.PortableText)
        before = shortcuts_of(action, preferences)
        if keys == (before[0] if before else ""):
            return
        shortcuts, robbed = with_keys(action, keys, self._binding.actions, preferences)
        self._settings.change(shortcuts=shortcuts)
        for other in robbed:
            if other.id in self.edits:
                self._show(other)
        title = action.title.rstrip("…")
        taken = f" and no longer to “{robbed[0].title.rstrip('…')}”" if robbed else ""
        self.note.setText(f"{keys} belongs to “{title}” now{taken}." if keys else f"“{title}” has no keys now.")

    def _restore(self) -> None:
        self._settings.change(shortcuts={})
        for action in self._binding.actions:
            if action.id in self.edits:
                self._show(action)
        self.note.setText("All keys are as they were at the first start.")

    def _filter(self, query: str) -> None:
        words = query.lower().split()
        for title, widgets in self._lines:
            keys = next((w.keySequence().toString() for w in widgets if isinstance(w, QKeySequenceEdit)), "")
            text = f"{title} {keys}".lower()
            for widget in widgets:
                widget.setVisible(not words or (bool(title) and all(word in text for word in words)))
