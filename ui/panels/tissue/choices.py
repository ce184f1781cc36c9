"""A row of buttons of which one is pressed, and rows of buttons that act."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QGridLayout, QHBoxLayout, QPushButton, QSizePolicy, QToolButton, QWidget

from ui.theme.metrics import GRID


class Choices(QWidget):
    """One of a few names.

    Signals
    -------
    chosen(str) : the key of the one that a hand pressed
    """

    chosen = Signal(str)

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self._group = QButtonGroup(self)
        self._buttons: dict[str, QToolButton] = {}
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(2)

    def offer(self, titles: Mapping[str, str]) -> None:
        """Offer these, by key."""
        if list(titles) == list(self._buttons):
            return
        for button in self._buttons.values():
            self._group.removeButton(button)
            self._row.removeWidget(button)
            button.deleteLater()
        self._buttons = {key: self._made(key, title) for key, title in titles.items()}

    def press(self, key: str) -> None:
        """Show that one is chosen, or none with an empty key; emits nothing."""
        if key:
            self._buttons[key].setChecked(True)
            return
        self._group.setExclusive(False)
        for button in self._buttons.values():
            button.setChecked(False)
        self._group.setExclusive(True)

    def release(self) -> None:
        """Show that none is chosen; emits nothing."""
        pressed = self._group.checkedButton()
        if pressed is not None:
            self._group.setExclusive(False)
            pressed.setChecked(False)
            self._group.setExclusive(True)

    def button(self, key: str) -> QToolButton:
        """The button of one."""
        return self._buttons[key]

    def _made(self, key: str, title: str) -> QToolButton:
        button = QToolButton()
        button.setText(title)
        button.setCheckable(True)
        button.setProperty("role", "choice")
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.clicked.connect(lambda: self.chosen.emit(key))
        self._group.addButton(button)
        self._row.addWidget(button)
        return button


class Buttons(QWidget):
    """Buttons in columns.

    Attributes
    ----------
    by_name : the buttons by what they say
    """

    def __init__(self, entries: Sequence[tuple[str, str, Callable[[], None]]], columns: int) -> None:
        super().__init__()
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(GRID // 2)
        self.by_name: dict[str, QPushButton] = {}
        for place, (title, tip, act) in enumerate(entries):
            button = self.by_name[title] = QPushButton(title)
            button.setToolTip(tip)
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            button.clicked.connect(act)
            grid.addWidget(button, place // columns, place % columns)
