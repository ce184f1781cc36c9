"""The actions' panel: units are made of muscles, solved, shown alone, and kept as expressions."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from app.authoring.units import with_note
from app.solo import seen
from facemodel.actions import expand
from facemodel.sculpting.correction import correction_of
from tests.ui.hands import drag
from ui.panels.actions.panel import ActionsPanel
from ui.panels.actions.unit_list import SCULPTED, WEIGHT
from ui.panels.expression_panel import ExpressionPanel


@pytest.fixture
def panel(make_panel) -> ActionsPanel:
    return make_panel()


def unit(context, number: int):
    return next(each for each in context.document.project.units if each.number == number)


def press(button) -> None:
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def test_a_new_unit_with_a_muscle_drives_the_face_after_the_solve(panel, context):
    press(panel.new)
    number = context.view.state.unit
    assert number == 101
    panel.editor.muscles.add_muscle("zygomaticus_major")
    basis = context.document.solution.basis
    assert basis.peak("101L") == pytest.approx(basis.peak("12L"), rel=1e-5)
    context.document.set_weights({"101": 0.7})
    assert context.document.shown == {"101L": 0.7, "101R": 0.7}
    context.document.undo(), context.document.undo(), context.document.undo()
    assert [each.number for each in context.document.project.units] == [12, 20, 17, 26]


def test_a_weight_is_solved_while_the_hand_moves_it_and_is_one_step(panel, context):
    before, peak = context.document.project, context.document.solution.basis.peak("12L")
    bar = panel.editor.muscles.weights["zygomaticus_major"]
    drag(bar, 0.2, 0.6, release=False)
    held = unit(context, 12).muscles["zygomaticus_major"]
    assert context.document.solution.basis.peak("12L") == pytest.approx(held * peak, rel=1e-4)
    QTest.keyClick(bar, Qt.Key.Key_Escape)
    assert context.document.project.units == before.units
    drag(bar, 0.2, 0.6)
    assert len(context.document.history.done) == 1
    context.document.undo()
    assert context.document.project.units == before.units


def test_fitting_moves_the_skin_as_far_as_the_unit_is_meant_to(panel, context):
    press(panel.editor.fit)
    wanted = unit(context, 12).amplitude
    basis = context.document.solution.basis
    assert max(basis.peak("12L"), basis.peak("12R")) == pytest.approx(wanted, rel=1e-4)
    assert f"{wanted:.1f} mm" in panel.editor.moved.text()


def test_the_jaw_is_a_number_of_degrees(panel, context):
    context.view.change(unit=26)
    bar = panel.editor.jaw.opening
    QTest.mouseDClick(bar, Qt.MouseButton.LeftButton)
    line = bar.findChild(QLineEdit)
    line.selectAll()
    QTest.keyClicks(line, "2*10")
    QTest.keyClick(line, Qt.Key.Key_Return)
    assert unit(context, 26).jaw.degrees == 20.0
    assert unit(context, 26).jaw.slide == 3.0


def test_a_deleted_unit_names_the_expressions_that_used_it(panel, context, desk):
    panel.units.setFocus()
    QTest.keyClick(panel.units, Qt.Key.Key_Delete)
    assert "Happiness" in desk.messages[-1]
    assert context.view.state.unit == 20
    context.document.undo()
    assert unit(context, 12).name == "lip corner puller"


def test_solo_shows_the_unit_alone_and_leaves_the_sliders(panel, context):
    context.document.set_weights({"17": 0.5})
    press(panel.buttons["unit.solo"])
    assert seen(context.document, context.view.state) == {"12L": 1.0, "12R": 1.0}
    context.view.change(workspace="expression")
    assert seen(context.document, context.view.state) == context.document.shown == {"17": 0.5}


def test_a_kept_expression_can_be_named_stands_among_the_emotions_and_drives_the_sliders(
    panel, shown, context, portraits, qtbot
):
    document = context.document
    sliders = shown(ExpressionPanel(document, context.view, portraits))
    document.set_weights({"17": 0.5, "12L": 0.25})
    panel.tabs.setCurrentIndex(1)
    press(panel.expressions.keep)
    name = panel.expressions.names.findChild(QLineEdit)
    name.selectAll()
    QTest.keyClicks(name, "sly")
    QTest.keyClick(name, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: document.project.emotions[-1].name == "sly")
    kept = document.project.emotions[-1]
    assert expand(kept.weights, document.project.units) == {"17": 0.5, "12L": 0.25}
    document.reset_expression()
    QTest.mouseClick(sliders.emotions.buttons["sly"], Qt.MouseButton.LeftButton)
    assert sliders.rows[17].slider.weight == 0.5
    assert sliders.rows[12].weights == (0.25, 0.0)


def test_expressions_are_ordered_renamed_and_deleted(panel, context, desk):
    document, listed = context.document, panel.expressions
    listed.choose("surprise")
    panel.tabs.setCurrentIndex(1)
    press(listed.up)
    assert [each.name for each in document.project.emotions] == ["surprise", "happiness"]
    listed.names.item(0).setText("Happiness")
    assert "already" in desk.messages[-1]
    assert listed.names.item(0).text() == "Surprise"
    press(listed.take_away)
    assert [each.name for each in document.project.emotions] == ["happiness"]


def test_the_check_finds_muscles_to_add_up_and_the_jaw_not(panel, context, qtbot):
    context.document.set_weights({"12": 0.5, "17": 0.3})
    panel.tabs.setCurrentIndex(1)
    press(panel.check.button)
    qtbot.waitUntil(lambda: "exact" in panel.check.result.text())
    context.document.set_weights({"26": 0.5})
    assert "Checks what" in panel.check.result.text()
    press(panel.check.button)
    qtbot.waitUntil(lambda: "apart, " in panel.check.result.text())


def test_a_unit_of_another_name_is_listed_so_where_the_sliders_are(panel, shown, context, portraits):
    sliders = shown(ExpressionPanel(context.document, context.view, portraits))
    panel.editor.head.name.selectAll()
    QTest.keyClicks(panel.editor.head.name, "smirk")
    QTest.keyClick(panel.editor.head.name, Qt.Key.Key_Return)
    assert sliders.rows[12].slider.label == "Smirk"


def test_a_unit_that_is_not_shown_is_seen_alone_while_a_hand_changes_it(panel, context):
    context.document.set_weights({"17": 0.5})
    bar = panel.editor.muscles.weights["zygomaticus_major"]
    drag(bar, 0.2, 0.6, release=False)
    assert seen(context.document, context.view.state) == {"12L": 1.0, "12R": 1.0}
    QTest.keyClick(bar, Qt.Key.Key_Escape)
    assert seen(context.document, context.view.state) == {"17": 0.5}
    context.document.set_weights({"12": 0.2})
    drag(bar, 0.2, 0.6, release=False)
    assert seen(context.document, context.view.state) == {"12L": 0.2, "12R": 0.2, "17": 0.5}
    QTest.keyClick(bar, Qt.Key.Key_Escape)


def test_the_unit_has_its_slider_beside_what_it_is_made_of(panel, context):
    row = panel.editor.show_.row
    drag(row.slider, 0.0, 0.5)
    assert context.document.shown["12L"] == context.document.shown["12R"] == pytest.approx(0.5, abs=0.02)
    assert panel.units.row_of(12).data(0, WEIGHT) == f"{context.document.shown['12L']:.2f}"
    context.view.change(unit=17)
    assert panel.editor.show_.row.unit.number == 17
    drag(panel.editor.show_.row.slider, 0.0, 0.25)
    assert context.document.shown["17"] == pytest.approx(0.25, abs=0.02)


def test_the_jaw_goes_aside_by_a_number_and_its_mirror_image_to_the_other_side(panel, context):
    context.view.change(unit=26)
    mirror = panel.buttons["unit.mirror"]
    assert not mirror.isEnabled()
    bar = panel.editor.jaw.side
    QTest.mouseDClick(bar, Qt.MouseButton.LeftButton)
    line = bar.findChild(QLineEdit)
    line.selectAll()
    QTest.keyClicks(line, "-4")
    QTest.keyClick(line, Qt.Key.Key_Return)
    assert unit(context, 26).jaw.side == -4.0
    press(mirror)
    assert unit(context, 26).jaw.side == 4.0
    assert bar.value == 4.0
    assert context.document.history.done[-1] == "Mirror Jaw drop"
    context.document.undo(), context.document.undo()
    assert unit(context, 26).jaw.side == 0.0


def test_a_sculpted_unit_is_marked_in_the_lists_and_told(panel, context, shown, portraits):
    sliders = shown(ExpressionPanel(context.document, context.view, portraits))
    bump = np.full((len(context.document.project.face.skin.positions), 3), 0.5)
    context.document.edit(replace(context.document.project, corrections={"17": correction_of(bump)}), "Sculpt")
    assert panel.units.row_of(17).data(0, SCULPTED)
    assert not panel.units.row_of(12).data(0, SCULPTED)
    assert "sculpted by hand" in sliders.rows[17].slider.toolTip()
    assert not panel.layer.amount.isEnabled()
    context.view.change(unit=17)
    assert panel.layer.amount.isEnabled()
    drag(panel.layer.amount, 0.9, 0.4, release=False)
    assert context.document.project.corrections["17"].amount < 0.7
    QTest.keyClick(panel.layer.amount, Qt.Key.Key_Escape)
    assert context.document.project.corrections["17"].amount == 1.0
    drag(panel.layer.amount, 0.9, 0.4)
    assert len(context.document.history.done) == 2


def test_a_note_of_several_lines_is_not_changed_by_being_looked_at(panel, context):
    context.document.edit(with_note(context.document.project, 12, "one\ntwo"), "Note")
    note = panel.editor.head.note
    assert note.text() == "one two"
    note.setFocus()
    panel.units.setFocus()
    assert unit(context, 12).note == "one\ntwo"
    note.setFocus()
    note.selectAll()
    QTest.keyClicks(note, "a smile")
    QTest.keyClick(note, Qt.Key.Key_Return)
    assert unit(context, 12).note == "a smile"
    context.document.undo()
    assert unit(context, 12).note == "one\ntwo"
