"""The bottom line: a hint for the hand, the progress of a solve with its cancel button, the journal, the face."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QLabel, QProgressBar, QPushButton, QStatusBar, QWidget

from ui.theme.metrics import GRID, ROW
from ui.widgets.elided_label import ElidedLabel
from ui.widgets.plain_label import PlainLabel, as_written

NOTICE_TIME = 6000
"""Milliseconds for which a notice stands in the place of the hint."""

SOON = 250
"""Milliseconds for which work may go on before its progress is shown: what is over in a blink does not flicker, and a
bar that moves has the whole window painted each time."""

BAR_WIDTH = 20 * GRID
STEPS = 1000


class StatusLine(QStatusBar):
    """Bottom line of the window.

    Signals
    -------
    cancel_asked() : the button beside the progress bar was pressed
    """

    cancel_asked = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizeGripEnabled(False)
        self.setContentsMargins(GRID, 0, GRID, 0)
        self.setFixedHeight(ROW + 4)
        self._hint = ""
        self.hint = ElidedLabel()
        self.step = PlainLabel()
        self.bar = QProgressBar()
        self.bar.setRange(0, STEPS)
        self.bar.setTextVisible(False)
        self.bar.setFixedSize(BAR_WIDTH, GRID - 4)
        self.bar.setAccessibleName("Progress of solving")
        self.cancel = QPushButton("Cancel")
        self.cancel.setProperty("role", "status")
        self.cancel.setToolTip("Stop solving and keep the last face (Esc)")
        self.cancel.clicked.connect(self.cancel_asked)
        self.kept = PlainLabel()
        self.kept.setContentsMargins(0, 0, GRID, 0)
        self.kept.hide()
        self.state = QLabel()
        self.state.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self.addWidget(self.hint, 1)
        for widget in (self.step, self.bar, self.cancel, self.kept, self.state):
            self.addPermanentWidget(widget)
        self._timer = QTimer(self, singleShot=True, interval=NOTICE_TIME)
        self._timer.timeout.connect(lambda: self.hint.setText(self._hint))
        self._reveal = QTimer(self, singleShot=True, interval=SOON)
        self._reveal.timeout.connect(self._show_bar)
        self.end_progress()

    def show_hint(self, text: str) -> None:
        """What the tool in hand does; it waits while a notice is shown."""
        self._hint = text
        if not self._timer.isActive():
            self.hint.setText(text)

    def notify(self, text: str) -> None:
        """Something that has just happened, for a few seconds."""
        self.hint.setText(text)
        self._timer.start()

    def withdraw(self, text: str) -> None:
        """End a notice that is over; one that has come since stays."""
        if self._timer.isActive() and self.hint.text() == text:
            self._timer.stop()
            self.hint.setText(self._hint)

    def show_progress(self, text: str, share: float) -> None:
        """How far a solve is, 0..1; it is seen if it is not over soon."""
        self.step.setText(text)
        self.bar.setValue(round(share * STEPS))
        if self.bar.isHidden() and not self._reveal.isActive():
            self._reveal.start()

    def _show_bar(self) -> None:
        for widget in (self.step, self.bar, self.cancel):
            widget.show()

    def end_progress(self) -> None:
        """Nothing is being solved."""
        self._reveal.stop()
        for widget in (self.step, self.bar, self.cancel):
            widget.hide()

    def show_kept(self, text: str, tip: str) -> None:
        """What is kept safe of unsaved work, in two words, and what they mean; nothing to say if empty."""
        self.kept.setText(text)
        self.kept.setToolTip(as_written(tip))
        self.kept.setVisible(bool(text))

    def show_state(self, text: str, tip: str) -> None:
        """The state of the face in a few characters, and what they mean."""
        self.state.setText(text)
        self.state.setToolTip(tip)
