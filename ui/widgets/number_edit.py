"""A line that takes a number or a sum, opened in place over the control it belongs to."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import QLineEdit, QToolTip, QWidget

from app.arithmetic import evaluate
from app.errors import NumberError


class NumberEdit(QLineEdit):
    """Edits one number; it reports the value once and is then done.

    Parameters
    ----------
    parent : the control that it lies over
    text : what is there to begin with
    read : the number that a text means; raises `NumberError`, whose sentence is then shown

    Signals
    -------
    entered(float) : Enter was pressed on something that has a value
    dismissed() : Esc, or the focus went elsewhere without a valid value
    """

    entered = Signal(float)
    dismissed = Signal()

    def __init__(self, parent: QWidget, text: str, read: Callable[[str], float] = evaluate) -> None:
        super().__init__(text, parent)
        self._read = read
        self._done = False
        self.setAccessibleName("Number or sum")
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setGeometry(parent.rect())
        QWidget.setTabOrder(parent, self)
        self.textEdited.connect(self._forgive)
        self.selectAll()
        self.show()
        self.setFocus(Qt.FocusReason.PopupFocusReason)

    def finish(self) -> None:
        """Report the value, or say what is wrong with the text and stay open."""
        if self._done:
            return
        try:
            value = self._read(self.text())
        except NumberError as error:
            self._mark_wrong(True)
            QToolTip.showText(self.mapToGlobal(self.rect().bottomLeft()), str(error), self)
            return
        self._done = True
        self.entered.emit(value)

    def dismiss(self) -> None:
        """Go away without a value."""
        if not self._done:
            self._done = True
            self.dismissed.emit()

    def go_away(self) -> None:
        """Vanish; the keyboard goes back to the control, unless it is somewhere else by now."""
        if self.window().focusWidget() is self:
            self.parentWidget().setFocus(Qt.FocusReason.OtherFocusReason)
        self.hide()
        self.deleteLater()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter reports and Esc leaves; everything else is typing."""
        if event.key() == Qt.Key.Key_Escape:
            self.dismiss()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            # A line edit passes Enter on, and the bar under it would open another one.
            self.finish()
            event.accept()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Leaving the line keeps a valid value, as in every other editor."""
        super().focusOutEvent(event)
        if event.reason() == Qt.FocusReason.PopupFocusReason:
            return
        self.finish()
        self.dismiss()

    def _forgive(self) -> None:
        self._mark_wrong(False)

    def _mark_wrong(self, wrong: bool) -> None:
        self.setProperty("wrong", wrong)
        self.style().unpolish(self)
        self.style().polish(self)
