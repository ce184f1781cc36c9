"""The actions' panel: units are made of muscles, solved, shown alone, and kept as expressions."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from app.solo import seen
from facemodel.actions import expand
from tests.ui.hands import drag
from ui.panels.actions.panel import ActionsPanel
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
    qtbot.waitUntil(lambda: document.project.emotions[-1].name == "sly", timeout=3000)
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
    qtbot.waitUntil(lambda: "exact" in panel.check.result.text(), timeout=10_000)
    context.document.set_weights({"26": 0.5})
    assert panel.check.result.text() == ""
    press(panel.check.button)
    qtbot.waitUntil(lambda: "apart, " in panel.check.result.text(), timeout=10_000)


def test_a_unit_of_another_name_is_listed_so_where_the_sliders_are(panel, shown, context, portraits):
    sliders = shown(ExpressionPanel(context.document, context.view, portraits))
    panel.editor.head.name.selectAll()
    QTest.keyClicks(panel.editor.head.name, "smirk")
    QTest.keyClick(panel.editor.head.name, Qt.Key.Key_Return)
    assert sliders.rows[12].slider.label == "Smirk"
