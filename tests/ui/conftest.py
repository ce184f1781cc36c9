"""A theme on the application, and a small document to show."""

import os
import sys
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.document import Document
from app.view import View
from facemodel.project import Project
from tests.app.conftest import small_project
from tests.ui.hands import let_go
from ui.portraits import Portraits
from ui.theme.apply import apply_theme
from ui.theme.roles import DARK
from ui.window.held_hand import HeldHand

NO_DISPLAY = sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))

PATIENCE = 60_000
"""Milliseconds after which something does not happen any more, on a machine that is slow and busy with other things."""


@pytest.fixture(autouse=True)
def _held_hand(request: pytest.FixtureRequest) -> Iterator[None]:
    """Have drags taken back in a test without the main window too."""
    if "qapp" not in request.fixturenames:
        yield
        return
    hand = HeldHand(request.getfixturevalue("qapp"), {})
    yield
    hand.close()


@pytest.fixture(autouse=True, scope="session")
def _display() -> None:
    if NO_DISPLAY:
        pytest.skip("There is no display; run these tests by .ci/with-display.")


@pytest.fixture(autouse=True)
def _no_button_held(request: pytest.FixtureRequest) -> Iterator[None]:
    """Let go of the mouse after every test: undo asks whether a hand is in the middle of a drag."""
    yield
    if "qapp" in request.fixturenames and QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton:
        let_go(QWidget())


@pytest.fixture(scope="session")
def qapp(_display: None) -> QApplication:
    app = QApplication.instance() or QApplication([])
    apply_theme(app, DARK)
    return app


class PatientBot(QtBot):
    """Waits longer than pytest-qt does."""

    def waitUntil(self, callback: Callable[[], bool | None], *, timeout: int = PATIENCE) -> None:  # noqa: N802 - Qt's name
        super().waitUntil(callback, timeout=timeout)

    def waitSignal(self, signal: object, *, timeout: int = PATIENCE, **how: Any) -> Any:  # noqa: N802 - Qt's name
        return super().waitSignal(signal, timeout=timeout, **how)


@pytest.fixture
def qtbot(qapp: QApplication, request: pytest.FixtureRequest) -> QtBot:
    return PatientBot(request)


@pytest.fixture(scope="session")
def patch() -> Project:
    """A small square of skin that is solved in an instant."""
    return small_project()


@pytest.fixture
def document(patch: Project) -> Document:
    return Document(patch)


@pytest.fixture
def portraits(document: Document, qapp: QApplication) -> Iterator[Portraits]:
    portraits = Portraits(document)
    yield portraits
    portraits.close()


@pytest.fixture
def view() -> View:
    return View()


@pytest.fixture
def shown(qtbot, qapp: QApplication) -> Callable[[QWidget], QWidget]:
    """Show a widget and keep it until the test is over."""
    kept: list[QWidget] = []

    def show(widget: QWidget) -> QWidget:
        qtbot.addWidget(widget)
        kept.append(widget)
        widget.show()
        widget.activateWindow()
        qtbot.waitUntil(widget.isActiveWindow)
        return widget

    return show
