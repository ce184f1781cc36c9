"""Start the editor: what comes before the window, in the order that brings the face to the screen soonest."""

from __future__ import annotations

import signal
import sys
from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QApplication

from app.document import Document
from app.preferences import Preferences
from app.settings import UserSettings
from facemodel.errors import RisoriusError
from facemodel.io.project_file import load_project
from facemodel.project import Project
from facemodel.projects import new_project
from ui.theme.apply import apply_theme
from ui.theme.roles import THEMES
from ui.viewport.look import look_of
from ui.window.preparation import Preparation
from ui.window.unforeseen import Unforeseen


def run(path: Path | None = None, project: Project | None = None) -> int:
    """Open the editor and stay until it is closed.

    Parameters
    ----------
    path : the file to open
    project : what to open and play that has no file, if there is no path; the default face without either

    Returns
    -------
    status : what the process should end with
    """
    app = make_application()
    end_by_ctrl_c()
    settings = UserSettings()
    follow_theme(app, settings)
    document, complaint = first_document(path, project)
    preparation = Preparation()
    preparation.begin(lambda: look_of(document.project.face))
    # VTK takes a second to load; the face is made ready meanwhile.
    from ui.window.editor import make_window
    from ui.window.safekeeping import Safekeeping

    window = make_window(document, settings, preparation)
    Unforeseen(window).install()
    safekeeping = Safekeeping(window)
    window.show()
    for sentence in filter(None, (complaint, settings.notice)):
        window.context.host.show_error(sentence)
    safekeeping.offer_soon()
    if project is not None and document.project is project:
        window.context.host.perform()
    return app.exec()


def end_by_ctrl_c() -> None:
    """Let Ctrl+C in the terminal end the program at once; Qt's loop would not let Python hear of it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def make_application() -> QApplication:
    """The one application object of the process."""
    existing = QApplication.instance()
    if isinstance(existing, QApplication):
        return existing
    QCoreApplication.setApplicationName("risorius")
    QCoreApplication.setOrganizationName("risorius")
    app = QApplication(sys.argv[:1])
    app.setApplicationDisplayName("Risorius")
    return app


def follow_theme(app: QApplication, settings: UserSettings) -> None:
    """Dress the application as its user likes it, now and whenever that changes."""

    def dress(now: Preferences, before: Preferences | None = None) -> None:
        if before is None or now.theme != before.theme:
            apply_theme(app, THEMES[now.theme])

    dress(settings.preferences)
    settings.changed.connect(dress)


def first_document(path: Path | None, project: Project | None = None) -> tuple[Document, str]:
    """The document to start with, and a sentence for the user if ``path`` cannot be opened (else empty)."""
    if path is None:
        return Document(project or new_project()), ""
    try:
        return Document(load_project(path), path), ""
    except RisoriusError as error:
        return Document(new_project()), str(error)
