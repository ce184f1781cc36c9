"""The right button, or undo, in the middle of a gesture on the face: it is taken back, and the camera stays."""

from dataclasses import dataclass

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from facemodel.laying.collection import muscle_of
from facemodel.project import Project
from tests.ui.hands import move
from tests.ui.skull.conftest import handle
from tests.ui.window.seen import next_frame, pixel, points
from tests.ui.workspaces.conftest import at
from tests.ui.workspaces.test_switching import camera
from ui.window.main_window import MainWindow

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
MUSCLE = "zygomaticus_major_L"
WAY = QPoint(26, -16)


def attachment(window: MainWindow) -> QPoint:
    return pixel(window, muscle_of(window.context.document.project, MUSCLE).fibres[0].attachment)


def corner_of_mouth(window: MainWindow) -> QPoint:
    return at(window, 0.575, 0.585)


@dataclass
class Held:
    """A gesture under way, and what was there before it."""

    window: MainWindow
    place: QPoint
    project: Project
    face: np.ndarray
    seen_from: tuple[object, ...]

    @property
    def canvas(self) -> QWidget:
        return self.window.viewport.canvas

    def go_on(self) -> None:
        """Drag on with the left button."""
        for step in range(1, 9):
            move(self.canvas, self.place + WAY * step / 8)
        self.place += WAY
        self.window.hands.flush()
        QApplication.processEvents()

    @property
    def left_no_trace(self) -> bool:
        document = self.window.context.document
        same_project = document.project is self.project and document.history.done == () and not document.held
        return same_project and camera(self.window) == self.seen_from and np.array_equal(points(self.window), self.face)


@pytest.fixture(
    params=[
        ("tissue", "brush", "front", corner_of_mouth),
        ("actions", "sculpt", "front", corner_of_mouth),
        ("muscles", "fibre", "front", attachment),
        ("expression", "pull", "front", corner_of_mouth),
        ("skull", "move-skull", "left", lambda window: handle(window, 1)),
    ],
    ids=lambda each: each[1],
)
def held(window: MainWindow, request: pytest.FixtureRequest) -> Held:
    """A gesture under way with one of the tools."""
    workspace, tool, side, start = request.param
    window.context.view.look_from(side)
    window.context.view.change(workspace=workspace, unit=12, muscle=MUSCLE)
    window.toolbox.take(tool)
    next_frame(window)
    held = Held(window, start(window), window.context.document.project, points(window), camera(window))
    QTest.mousePress(held.canvas, LEFT, pos=held.place)
    held.go_on()
    assert window.toolbox.busy
    return held


def the_rest_of_the_drag_does_nothing(held: Held) -> bool:
    held.go_on()
    QTest.mouseRelease(held.canvas, LEFT, pos=held.place)
    return held.left_no_trace


def test_the_right_button_takes_the_gesture_back_and_turns_nothing(held):
    QTest.mousePress(held.canvas, RIGHT, pos=held.place)
    assert not held.window.toolbox.busy
    held.go_on()
    QTest.mouseRelease(held.canvas, RIGHT, pos=held.place)
    assert held.left_no_trace
    assert the_rest_of_the_drag_does_nothing(held)
    QTest.mousePress(held.canvas, RIGHT, pos=held.place)
    QTest.mouseMove(held.canvas, held.place - WAY)
    QTest.mouseRelease(held.canvas, RIGHT, pos=held.place - WAY)
    assert camera(held.window) != held.seen_from


@pytest.mark.parametrize("modifiers", [CTRL, CTRL | SHIFT], ids=["undo", "redo"])
def test_undo_and_redo_take_the_gesture_back_and_no_step(held, modifiers):
    QTest.keyClick(held.canvas, Qt.Key.Key_Z, modifiers)
    assert not held.window.toolbox.busy
    assert held.left_no_trace
    assert the_rest_of_the_drag_does_nothing(held)


def test_escape_leaves_no_trace_and_the_rest_of_the_drag_does_nothing(held):
    QTest.keyClick(held.canvas, Qt.Key.Key_Escape)
    assert not held.window.toolbox.busy
    assert held.left_no_trace
    assert the_rest_of_the_drag_does_nothing(held)


def test_a_window_that_is_closed_in_the_middle_of_a_gesture_closes_without_it_and_asks_nothing(held):
    document = held.window.context.document
    assert held.window.close()
    assert document.project is held.project
    assert document.history.done == ()
    assert not document.held
    move(held.canvas, held.place + WAY)
    QTest.mouseRelease(held.canvas, LEFT, pos=held.place + WAY)
    QTest.qWait(50)
