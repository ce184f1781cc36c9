"""How far an export is, and how long it still takes."""

from __future__ import annotations

import time

from PySide6.QtWidgets import QProgressBar, QVBoxLayout, QWidget

from ui.theme.metrics import GRID
from ui.widgets.plain_label import PlainLabel

STEPS = 1000
TELLING = 0.02
"""Share of the work after which what is left can be told."""


class ProgressLine(QWidget):
    """A bar with a line of text under it."""

    def __init__(self) -> None:
        super().__init__()
        self._begun: tuple[float, float] | None = None
        self.bar = QProgressBar()
        self.bar.setRange(0, STEPS)
        self.bar.setTextVisible(False)
        self.bar.setFixedHeight(GRID - 4)
        self.bar.setAccessibleName("Progress of the export")
        self.text = PlainLabel()
        self.text.setWordWrap(True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GRID)
        layout.addWidget(self.bar)
        layout.addWidget(self.text)
        self.rest("")

    def begin(self) -> None:
        """The work has begun."""
        self._begun = None
        self.show_share("Getting ready", 0.0)

    def show_share(self, text: str, share: float) -> None:
        """Show what is being done, the share that is done, and what is left of the time."""
        self.bar.setValue(round(STEPS * share))
        self.bar.setVisible(True)
        now = time.monotonic()
        if self._begun is None and share > 0:
            self._begun = now, share  # what came before was getting ready, and is no measure of the work
        since, at = self._begun or (now, share)
        self._say(f"{text}{_left(now - since, share - at, 1 - share)}", "muted")

    def rest(self, text: str, wrong: bool = False) -> None:
        """Say how it stands while nothing is done; what is wrong in the colour of errors."""
        self.bar.setVisible(False)
        self._say(text, "error" if wrong else "muted")

    def _say(self, text: str, role: str) -> None:
        self.text.setText(text)
        if self.text.property("role") != role:
            self.text.setProperty("role", role)
            self.text.style().unpolish(self.text)
            self.text.style().polish(self.text)


def _left(gone: float, done: float, rest: float) -> str:
    """The time that a rest takes, as people say it, if a share took so long; nothing before it can be told."""
    if done < TELLING:
        return ""
    left = round(gone * rest / done)
    if left < 60:
        return f" · {left} s left"
    return f" · {left // 60} min {left % 60:02} s left"
