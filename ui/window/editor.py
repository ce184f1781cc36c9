"""The one place where the parts of the editor are made and tied together."""

from __future__ import annotations

from app.document import Document
from app.jobs import Solve, SolveJob
from app.settings import UserSettings
from app.solving import EditingSolve, Solving
from app.view import View
from ui.window.delivery import UiThread
from ui.window.main_window import MainWindow
from ui.window.preparation import Preparation


def make_window(
    document: Document, settings: UserSettings, preparation: Preparation, solve: Solve | None = None
) -> MainWindow:
    """A window on a document, which ``solve``, or else a solver for editing, solves in the background from now on."""
    thread = UiThread()
    solving = Solving(document, SolveJob(solve or EditingSolve(), thread.deliver))
    window = MainWindow(document, View(), settings, solving, preparation)
    thread.setParent(window)
    preparation.setParent(window)
    solving.solve()
    return window
