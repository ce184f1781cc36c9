"""Errors that nobody foresaw: written to the log, shown once, and the document stays."""

from __future__ import annotations

import logging
import sys
import traceback
from types import TracebackType

from PySide6.QtWidgets import QWidget

from ui.window.dialogs import show_error

SENTENCE = (
    "Something went wrong that was not foreseen; your face is still there, but save it under a new name to be safe, "
    "and please report the details."
)

log = logging.getLogger(__name__)


class Unforeseen:
    """Takes the place of Python's own hook for exceptions that nobody caught, as long as a window is open.

    Parameters
    ----------
    window : the dialog belongs to it
    """

    def __init__(self, window: QWidget) -> None:
        self._window = window
        self._showing = False

    def install(self) -> None:
        """Be told from now on."""
        sys.excepthook = self.tell

    def tell(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        """Log the error and show it; while one is shown, others only go to the log."""
        log.error("Unforeseen error", exc_info=(kind, error, trace))
        if self._showing:
            return
        self._showing = True
        try:
            show_error(self._window, SENTENCE, "".join(traceback.format_exception(kind, error, trace)))
        finally:
            self._showing = False
