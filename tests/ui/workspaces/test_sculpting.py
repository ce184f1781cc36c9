"""Sculpting with the mouse on the real face, and what the Actions workspace lays on the skin."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from tests.ui.window.seen import differs, next_frame, picture, points
from tests.ui.workspaces.conftest import at, stroke
from ui.window.main_window import MainWindow


@pytest.fixture
def actions(window: MainWindow) -> MainWindow:
    """Open the Actions workspace with the lip corner puller in hand, the face seen from the front."""
    window.context.view.look_from("front")
    window.context.view.change(workspace="actions", unit=12)
    next_frame(window)
    return window


@pytest.fixture
def sculpting(actions: MainWindow) -> MainWindow:
    """Take the brush that pulls."""
    QTest.keyClick(actions.viewport.canvas, Qt.Key.Key_S)
    assert actions.toolbox.tool.id == "sculpt"
    next_frame(actions)
    return actions


def press(button) -> None:
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    QApplication.processEvents()


CORNER = [(0.575, 0.585), (0.585, 0.56), (0.60, 0.54)]
"""The subject's left corner of the mouth, and a way up from it; shares of the canvas."""


def places(window: MainWindow) -> list[QPoint]:
    return [at(window, *place) for place in CORNER]


def test_the_unit_is_seen_alone_while_it_is_sculpted_and_a_stroke_is_one_step(sculpting, document):
    rest, window = document.project, sculpting
    assert "AU 12 alone" in window.status.hint.text()
    before = points(window)
    stroke(window, places(window), release=False)
    held = points(window)
    assert np.linalg.norm(held - before, axis=1).max() > 3
    assert document.project is rest
    stroke_end = places(window)[-1]
    QTest.mouseRelease(window.viewport.canvas, Qt.MouseButton.LeftButton, pos=stroke_end)
    assert document.history.done == ("Pull AU 12",)
    np.testing.assert_allclose(points(window), held, atol=0.02)
    left, right = (document.project.corrections[name] for name in ("12L", "12R"))
    assert len(left.vertices) == len(right.vertices) > 5
    layer = window.panels.panel("actions").layer
    assert layer.amount.isEnabled()
    assert "Moves the skin up to" in layer.told.text()
    QTest.keyClick(window.viewport.canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert document.project.corrections == {}
    assert np.array_equal(points(window), before)


def test_esc_in_the_middle_puts_every_point_back(sculpting, document):
    before = points(sculpting)
    stroke(sculpting, places(sculpting), release=False)
    assert not np.array_equal(points(sculpting), before)
    QTest.keyClick(sculpting.viewport.canvas, Qt.Key.Key_Escape)
    assert np.array_equal(points(sculpting), before)
    assert not sculpting.toolbox.busy
    assert document.history.to_undo is None


def test_in_the_mix_the_slider_stays_and_the_row_is_marked(sculpting, document):
    document.set_weights({"12": 0.5, "26": 0.3})
    next_frame(sculpting)
    assert "in the mix" in sculpting.status.hint.text()
    before = points(sculpting)
    stroke(sculpting, places(sculpting))
    assert np.linalg.norm(points(sculpting) - before, axis=1).max() > 2
    assert document.shown == {"12L": 0.5, "12R": 0.5, "26": 0.3}
    assert sculpting.expression.rows[12]._sculpted
    assert not sculpting.expression.rows[17]._sculpted


def test_the_layer_is_weighed_switched_copied_mirrored_and_cleared(sculpting, document):
    panel = sculpting.panels.panel("actions")
    panel.brush.mirror.click()
    sculpting.toolbox.bench.sculpt.change(radius=9.0)
    stroke(sculpting, places(sculpting))
    assert list(document.project.corrections) == ["12L"]
    before = document.project
    press(panel.layer.deeds["sculpt.left"])
    assert set(document.project.corrections) == {"12L", "12R"}
    panel.layer.amount.setFocus()
    QTest.keyClick(panel.layer.amount, Qt.Key.Key_Home)
    panel.layer.amount.clearFocus()
    assert document.project.corrections["12L"].amount == 0.0
    document.undo()
    panel.layer.on.click()
    assert not document.project.corrections["12L"].on
    document.undo()
    entry = next(each for each in panel.layer.target_menu().actions() if each.text().startswith("20 "))
    entry.trigger()
    assert document.project.corrections["20L"] is document.project.corrections["12L"]
    press(panel.layer.deeds["sculpt.clear"])
    assert set(document.project.corrections) == {"20L", "20R"}
    for _ in range(3):
        document.undo()
    assert document.project.corrections == before.corrections


def test_size_strength_and_mirror_have_their_keys_and_the_panel_follows(sculpting):
    brush, canvas = sculpting.toolbox.bench.sculpt, sculpting.viewport.canvas
    panel = sculpting.panels.panel("actions").brush
    radius = brush.state.radius
    QTest.keyClick(canvas, Qt.Key.Key_BracketRight)
    assert brush.state.radius > radius
    assert panel.radius.value == brush.state.radius
    QTest.keyClick(canvas, Qt.Key.Key_X)
    assert not brush.state.mirror
    assert not panel.mirror.isChecked()
    press(panel.modes.button("raise"))
    assert brush.state.mode == "raise"
    assert panel.strength.value == 50


def test_pull_motion_and_sculpt_are_laid_on_the_skin_with_their_legend(actions):
    window, panel = actions, actions.panels.panel("actions")
    bare = picture(window)
    seen = {}
    for title in ("Pull", "Motion"):
        press(panel.editor.show_.sights[title])
        seen[title] = picture(window)
        assert differs(seen[title], bare)
    assert differs(seen["Pull"], seen["Motion"])
    press(panel.editor.show_.sights["Motion"])
    press(panel.editor.show_.sights["Forces"])
    assert differs(picture(window), bare)
    press(panel.editor.show_.sights["Forces"])
    assert not differs(picture(window), bare)
    QTest.keyClick(window.viewport.canvas, Qt.Key.Key_I)
    assert window.context.view.state.workspace == "actions"
    assert panel.editor.show_.sights["Pull"].isChecked()
    assert differs(picture(window), bare)


def test_a_solve_that_ends_in_the_middle_of_a_stroke_leaves_the_stroke_on_the_face(sculpting, document, solution):
    window, before = sculpting, points(sculpting)
    stroke(window, places(window), release=False)
    held = points(window)
    assert np.linalg.norm(held - before, axis=1).max() > 3
    document.accept(replace(solution), document.project)
    assert window.toolbox.busy
    np.testing.assert_allclose(points(window), held, atol=0.02)
    QTest.mouseRelease(window.viewport.canvas, Qt.MouseButton.LeftButton, pos=places(window)[-1])
    assert document.history.done == ("Pull AU 12",)
    np.testing.assert_allclose(points(window), held, atol=0.02)


def test_the_check_is_drawn_on_the_face_with_its_legend_and_can_be_cancelled(actions, document, qtbot):
    window, panel = actions, actions.panels.panel("actions")
    document.set_weights({"17": 0.9, "24": 0.9})
    panel.tabs.setCurrentIndex(1)
    bare = picture(window)
    press(panel.check.button)
    assert panel.check.button.text() == "Cancel"
    press(panel.check.button)
    assert not window.check.running
    assert "Checks what" in panel.check.result.text()
    press(panel.check.button)
    qtbot.waitUntil(lambda: window.check.found is not None)
    # Pressed lips rest on each other, where the sum of the loads would take them through.
    assert window.check.found.largest > 0.05
    assert "mm apart" in panel.check.result.text()
    assert differs(picture(window), bare)
    press(panel.check.draw)
    assert not differs(picture(window), bare)
    press(panel.check.draw)
    document.set_weights({"26": 0.5})
    assert window.check.found is None
    assert not panel.check.draw.isVisible()
