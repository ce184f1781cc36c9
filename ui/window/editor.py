"""The one place where the parts of the editor are made and tied together."""

from __future__ import annotations

from app.document import Document
from app.jobs import Solve, SolveJob
from app.settings import UserSettings
from app.solving import Solving
from app.view import View
from facemodel.cache import solve_cached
from ui.window.delivery import UiThread
from ui.window.main_window import MainWindow
from ui.window.preparation import Preparation


def make_window(
    document: Document, settings: UserSettings, preparation: Preparation, solve: Solve = solve_cached
) -> MainWindow:
    """A window on a document, which ``solve`` solves in the background from now on."""
    thread = UiThread()
    solving = Solving(document, SolveJob(solve, thread.deliver))
    window = MainWindow(document, View(), settings, solving, preparation)
    thread.setParent(window)
    preparation.setParent(window)
    solving.solve()
    return window
