"""Python of the user's own on the open document: a line to type in, and what came of it above."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QTextCharFormat, QTextCursor
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPlainTextEdit, QVBoxLayout, QWidget

from app.document import Document
from app.scripting import Console, Outcome
from app.view import View
from ui.theme.apply import current_theme
from ui.theme.metrics import GRID, TYPE
from ui.widgets.history_line import HistoryLine

PROMPT, GOES_ON = ">>>", "..."

MOST_LINES = 2000
MOST_CHARACTERS = 20_000
"""Of one entry; the view takes seconds to lay out what nobody will read."""

EXAMPLES = ("au(12).weight = 0.5", "emotion('happiness')", "units()", "muscles()", "expression()")

WELCOME = "\n".join(("Python runs here on the open project; each entry is one step that can be undone.", "", *EXAMPLES))


class ConsolePanel(QWidget):
    """A console on a document; the variables of one entry are there for the next.

    Parameters
    ----------
    document : what is worked on
    view : what is shown of it
    """

    def __init__(self, document: Document, view: View) -> None:
        super().__init__()
        self._console = Console(document, view)
        self._block: list[str] = []
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.output = QPlainTextEdit()
        self.output.setReadOnly(True)
        self.output.setMaximumBlockCount(MOST_LINES)
        self.output.setPlaceholderText(WELCOME)
        self.output.setAccessibleName("Output of the console")
        self.output.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.prompt = QLabel(PROMPT)
        self.prompt.setProperty("role", "muted")
        self.line = HistoryLine()
        self.line.setAccessibleName("Python to run on the project")
        self.line.entered.connect(self._enter)
        self.line.dismissed.connect(self._drop_block)
        self.setFocusProxy(self.line)
        for widget in (self.output, self.prompt, self.line):
            widget.setFont(fixed_font())
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, GRID)
        layout.setSpacing(GRID // 2)
        layout.addWidget(self.output, 1)
        layout.addLayout(self._entry())

    def _entry(self) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setSpacing(GRID)
        line.addWidget(self.prompt)
        line.addWidget(self.line, 1)
        return line

    def _enter(self, text: str) -> None:
        """Run what was typed, or wait for the rest of a block, which an empty line ends."""
        if not text.strip() and not self._block:
            return
        for number, line in enumerate(text.split("\n")):
            self._write(f"{GOES_ON if self._block or number else PROMPT} {line}\n", current_theme().muted)
        self._block.append(text)
        whole = "\n".join(self._block)
        # Several lines can only have been pasted: they are a script, and need no empty line at the end.
        outcome = self._console.run(whole, "Console") if "\n" in text else self._console.enter(whole)
        if outcome.complete:
            self._block.clear()
        self.prompt.setText(PROMPT if outcome.complete else GOES_ON)
        self._tell(outcome)

    def _drop_block(self) -> None:
        self._block.clear()
        self.prompt.setText(PROMPT)

    def _tell(self, outcome: Outcome) -> None:
        shown, more = outcome.output[:MOST_CHARACTERS], len(outcome.output) - MOST_CHARACTERS
        self._write(shown, current_theme().text)
        if more > 0:
            self._write(f"\n… and {more} characters more\n", current_theme().muted)
        if outcome.error:
            self._write(f"{outcome.error}\n", current_theme().error)

    def _write(self, text: str, colour: str) -> None:
        form = QTextCharFormat()
        form.setForeground(QColor(colour))
        cursor = QTextCursor(self.output.document())
        cursor.movePosition(QTextCursor.MoveOperation.End)
        cursor.insertText(text, form)
        bar = self.output.verticalScrollBar()
        bar.setValue(bar.maximum())


def fixed_font() -> QFont:
    """The system's typeface in which all letters are equally wide, in the size of all others."""
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    font.setPixelSize(TYPE)
    return font
