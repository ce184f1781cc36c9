"""A theme on the application, and a small document to show."""

import os
import sys
from collections.abc import Callable, Iterator

import pytest
from PySide6.QtWidgets import QApplication, QWidget

from app.document import Document
from app.view import View
from facemodel.project import Project
from tests.app.conftest import small_project
from ui.portraits import Portraits
from ui.theme.apply import apply_theme
from ui.theme.roles import DARK

NO_DISPLAY = sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


@pytest.fixture(autouse=True, scope="session")
def _display() -> None:
    if NO_DISPLAY:
        pytest.skip("There is no display; run these tests by .ci/with-display.")


@pytest.fixture(scope="session")
def qapp(_display: None) -> QApplication:
    app = QApplication.instance() or QApplication([])
    apply_theme(app, DARK)
    return app


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
        qtbot.waitExposed(widget)
        widget.activateWindow()
        qtbot.waitUntil(widget.isActiveWindow)
        return widget

    return show
