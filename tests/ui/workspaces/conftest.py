"""The editor on the default face, opened in the tissue workspace."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from tests.ui.window.conftest import document, open_window, project, settings, solution  # noqa: F401
from tests.ui.window.conftest import window as window
from tests.ui.window.seen import next_frame
from ui.window.main_window import MainWindow

Place = Callable[[float, float], QPoint]


@pytest.fixture
def tissue(window: MainWindow) -> MainWindow:
    """Open the tissue workspace, the face seen from the front, one side painted at a time."""
    window.context.view.look_from("front")
    window.context.view.change(workspace="tissue")
    window.toolbox.bench.brush.change(mirror=False, radius=9.0, strength=1.0)
    window.toolbox.bench.brush.set_value(0.03)
    next_frame(window)
    return window


def at(editor: MainWindow, across: float, down: float) -> QPoint:
    """Return a place on the canvas, as shares of its width and height."""
    canvas = editor.viewport.canvas
    return QPoint(round(canvas.width() * across), round(canvas.height() * down))


def stroke(editor: MainWindow, places: list[QPoint], release: bool = True) -> None:
    """Drag the left button over the canvas."""
    canvas = editor.viewport.canvas
    left = Qt.MouseButton.LeftButton
    QTest.mousePress(canvas, left, pos=places[0])
    for place in places[1:]:
        where = QPointF(place)
        over = QPointF(canvas.mapToGlobal(place))
        none, keys = Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier
        QApplication.sendEvent(canvas, QMouseEvent(QEvent.Type.MouseMove, where, over, none, left, keys))
    if release:
        QTest.mouseRelease(canvas, left, pos=places[-1])
    else:
        editor.hands.flush()
    QApplication.processEvents()
