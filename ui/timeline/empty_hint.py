"""What to do first, on a timeline on which nothing happens yet."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.timeline.timeline import Timeline
from ui.theme.metrics import GRID
from ui.window.action_binding import ActionBinding

OFFERS: Sequence[tuple[str, str]] = (
    ("timeline.key", "Key this expression"),
    ("timeline.drop.happiness", "Add a smile"),
    ("timeline.import", "Import a capture…"),
    ("file.example.demo", "Show the demo"),
)

LEAST = 40 * GRID
"""Width of the words, where there is room for it."""


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
        words.setProperty("role", "muted")
        words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        layout.addWidget(words)
        self.offers = [self._offer(key, text, binding) for key, text in OFFERS if key in binding.qt]
        self._columns = 0
        self._rows = QGridLayout()
        self._rows.setSpacing(GRID)
        layout.addLayout(self._rows)
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

    def _offer(self, key: str, text: str, binding: ActionBinding) -> QPushButton:
        button = QPushButton(text)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.clicked.connect(lambda _on: binding.perform(key))
        return button

    def _arrange(self, columns: int) -> None:
        """Put the offers side by side, or some below the others."""
        if columns != self._columns:
            self._columns = columns
            for place, button in enumerate(self.offers):
                self._rows.addWidget(button, *divmod(place, columns))

    def _place(self) -> None:
        room = self._sheet.rect()
        widest = max((button.sizeHint().width() for button in self.offers), default=0) + GRID
        fits = (room.width() - GRID) // widest if widest else 1
        self._arrange(next(columns for columns in (4, 2, 1) if columns <= max(fits, 1)))
        width = min(self._columns * widest - GRID if self._columns > 1 else 0, room.width() - 2 * GRID)
        width = min(max(width, LEAST), room.width() - 2 * GRID)
        self.resize(width, self.layout().heightForWidth(width))
        self.move((room.width() - self.width()) // 2, max((room.height() - self.height()) // 2, 0) + GRID)
