"""What to do first, on a timeline on which nothing happens yet."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.timeline.timeline import Timeline
from ui.theme.metrics import GRID
from ui.window.action_binding import ActionBinding

OFFERS: Sequence[tuple[str, str]] = (
    ("timeline.key", "Key this expression"),
    ("timeline.drop.happiness", "Add a smile"),
    ("timeline.import", "Import a capture…"),
    ("file.example.demo", "Show the demo"),
)


class EmptyHint(QFrame):
    """A card in the middle of the sheet, gone as soon as anything happens.

    Parameters
    ----------
    sheet : what it lies on
    timeline : what is empty
    binding : the actions of the window
    """

    def __init__(self, sheet: QWidget, timeline: Timeline, binding: ActionBinding) -> None:
        super().__init__(sheet)
        self._sheet, self._timeline = sheet, timeline
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GRID)
        words = QLabel("Pose the face and press <b>E</b>: a key expression. Go on in time, pose it again.")
        words.setWordWrap(True)
        words.setMinimumWidth(40 * GRID)
        words.setProperty("role", "muted")
        words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        layout.addWidget(words)
        row = QHBoxLayout()
        row.setSpacing(GRID)
        row.addStretch(1)
        for key, text in OFFERS:
            if key in binding.qt:
                button = QPushButton(text)
                button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
                button.clicked.connect(lambda _on, key=key: binding.perform(key))
                row.addWidget(button)
        row.addStretch(1)
        layout.addLayout(row)
        sheet.installEventFilter(self)
        timeline.document.animation_changed.connect(self._follow)
        timeline.document.project_changed.connect(self._follow)
        self._follow()

    def eventFilter(self, _sheet: QObject, event: QEvent) -> bool:
        """Stay in the middle."""
        if event.type() == QEvent.Type.Resize:
            self._place()
        return False

    def _follow(self, *_what: object) -> None:
        animation = self._timeline.animation
        self.setVisible(not animation.moves and animation.audio is None)
        self._place()

    def _place(self) -> None:
        self.adjustSize()
        room = self._sheet.rect()
        self.move((room.width() - self.width()) // 2, max((room.height() - self.height()) // 2, 0) + GRID)
