"""One question about the work that killed sessions have left."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import date, datetime

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.journal import Recoverable
from ui.theme.metrics import GRID, ROW
from ui.widgets.plain_label import as_written

WIDTH = 56 * GRID
MOST_ROWS = 6
"""Entries that are seen without scrolling."""

ENTRY = Qt.ItemDataRole.UserRole


class RecoveryOffer(QDialog):
    """Asks what becomes of unsaved work; closed without an answer, it asks again at the next start.

    Parameters
    ----------
    parent : the window it belongs to
    entries : what can be brought back, the latest first; at least one

    Signals
    -------
    accepted_entry(Recoverable) : is to be brought back; the offer is closed, the others wait for the next start
    declined(Recoverable) : is not wanted any more
    """

    accepted_entry = Signal(object)
    declined = Signal(object)

    def __init__(self, parent: QWidget, entries: Sequence[Recoverable]) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Unsaved work")
        self.setFixedWidth(WIDTH)
        self.list = self._listed(entries)
        self.bring_back = self._button("Bring back", "Open it with its changes", self._accept)
        self.discard = self._button("Discard", "Remove it for good", self._decline)
        self.later = self._button("Later", "Leave it and ask again at the next start (Esc)", self.reject)
        self.bring_back.setDefault(True)
        title = QLabel("Risorius ended before this was saved.")
        title.setProperty("role", "title")
        title.setWordWrap(True)
        words = QLabel("Bring back the changes, discard them for good, or decide at the next start.")
        words.setWordWrap(True)
        words.setProperty("role", "muted")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 2 * GRID)
        layout.setSpacing(GRID)
        for part in (title, words, self.list):
            layout.addWidget(part)
        layout.addSpacing(GRID)
        layout.addLayout(self._answers())
        self.bring_back.setFocus()

    def _listed(self, entries: Sequence[Recoverable]) -> QListWidget:
        rows = QListWidget()
        rows.setAccessibleName("Work that can be brought back")
        for entry in entries:
            row = QListWidgetItem(f"{entry.name}  ·  {_spoken(entry.when)}", rows)
            row.setData(ENTRY, entry)
            row.setSizeHint(QSize(0, ROW))
            row.setToolTip(as_written(str(entry.path or "Never saved to a file")))
        rows.setCurrentRow(0)
        rows.setFixedHeight(min(len(entries), MOST_ROWS) * ROW)
        rows.itemDoubleClicked.connect(self._accept)
        return rows

    def _button(self, text: str, tip: str, act: object) -> QPushButton:
        button = QPushButton(text)
        button.setAutoDefault(False)
        button.setToolTip(tip)
        button.clicked.connect(act)
        return button

    def _answers(self) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setSpacing(GRID)
        line.addWidget(self.discard)
        line.addStretch(1)
        line.addWidget(self.later)
        line.addWidget(self.bring_back)
        return line

    def _accept(self) -> None:
        entry = self.list.currentItem().data(ENTRY)
        self.accept()
        self.accepted_entry.emit(entry)

    def _decline(self) -> None:
        row = self.list.takeItem(self.list.currentRow())
        self.declined.emit(row.data(ENTRY))
        if self.list.count() == 0:
            self.reject()


def _spoken(when: datetime) -> str:
    """A time as people say it: the day only where it is another one."""
    today = date.today()
    if when.date() == today:
        return f"today {when:%H:%M}"
    year = "" if when.year == today.year else f" {when.year}"
    return f"{when.day} {when:%B}{year}, {when:%H:%M}"
