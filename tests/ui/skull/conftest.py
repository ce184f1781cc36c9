"""The editor on the default face, opened in the Skull workspace and seen from the subject's left."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.tools.gizmo import gizmo_of
from app.tools.place_skull import PlaceTool
from tests.ui.hands import move
from tests.ui.window.conftest import answer, document, open_window, project, settings, solution  # noqa: F401
from tests.ui.window.conftest import window as window
from tests.ui.window.seen import next_frame, pixel
from ui.window.main_window import MainWindow


@pytest.fixture
def skull(window: MainWindow, qtbot) -> MainWindow:
    """Open the Skull workspace, one side at a time."""
    window.context.view.look_from("left")
    window.context.view.change(workspace="skull")
    window.toolbox.bench.brush.change(mirror=False, radius=9.0)
    qtbot.waitUntil(lambda: window.toolbox.bench.watch.current)
    next_frame(window)
    return window


def handle(editor: MainWindow, axis: int) -> QPoint:
    """Return where a handle of the tool in hand is taken: an arm near its end, a ring where it is next to the eye."""
    tool = editor.toolbox.tool
    assert isinstance(tool, PlaceTool)
    sight = editor.hands.sight
    gizmo = gizmo_of(editor.context.document.project.face.skull, tool.mode, sight.millimetres)
    if tool.mode != "turn":
        return pixel(editor, gizmo.centre + 0.9 * gizmo.arm * gizmo.axes[axis])
    ring = gizmo.ring(axis)
    return pixel(editor, ring[((ring - gizmo.centre) @ sight.towards(gizmo.centre)).argmax()])


def hold(editor: MainWindow, start: QPoint, way: QPoint, keys=Qt.KeyboardModifier.NoModifier) -> None:
    """Press on a place of the canvas and drag, without letting go."""
    canvas = editor.viewport.canvas
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, keys, start)
    for step in range(1, 9):
        move(canvas, start + way * step / 8, keys)
    editor.hands.flush()
    QApplication.processEvents()


def drag(editor: MainWindow, start: QPoint, way: QPoint, keys=Qt.KeyboardModifier.NoModifier) -> None:
    """Press on a place of the canvas, drag and let go."""
    hold(editor, start, way, keys)
    QTest.mouseRelease(editor.viewport.canvas, Qt.MouseButton.LeftButton, keys, start + way)
    QApplication.processEvents()


def tick(box) -> None:
    """Click on the square of a box; its middle may lie beside its words."""
    QTest.mouseClick(box, Qt.MouseButton.LeftButton, pos=QPoint(8, box.height() // 2))
    QApplication.processEvents()


def click(widget) -> None:
    QTest.mouseClick(widget, Qt.MouseButton.LeftButton)
    QApplication.processEvents()
