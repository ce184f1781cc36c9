"""A line that remembers what was entered in it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QLineEdit


class HistoryLine(QLineEdit):
    """Up and Down go through what was entered before; what was being typed comes back at the end.

    Signals
    -------
    entered(str) : Enter was pressed; the line is empty again
    dismissed() : Esc was pressed; the line is empty
    """

    entered = Signal(str)
    dismissed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._past: list[str] = []
        self._place = 0
        self._draft = ""
        self.returnPressed.connect(self._enter)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Walk through the past; everything else is typing."""
        if event.key() == Qt.Key.Key_Up:
            self._walk(-1)
        elif event.key() == Qt.Key.Key_Down:
            self._walk(1)
        elif event.key() == Qt.Key.Key_Escape:
            self._begin_anew()
            self.dismissed.emit()
        else:
            super().keyPressEvent(event)

    def event(self, event: QEvent) -> bool:
        """An empty line has nothing to undo, so the keys for that reach the document."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and not self.text():
            history = event.matches(QKeySequence.StandardKey.Undo) or event.matches(QKeySequence.StandardKey.Redo)
            if history:
                event.ignore()
                return False
        return super().event(event)

    def _enter(self) -> None:
        text = self.text()
        if text.strip() and self._past[-1:] != [text]:
            self._past.append(text)
        self._begin_anew()
        self.entered.emit(text)

    def _begin_anew(self) -> None:
        self._place, self._draft = len(self._past), ""
        self.setText("")

    def _walk(self, step: int) -> None:
        place = self._place + step
        if not 0 <= place <= len(self._past):
            return
        if self._place == len(self._past):
            self._draft = self.text()
        self._place = place
        self.setText(self._draft if place == len(self._past) else self._past[place])
