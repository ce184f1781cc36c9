"""The skull is taken by its handles and by numbers: the bone follows the hand, and letting go is one step."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from app.solving import EditingSolve
from facemodel.face import AT_REST
from facemodel.sameness import same
from facemodel.skull.tissue_depths import landmark_depths
from tests.ui.hands import drag as drag_bar
from tests.ui.hands import move
from tests.ui.skull.conftest import click, drag, handle, hold, tick
from tests.ui.window.seen import differs, next_frame, picture
from ui.viewport.overlays.gizmo import AXES, HELD

UP, BACK = QPoint(0, -40), QPoint(30, 0)
"""Ways on the screen; seen from the subject's left, the face looks to the left."""


def drawn_bone(editor) -> np.ndarray:
    """Return the motion that the cranium is drawn with."""
    matrix = editor.viewport.scene.skull._bones[0].actor.GetUserMatrix()
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def test_an_arrow_moves_the_bone_along_its_axis_and_lets_go_in_one_step(skull, document):
    before = document.project
    hold(skull, handle(skull, 1), UP)
    assert document.project is before
    shown = drawn_bone(skull)
    assert shown[1, 3] > 5
    assert np.array_equal(shown[[0, 2], 3], [0, 0])
    panel = skull.panels.panel("skull")
    assert panel.place.rows["shift"].bars[1].value == pytest.approx(shown[1, 3])
    QTest.mouseRelease(skull.viewport.canvas, Qt.MouseButton.LeftButton, pos=handle(skull, 1) + UP)
    pose = document.project.face.skull.placement.pose
    assert pose.shift == pytest.approx((0, shown[1, 3], 0))
    assert document.history.done == ("Move skull",)
    assert np.array_equal(drawn_bone(skull), np.eye(4))
    QTest.keyClick(skull, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert same(document.project.face, before.face)
    assert same(document.project.muscles, before.muscles)


def test_esc_in_a_drag_puts_the_bone_back_without_a_trace(skull, document):
    before = document.project
    skull.toolbox.leave()
    calm = picture(skull)
    hold(skull, handle(skull, 1), UP)
    assert differs(picture(skull), calm)
    QTest.keyClick(skull.viewport.canvas, Qt.Key.Key_Escape)
    QTest.mouseRelease(skull.viewport.canvas, Qt.MouseButton.LeftButton)
    skull.toolbox.leave()
    assert document.project is before
    assert document.history.done == ()
    assert not differs(picture(skull), calm)


def test_rings_turn_the_bone_about_its_middle_and_boxes_scale_it(skull, document):
    QTest.keyClick(skull.viewport.canvas, Qt.Key.Key_R)
    assert skull.toolbox.tool.id == "turn-skull"
    drag(skull, handle(skull, 0), BACK)
    turned = document.project.face.skull.placement.pose
    assert abs(turned.turn[0]) > 3
    assert turned.turn[1:] == pytest.approx((0, 0), abs=1e-6)
    QTest.keyClick(skull.viewport.canvas, Qt.Key.Key_S, Qt.KeyboardModifier.ShiftModifier)
    drag(skull, handle(skull, 1), UP, Qt.KeyboardModifier.ControlModifier)
    scaled = document.project.face.skull.placement.pose
    assert scaled.scale[1] > 1.1
    assert 100 * scaled.scale[1] == pytest.approx(5 * round(20 * scaled.scale[1]))
    assert scaled.scale[::2] == (1.0, 1.0)
    assert document.history.done == ("Turn skull", "Scale skull")


def test_the_handle_under_the_pointer_is_brighter_and_the_held_one_golden(skull):
    gizmo = next(each for each in skull.panels._drawings["skull"] if type(each).__name__ == "SkullGizmo")
    colour = lambda: gizmo._heads[1].actor.GetProperty().GetColor()  # noqa: E731
    next_frame(skull)
    assert colour() == pytest.approx(AXES[1])
    move(skull.viewport.canvas, handle(skull, 1))
    skull.hands.flush()
    hold(skull, handle(skull, 1), QPoint(0, -6))
    next_frame(skull)
    assert colour() == pytest.approx(HELD)
    QTest.keyClick(skull.viewport.canvas, Qt.Key.Key_Escape)


def test_a_number_takes_a_sum_and_a_bar_carries_the_bone_along(skull, document):
    bar = skull.panels.panel("skull").place.rows["shift"].bars[2]
    QTest.mouseDClick(bar, Qt.MouseButton.LeftButton)
    editor = bar.findChild(QLineEdit)
    editor.selectAll()
    QTest.keyClicks(editor, "-2 - 1,5")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    assert document.project.face.skull.placement.pose.shift == (0.0, 0.0, -3.5)
    drag_bar(bar, 0.2, 0.8, release=False)
    assert drawn_bone(skull)[2, 3] != 0
    QTest.keyClick(bar, Qt.Key.Key_Escape)
    assert np.array_equal(drawn_bone(skull), np.eye(4))
    assert document.history.done == ("Move skull",)
    assert bar.value == -3.5


def test_muscles_follow_the_bone_unless_they_are_told_to_stay(skull, document):
    before = document.project.muscles
    place = skull.panels.panel("skull").place
    tick(place.follow)
    assert not skull.context.view.state.origins_follow
    drag(skull, handle(skull, 1), UP)
    assert document.project.muscles is before
    document.undo()
    tick(place.follow)
    drag(skull, handle(skull, 1), UP)
    moved = [one for one, other in zip(document.project.muscles, before, strict=True) if not same(one, other)]
    assert len(moved) > 20


def test_a_skull_is_snapped_back_to_the_depths_and_reset_to_where_it_was_made(skull, document, qtbot):
    place = skull.panels.panel("skull").place
    assert not place.buttons.by_name["Reset"].isEnabled()
    made = document.project
    drag(skull, handle(skull, 1), UP)
    off = max(abs(each.off) for each in landmark_depths(document.project.face))
    click(place.buttons.by_name["Snap to depths"])
    assert not place.buttons.by_name["Snap to depths"].isEnabled()
    qtbot.waitUntil(lambda: len(document.history.done) == 2)
    assert place.buttons.by_name["Snap to depths"].isEnabled()
    assert max(abs(each.off) for each in landmark_depths(document.project.face)) < min(5.0, off)
    click(place.buttons.by_name["Reset"])
    assert document.project.face.skull.placement.pose == AT_REST
    assert np.array_equal(document.project.face.skull.anchors, made.face.skull.anchors)
    assert document.history.done == ("Move skull", "Snap skull to tissue depths", "Reset skull")


def test_the_face_is_solved_in_the_background_when_the_hand_lets_go(open_window, document, qtbot):
    window = open_window(document, EditingSolve())
    window.context.view.look_from("left")
    window.context.view.change(workspace="skull")
    qtbot.waitUntil(lambda: not window.context.solving.job.running)
    next_frame(window)
    solved = document.solution
    drag(window, handle(window, 1), UP)
    assert document.stale
    qtbot.waitUntil(lambda: not document.stale)
    assert document.solution is not solved
    assert document.history.done == ("Move skull",)
