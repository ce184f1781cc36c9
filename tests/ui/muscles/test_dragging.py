"""An attachment dragged over the face: the muscle follows the hand, and its field is solved when it lets go."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.solving import EditingSolve
from facemodel.laying.collection import muscle_of
from facemodel.sameness import same
from tests.ui.hands import move
from tests.ui.window.conftest import document, open_window, project, settings, solution  # noqa: F401
from tests.ui.window.seen import differs, next_frame, picture, pixel
from ui.window.main_window import MainWindow

MUSCLE = "zygomaticus_major_L"
WAY = QPoint(26, -16)


@pytest.fixture
def editor(open_window, document, qtbot) -> MainWindow:  # noqa: F811
    """Open the muscles workspace, a muscle selected and the fibre tool in hand."""
    window = open_window(document, EditingSolve())
    window.context.view.look_from("front")
    window.context.view.change(workspace="muscles")
    window.context.view.change(muscle=MUSCLE)
    window.toolbox.take("fibre")
    next_frame(window)
    return window


def attachment(document) -> np.ndarray:  # noqa: F811
    return muscle_of(document.project, MUSCLE).fibres[0].attachment


def peak_place(document) -> np.ndarray:  # noqa: F811
    """Where the skin moves most."""
    basis = document.solution.basis
    way = np.linalg.norm(basis.moving_field("12L"), axis=1)
    return basis.display.points[way.argmax()].astype(np.float64)


def hold(editor: MainWindow, start: QPoint) -> None:
    """Press on a place and drag, without letting go."""
    canvas = editor.viewport.canvas
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    for step in range(1, 9):
        move(canvas, start + WAY * step / 8)
    editor.hands.flush()
    QApplication.processEvents()


def test_a_dragged_attachment_takes_the_field_along_in_one_step(editor, document, qtbot):  # noqa: F811
    before, solved = document.project, document.solution
    start, peak = attachment(document), peak_place(document)
    calm = picture(editor)
    hold(editor, pixel(editor, start))
    assert editor.toolbox.busy
    assert document.project is before
    assert differs(picture(editor), calm)
    QTest.mouseRelease(editor.viewport.canvas, Qt.MouseButton.LeftButton, pos=pixel(editor, start) + WAY)
    assert document.history.to_undo.label == "Move attachment of Zygomaticus major"
    gone = attachment(document) - start
    assert gone[0] > 5
    assert gone[1] > 2
    qtbot.waitUntil(lambda: document.solution is not solved and not document.stale)
    # One of two fibres went, and the mouth's corner gives way most, so the peak goes some of the way.
    assert (peak_place(document) - peak) @ gone / np.linalg.norm(gone) > 1.0
    QTest.keyClick(editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert same(document.project.muscles, before.muscles)


def test_esc_in_a_drag_leaves_the_muscle_and_no_trace(editor, document):  # noqa: F811
    before = document.project
    calm = picture(editor)
    hold(editor, pixel(editor, attachment(document)))
    QTest.keyClick(editor.viewport.canvas, Qt.Key.Key_Escape)
    assert not editor.toolbox.busy
    assert document.project is before
    assert document.history.to_undo is None
    QTest.mouseRelease(editor.viewport.canvas, Qt.MouseButton.LeftButton)
    editor.toolbox.leave()
    assert not differs(picture(editor), calm)
