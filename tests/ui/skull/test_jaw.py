"""The jaw is chosen on the bone by brush, lasso and part, its axis is placed by its ends, and its turn is tried."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from facemodel.jaw.motion import jaw_motion
from facemodel.sameness import same
from facemodel.skull.jaw_region import whole_skull
from tests.ui.hands import drag as drag_bar
from tests.ui.hands import move
from tests.ui.skull.conftest import click, drag, hold, tick
from tests.ui.window.seen import differs, next_frame, picture, pixel

CONTROL = Qt.KeyboardModifier.ControlModifier


def selected(editor) -> np.ndarray:
    """Return which vertices of the whole skull are selected."""
    skull = editor.context.document.project.face.skull
    found = editor.toolbox.bench.bones.selected(skull)
    return np.zeros(len(whole_skull(skull).mesh.positions), dtype=bool) if found is None else found


def chin(editor) -> np.ndarray:
    """Return the place of the bone under the chin that is nearest to the eye."""
    bone = whole_skull(editor.context.document.project.face.skull).mesh.positions
    low = bone[:, 1] < bone[:, 1].min() + 12
    return bone[low][bone[low, 0].argmax()]


def around(editor, low: float, high: float) -> list[QPoint]:
    """Return corners of a lasso about the head between two heights, millimetres."""
    corners = [(low, -140.0), (low, 90.0), (high, 90.0), (high, -140.0)]
    return [pixel(editor, np.array([0.0, y, z])) for y, z in corners]


def lasso(editor, corners: list[QPoint], keys=Qt.KeyboardModifier.NoModifier) -> None:
    canvas = editor.viewport.canvas
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, keys, corners[0])
    for corner in corners[1:]:
        move(canvas, corner, keys)
    editor.hands.flush()
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, keys, corners[-1])


def test_a_brush_selects_bone_within_its_ball_and_ctrl_takes_it_out(skull, document):
    panel, before = skull.panels.panel("skull"), document.project
    click(panel.jaw.tools.button("bone-brush"))
    place = chin(skull)
    drag(skull, pixel(skull, place), QPoint(0, 0))
    region, bone = selected(skull), whole_skull(document.project.face.skull).mesh.positions
    away = np.linalg.norm(bone - place, axis=1)
    assert region[away < 5].all()
    assert not region[away > 13].any()
    assert "vertices selected" in panel.jaw.words.text()
    skull.toolbox.bench.brush.change(mirror=True)
    drag(skull, pixel(skull, place), QPoint(0, 0))
    assert selected(skull)[bone[:, 0] < -10].any()
    drag(skull, pixel(skull, place), QPoint(0, 0), CONTROL)
    assert not selected(skull).any()
    assert document.project is before


def test_esc_in_a_stroke_brings_back_what_was_selected(skull):
    skull.toolbox.take("bone-brush")
    drag(skull, pixel(skull, chin(skull)), QPoint(0, 0))
    before = selected(skull)
    calm = picture(skull)
    hold(skull, pixel(skull, chin(skull)), QPoint(20, -30))
    assert selected(skull).sum() > before.sum()
    assert differs(picture(skull), calm)
    QTest.keyClick(skull.viewport.canvas, Qt.Key.Key_Escape)
    QTest.mouseRelease(skull.viewport.canvas, Qt.MouseButton.LeftButton)
    assert np.array_equal(selected(skull), before)


def test_a_lasso_takes_the_bone_inside_of_it_through_and_through_or_only_what_is_seen(skull, document):
    skull.toolbox.take("bone-lasso")
    bone = whole_skull(document.project.face.skull).mesh.positions
    low = bone[:, 1].min()
    lasso(skull, around(skull, low - 8, low + 15))
    through = selected(skull)
    assert through[bone[:, 1] < low + 8].all()
    assert not through[bone[:, 1] > low + 25].any()
    tick(skull.panels.panel("skull").jaw.through)
    lasso(skull, around(skull, low - 8, low + 15))
    seen = selected(skull)
    assert 0 < seen.sum() < through.sum()
    assert not (seen & ~through).any()
    lasso(skull, around(skull, low - 8, low + 15), CONTROL)
    assert not selected(skull).any()


def test_a_click_takes_a_connected_part_and_buttons_reshape_it(skull, document):
    panel = skull.panels.panel("skull")
    click(panel.jaw.tools.button("bone-part"))
    click_at(skull, chin(skull))
    whole = whole_skull(document.project.face.skull)
    part = selected(skull)
    assert part.any()
    assert not (part & ~whole.jaw).any()
    click(panel.jaw.buttons.by_name["Shrink"])
    assert not (selected(skull) & ~part).any()
    click(panel.jaw.buttons.by_name["Invert"])
    assert selected(skull).sum() > len(part) / 2
    click(panel.jaw.buttons.by_name["None"])
    assert not selected(skull).any()
    click(panel.jaw.buttons.by_name["Propose"])
    assert np.array_equal(selected(skull), whole.jaw)
    assert not panel.jaw.make.isEnabled()


def click_at(editor, place: np.ndarray) -> None:
    QTest.mouseClick(editor.viewport.canvas, Qt.MouseButton.LeftButton, pos=pixel(editor, place))


def test_what_is_selected_becomes_the_jaw_in_one_step(skull, document):
    before = document.project
    skull.toolbox.take("bone-lasso")
    low = whole_skull(before.face.skull).mesh.positions[:, 1].min()
    lasso(skull, around(skull, low - 8, low + 20))
    click(skull.panels.panel("skull").jaw.make)
    after = document.project.face.skull
    assert document.history.done == ("Choose the jaw",)
    assert 0 < len(after.mandible.triangles) < len(before.face.skull.mandible.triangles)
    assert len(after.mandible.triangles) + len(after.cranium.triangles) == 14960
    document.undo()
    assert same(document.project.face, before.face)


def test_an_end_of_the_axis_is_dragged_and_its_other_end_goes_alike_with_the_mirror(skull, document):
    before = document.project.face.skull.jaw.axis
    QTest.keyClick(skull.viewport.canvas, Qt.Key.Key_J)
    drag(skull, pixel(skull, before[1]), QPoint(0, -30))
    one = document.project.face.skull.jaw.axis
    assert one[1, 1] > before[1, 1] + 3
    assert np.array_equal(one[0], before[0])
    panel = skull.panels.panel("skull")
    assert "tilted" in panel.axis.words.text()
    assert not panel.axis.words.text().endswith("tilted 0.0°, turned 0.0°.")
    document.undo()
    QTest.keyClick(skull.viewport.canvas, Qt.Key.Key_X)
    drag(skull, pixel(skull, before[1]), QPoint(0, -30))
    both = document.project.face.skull.jaw.axis
    assert both[0, 1] - before[0, 1] == pytest.approx(both[1, 1] - before[1, 1], abs=1e-6)
    assert document.history.done == ("Place the jaw’s axis",)
    document.undo()
    assert np.array_equal(document.project.face.skull.jaw.axis, before)


def test_an_axis_on_which_no_jaw_turns_is_refused_and_said(skull, document):
    skull.context.view.look_from("front")
    next_frame(skull)
    QTest.keyClick(skull.viewport.canvas, Qt.Key.Key_J)
    right, left = document.project.face.skull.jaw.axis
    start = pixel(skull, left)
    drag(skull, start, pixel(skull, right) - start)
    assert document.history.done == ()
    assert "at least 20 mm apart" in skull.status.hint.text()


def test_a_turn_is_tried_without_a_change_and_gone_when_the_workspace_is_left(skull, document):
    before, panel = document.project, skull.panels.panel("skull")
    calm = picture(skull)
    drag_bar(panel.axis.open, 0.0, 0.8)
    state = skull.context.view.state
    assert 20 < state.jaw_open < 30
    drawn = skull.viewport.scene.drawn
    wanted = jaw_motion(before.face.skull.jaw, state.jaw_open, 0.0)
    assert np.allclose(skull.viewport.scene.skull.jaw(drawn), wanted)
    assert differs(picture(skull), calm)
    skin = skull.viewport.scene.figure.posed
    assert np.abs(skin.points - skin.basis.display.points).max() > 10
    assert document.project is before
    assert not document.dirty
    skull.context.view.change(workspace="expression")
    assert skull.context.view.state.jaw_open == 0.0
    next_frame(skull)
    assert np.abs(skin.points - skin.basis.display.points).max() < 1e-6
