"""The editor on a shipped face, solved once for all tests."""

import gc
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QTimer
from PySide6.QtWidgets import QApplication, QMessageBox

from app.document import Document
from app.jobs import Solve
from app.settings import UserSettings
from facemodel.cache import solve_cached
from facemodel.project import Project, Settings
from facemodel.projects import new_project
from facemodel.solve import Progress, Solution
from ui.portraits import portraits
from ui.theme.apply import apply_theme
from ui.theme.roles import DARK
from ui.window.editor import make_window
from ui.window.main import follow_theme
from ui.window.main_window import MainWindow
from ui.window.preparation import Preparation

FOR_EVER = 3_600_000
"""Milliseconds."""


@cache
def coarse() -> tuple[Project, Solution]:
    """Return the default face, sampled coarsely so that frames are quick; several folders have it as fixtures."""
    project = replace(new_project(), settings=Settings(element="hct9", density=1))
    return project, solve_cached(project)


@pytest.fixture(scope="session")
def project() -> Project:
    return coarse()[0]


@pytest.fixture(scope="session")
def solution() -> Solution:
    return coarse()[1]


@pytest.fixture
def document(project: Project) -> Document:
    return Document(project)


@pytest.fixture
def settings(tmp_path: Path, qapp: QApplication) -> Iterator[UserSettings]:
    """Preferences of a test; the quality of drawing is none that depends on how busy this machine is."""
    settings = UserSettings(tmp_path / "preferences.json")
    settings.change(quality="fast")
    follow_theme(qapp, settings)
    yield settings
    apply_theme(qapp, DARK)


@pytest.fixture
def open_window(
    qtbot, settings: UserSettings, solution: Solution, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Callable[..., MainWindow]]:
    """Open a window on a document; at the end it is closed without a question.

    Portraits, which are taken in idle moments and then take as long as the rest of most tests, wait for the one test
    that is about them.
    """
    monkeypatch.setattr(portraits, "REST", FOR_EVER)
    opened: list[MainWindow] = []

    def known(_project: Project, progress: Progress) -> Solution:
        progress("Read from the cache", 1.0)
        return solution

    def open_(document: Document, solve: Solve = known, wait: bool = True) -> MainWindow:
        window = make_window(document, settings, Preparation(), solve)
        opened.append(window)
        if not settings.preferences.geometry:
            window.resize(window.minimumSize())
        window.show()
        window.activateWindow()
        qtbot.waitUntil(window.isActiveWindow)
        if wait:
            qtbot.waitUntil(lambda: document.solution is not None)
            qtbot.waitUntil(lambda: window.viewport.shows_face)
        return window

    yield open_
    for window in opened:
        window.context.document._saved = window.context.document.project
        window.close()
    forget(*opened)


def forget(*windows: MainWindow) -> None:
    """Let closed windows go here and now: left to Python, what Qt and VTK made might go in any thread."""
    for window in windows:
        window.deleteLater()
    QApplication.processEvents()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    gc.collect()


@pytest.fixture
def window(open_window: Callable[..., MainWindow], document: Document) -> MainWindow:
    return open_window(document)


@pytest.fixture
def answer(qtbot) -> Iterator[Callable[..., list[str]]]:
    """Answer the questions that come, one button each; the list that is returned fills with what was said."""
    timers: list[QTimer] = []

    def expect(*buttons: QMessageBox.StandardButton) -> list[str]:
        said: list[str] = []
        left = list(buttons)

        def look() -> None:
            box = QApplication.activeModalWidget()
            if isinstance(box, QMessageBox) and left:
                said.append(box.text())
                box.button(left.pop(0)).click()

        timer = QTimer()
        timer.timeout.connect(look)
        timer.start(20)
        timers.append(timer)
        return said

    yield expect
    for timer in timers:
        timer.stop()


@pytest.fixture
def slow() -> Solve:
    """Solve for ever, but stop when asked to."""

    def solve(_project: Project, progress: Progress) -> Solution:
        for step in range(10_000):
            progress(f"Step {step}", min(0.9, step / 100))
            time.sleep(0.01)
        raise AssertionError("Nobody cancelled.")

    return solve
