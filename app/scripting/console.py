"""Run Python of the user's own against the open document: each run is one step, or none if it raises."""

from __future__ import annotations

import io
import sys
import traceback
from code import InteractiveInterpreter
from contextlib import redirect_stdout
from dataclasses import dataclass
from types import CodeType

from app.document import Document
from app.scripting.desk import ScriptDesk
from app.scripting.names import Names
from app.view import View
from facemodel.errors import RisoriusError

SCRIPT = "<script>"


@dataclass(frozen=True)
class Outcome:
    """What became of a run.

    Attributes
    ----------
    output : what it printed
    error : one sentence if it was stopped, with the line; the document is then as it was before
    details : the traceback through the script's own lines
    complete : false if the input is the beginning of something that goes on in the next line
    """

    output: str = ""
    error: str = ""
    details: str = ""
    complete: bool = True


class Console:
    """A console over a document; its variables last from one input to the next.

    Everything an input does to the document becomes one step when it has run to its end.

    Parameters
    ----------
    document : what is worked on
    view : what is shown of it, if there is a window
    """

    def __init__(self, document: Document, view: View | None = None) -> None:
        self._desk = ScriptDesk(document, view)
        self._interpreter = _Interpreter(Names(self._desk).namespace())

    @property
    def names(self) -> tuple[str, ...]:
        """Everything that can be named now, for completion."""
        return tuple(sorted(name for name in self._interpreter.locals if not name.startswith("__")))

    def enter(self, text: str) -> Outcome:
        """Run a line, or several that belong together; the value of an expression is printed."""
        return self._run(text, "single", "Console")

    def run(self, text: str, label: str = "Script") -> Outcome:
        """Run a whole script as one step called ``label``."""
        return self._run(text if text.endswith("\n") else text + "\n", "exec", label)

    def _run(self, text: str, symbol: str, label: str) -> Outcome:
        self._desk.begin()
        printed = io.StringIO()
        with redirect_stdout(printed):
            goes_on = self._interpreter.begin(text, symbol)
        error, details = self._interpreter.told
        if goes_on or error:
            return Outcome(printed.getvalue(), error, details, not goes_on)
        try:
            self._desk.keep(label)
        except RisoriusError as refused:
            return Outcome(printed.getvalue(), str(refused))
        return Outcome(printed.getvalue())


def run_script(text: str, document: Document, label: str = "Script", view: View | None = None) -> Outcome:
    """Run a script against a document: as one step, or not at all if it raises."""
    return Console(document, view).run(text, label)


class _Interpreter(InteractiveInterpreter):
    """The standard library's interpreter, which tells errors in a sentence instead of printing them."""

    def __init__(self, names: dict[str, object]) -> None:
        super().__init__(names)
        self.told = ("", "")

    def begin(self, text: str, symbol: str) -> bool:
        """Run a text; whether it goes on in the next line."""
        self.told = ("", "")
        return self.runsource(text, SCRIPT, symbol)

    def runcode(self, code: CodeType) -> None:
        """Run compiled input; asking to leave ends the input and not the program."""
        try:
            super().runcode(code)
        except SystemExit:
            self.told = ("The script asked to end before it was done; nothing was changed.", "")

    def showsyntaxerror(self, filename: str | None = None, **_: object) -> None:
        """Tell what cannot be read as Python."""
        error = sys.exc_info()[1]
        line = getattr(error, "lineno", None)
        self.told = (f"Line {line} of the script is no Python: {getattr(error, 'msg', error)}.", "")

    def showtraceback(self) -> None:
        """Tell what was raised, and in which line of the script."""
        error = sys.exc_info()[1]
        assert error is not None
        frames = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename == SCRIPT]
        where = f"line {frames[-1].lineno}" if frames else "its start"
        what = str(error) if isinstance(error, RisoriusError) else f"{type(error).__name__}: {error}"
        ending = "" if what.endswith((".", "!", "?")) else "."
        self.told = (f"The script stopped at {where}: {what}{ending}", "".join(traceback.format_list(frames)))
