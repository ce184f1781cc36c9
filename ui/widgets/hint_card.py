"""The card of the first start: a few things to try, each ticked off when it is done."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from ui.theme.icons import icon
from ui.theme.metrics import GRID
from ui.widgets.glyph import Glyph

LINGER = 1600
"""Milliseconds for which the card stays after the last thing was done, so that the last tick is seen."""

TODO = "circle-outline"
DONE = "check-circle"


class HintCard(QFrame):
    """Things to try by key and sentence.

    Signals
    -------
    dismissed() : everything was done, or a person closed it
    """

    dismissed = Signal()

    def __init__(self, title: str, hints: Sequence[tuple[str, str]], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "card")
        self.setAccessibleName(title)
        self._marks: dict[str, Glyph] = {}
        self._left = {key for key, _ in hints}
        heading = QLabel(title)
        close = QToolButton()
        close.setIcon(icon("close"))
        close.setProperty("role", "small")
        close.setToolTip("Do not show this again")
        close.setAccessibleName("Close the hints")
        close.clicked.connect(self.dismissed)
        head = QHBoxLayout()
        head.addWidget(heading)
        head.addStretch(1)
        head.addWidget(close)
        grid = QGridLayout()
        grid.setHorizontalSpacing(GRID)
        grid.setVerticalSpacing(GRID)
        grid.setColumnStretch(1, 1)
        for row, (key, sentence) in enumerate(hints):
            self._marks[key] = Glyph(TODO)
            self._marks[key].setAccessibleName("to do")
            words = QLabel(sentence)
            words.setTextFormat(Qt.TextFormat.RichText)
            grid.addWidget(self._marks[key], row, 0)
            grid.addWidget(words, row, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2 * GRID, GRID, GRID, 2 * GRID)
        layout.setSpacing(GRID)
        layout.addLayout(head)
        layout.addLayout(grid)

    @property
    def left(self) -> frozenset[str]:
        """Keys of what is still to be tried."""
        return frozenset(self._left)

    def tick(self, key: str) -> None:
        """Mark a thing as done."""
        if key not in self._left:
            return
        self._left.discard(key)
        self._marks[key].become(DONE, "ok")
        self._marks[key].setAccessibleName("done")
        if not self._left:
            QTimer.singleShot(LINGER, self.dismissed.emit)
