"""A line of text that shows what stands, takes what is typed, and goes back to what stands when that is left."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import QLineEdit


class StandingLine(QLineEdit):
    """Says once what was typed, on Enter or when the keyboard goes elsewhere; Esc brings back what stands.

    Signals
    -------
    entered(str) : a text was typed that is not the one that stands
    """

    entered = Signal(str)

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self._standing = ""
        self.returnPressed.connect(self._enter)
        self.textEdited.connect(lambda _text: self._mark(False))

    def stand(self, text: str) -> None:
        """Let a text stand; what is being typed stays until it is entered or left."""
        typing = self.hasFocus() and self.text() != self._standing
        self._standing = text
        if not typing:
            self._restore()

    def accept_typed(self, text: str) -> None:
        """What was typed was taken: from now on this stands."""
        self._standing = text
        self._restore()

    def refuse(self) -> None:
        """What was typed cannot stand: it may be corrected."""
        self._mark(True)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc brings back what stands."""
        if event.key() == Qt.Key.Key_Escape and self.text() != self._standing:
            self._restore()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Enter what was typed; if that cannot stand, it goes."""
        super().focusOutEvent(event)
        self._enter()
        self._restore()

    def _enter(self) -> None:
        if self.text().strip() != self._standing:
            self.entered.emit(self.text().strip())

    def _restore(self) -> None:
        self.setText(self._standing)
        self.setCursorPosition(0)
        self._mark(False)

    def _mark(self, wrong: bool) -> None:
        if bool(self.property("wrong")) != wrong:
            self.setProperty("wrong", wrong)
            self.style().unpolish(self)
            self.style().polish(self)
