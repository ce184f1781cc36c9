"""The muscles' panel: what the hand does to a number, a name or a whole muscle, and what undo takes back."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from app.tools import TOOLS, Bench, ToolBox
from facemodel.laying.sides import mirrored
from facemodel.sameness import same
from tests.ui.hands import drag
from ui.panels.muscles.panel import MusclesPanel
from ui.panels.muscles.tree import LEFT, NAME, RIGHT

LEFT_KEY, RIGHT_KEY = "zygomaticus_major_L", "zygomaticus_major_R"


@pytest.fixture
def panel(shown, context) -> MusclesPanel:
    context.view.change(workspace="muscles")
    context.solving.solve()
    panel = MusclesPanel(context, ToolBox(Bench(context.document, context.view), TOOLS))
    panel.resize(360, 800)
    return shown(panel)


def click(tree, key: str, column: int | None = None, modifiers=Qt.KeyboardModifier.NoModifier) -> None:
    row, own = tree.item_of(key)
    index = tree.indexFromItem(row, own if column is None else column)
    place = tree.visualRect(index).center()
    QTest.mouseClick(tree.viewport(), Qt.MouseButton.LeftButton, modifiers, place)


def width(document, key: str) -> float:
    return next(muscle.width for muscle in document.project.muscles if muscle.key == key)


def test_a_click_on_a_chip_selects_one_side_and_on_the_name_both(panel, context):
    click(panel.tree, RIGHT_KEY)
    assert context.view.state.selected == {RIGHT_KEY}
    click(panel.tree, LEFT_KEY, NAME)
    assert context.view.state.selected == {LEFT_KEY, RIGHT_KEY}


def test_what_is_selected_on_the_face_is_selected_in_the_tree(panel, context):
    context.view.change(muscle=LEFT_KEY)
    cells = {(index.column(), index.data()) for index in panel.tree.selectedIndexes()}
    assert cells == {(LEFT, "L")}
    assert panel.properties.title.text() == "Zygomaticus major"
    context.view.change(muscle=LEFT_KEY, others=frozenset({RIGHT_KEY}))
    assert {index.column() for index in panel.tree.selectedIndexes()} == {NAME, LEFT, RIGHT}


def test_a_number_takes_a_sum_changes_both_sides_and_undo_is_exact(panel, context):
    document, before = context.document, context.document.project
    context.view.change(muscle=LEFT_KEY)
    bar = panel.properties.bars["width"]
    QTest.mouseDClick(bar, Qt.MouseButton.LeftButton)
    editor = bar.findChild(QLineEdit)
    editor.selectAll()
    QTest.keyClicks(editor, "10 + 5/2")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    assert width(document, LEFT_KEY) == width(document, RIGHT_KEY) == 12.5
    assert document.history.done == ("Width of Zygomaticus major",)
    assert not any(line.isVisible() for line in bar.findChildren(QLineEdit)), "Enter closes the line for good"
    document.undo()
    assert same(document.project.muscles, before.muscles)
    assert bar.value == width(document, LEFT_KEY)


def test_a_drag_is_seen_while_it_moves_is_one_step_and_esc_takes_it_back(panel, context):
    document, before = context.document, context.document.project
    context.view.change(muscle=LEFT_KEY)
    bar = panel.properties.bars["strength"]
    solved = document.solution
    drag(bar, 0.2, 0.7, release=False)
    assert document.solution is not solved
    QTest.keyClick(bar, Qt.Key.Key_Escape)
    assert document.history.done == ()
    assert same(document.project.muscles, before.muscles)
    drag(bar, 0.2, 0.7)
    assert document.history.done == ("Strength of Zygomaticus major",)
    document.undo()
    assert same(document.project.muscles, before.muscles)


def test_a_muscle_in_step_stays_the_mirror_image_until_it_is_unlinked(panel, context):
    document = context.document
    context.view.change(muscle=LEFT_KEY)
    drag(panel.properties.bars["kappa"], 0.2, 0.5)
    left, right = document.project.muscles
    assert same(mirrored(left, document.project.face), right)
    QTest.mouseClick(panel.buttons["muscle.link"], Qt.MouseButton.LeftButton)
    drag(panel.properties.bars["kappa"], 0.5, 0.2)
    left, right = document.project.muscles
    assert left.kappa < right.kappa


def test_deleting_a_muscle_names_its_units_and_undo_brings_all_back(panel, context, desk):
    document, before = context.document, context.document.project
    context.view.change(muscle=LEFT_KEY)
    panel.tree.setFocus()
    QTest.keyClick(panel.tree, Qt.Key.Key_Delete)
    assert document.project.muscles == ()
    assert all(not unit.muscles for unit in document.project.units)
    assert "AU 12, 17, 20" in desk.messages[-1]
    document.undo()
    assert same(document.project.muscles, before.muscles)
    assert document.project.units == before.units


def test_a_copy_is_pasted_beside_and_selected(panel, context, desk):
    context.view.change(muscle=LEFT_KEY)
    panel.tree.setFocus()
    QTest.keyClick(panel.tree, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClick(panel.tree, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    first, *_, last = context.document.project.muscles
    assert context.view.state.selected == {last.key}
    assert last.name == "zygomaticus_major_2"
    assert np.array_equal(first.fibres[0].points, last.fibres[0].points)


def test_a_new_title_is_told_on_both_sides_and_an_impossible_name_is_refused(panel, context, desk):
    context.view.change(muscle=LEFT_KEY)
    title, name = panel.properties.title, panel.properties.name
    title.selectAll()
    QTest.keyClicks(title, "Smiler")
    QTest.keyClick(title, Qt.Key.Key_Return)
    assert {muscle.title for muscle in context.document.project.muscles} == {"Smiler"}
    name.selectAll()
    QTest.keyClicks(name, "two words")
    QTest.keyClick(name, Qt.Key.Key_Return)
    assert "cannot name a muscle" in desk.messages[-1]
    assert name.text() == "zygomaticus_major"


def test_another_model_offers_its_own_numbers(panel, context):
    context.view.change(muscle=LEFT_KEY)
    choice = panel.properties.model
    choice.setCurrentIndex(choice.findData("cosine"))
    choice.activated.emit(choice.currentIndex())
    assert "cosine.share" in panel.properties.bars
    assert {muscle.model for muscle in context.document.project.muscles} == {"cosine"}


def test_the_search_hides_what_it_does_not_find(panel):
    panel.search.setText("cheek zygo")
    row, _ = panel.tree.item_of(LEFT_KEY)
    assert not row.isHidden()
    panel.search.setText("frontalis")
    assert row.isHidden()
