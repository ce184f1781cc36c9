"""Turning, switching, pointing."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QIcon
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox

from tests.ui.hands import enter, leave
from tests.ui.window.seen import differs, picture
from tests.ui.workspaces.test_switching import camera
from ui.panels.muscle_text import muscle_label
from ui.theme.metrics import ROW

Button = QMessageBox.StandardButton
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
SMILE = 12


def test_a_right_drag_turns_the_head_and_a_key_brings_the_front_back(window):
    QTest.keyClick(window, Qt.Key.Key_1)
    front = picture(window)
    canvas = window.viewport.canvas
    right = Qt.MouseButton.RightButton
    QTest.mousePress(canvas, right, pos=QPoint(300, 300))
    QTest.mouseMove(canvas, QPoint(380, 310))
    QTest.mouseRelease(canvas, right, pos=QPoint(380, 310))
    assert window.context.view.state.view == "free"
    assert differs(picture(window), front)
    QTest.keyClick(window, Qt.Key.Key_1)
    assert not differs(picture(window), front)


def test_the_palette_finds_the_skull_and_shows_it(window):
    before = picture(window)
    QTest.keyClick(window, Qt.Key.Key_P, CTRL | SHIFT)
    assert window.palette_box.isVisible()
    QTest.keyClicks(window.palette_box.line, "skull")
    QTest.keyClick(window.palette_box.line, Qt.Key.Key_Return)
    assert window.context.view.state.skull
    assert window.binding.qt["view.skull"].isChecked()
    assert differs(picture(window), before)


def test_an_expression_typed_into_the_palette_is_shown(window, document):
    window.palette_box.open_palette()
    QTest.keyClicks(window.palette_box.line, "12=0.5 26=40%")
    QTest.keyClick(window.palette_box.line, Qt.Key.Key_Return)
    assert {name: w for name, w in document.shown.items() if w} == {"12L": 0.5, "12R": 0.5, "26": 0.4}


@pytest.mark.parametrize("overlay", ["skull", "muscles", "supports", "wireframe"])
def test_a_switch_of_the_toolbar_is_seen_and_unseen(window, overlay):
    before = picture(window)
    button = window.strip.widgetForAction(window.binding.qt[f"view.{overlay}"])
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert differs(picture(window), before)
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert not differs(picture(window), before)


def test_influence_asks_for_a_muscle_and_shows_the_one_chosen(window, project):
    QTest.keyClick(window, Qt.Key.Key_I)
    assert window.context.view.state.workspace == "muscles"
    before = picture(window)
    tree = window.panels.panel("muscles").tree
    row, column = tree.item_of(project.muscles[3].key)
    QTest.mouseClick(tree.viewport(), Qt.MouseButton.LeftButton, pos=tree.visualItemRect(row).center())
    tree.setCurrentItem(row, column)
    assert window.context.view.state.muscle == project.muscles[3].key
    assert differs(picture(window), before)


def test_a_bar_under_the_pointer_lets_its_muscles_glow(window):
    before = picture(window)
    slider = window.expression.rows[SMILE].slider
    enter(slider)
    assert differs(picture(window), before)
    leave(slider)
    assert not differs(picture(window), before)


def test_the_face_under_the_pointer_names_its_muscle_and_a_click_selects_it(window, qtbot, project):
    QTest.keyClick(window, Qt.Key.Key_1)
    picture(window)
    canvas = window.viewport.canvas
    cheek = QPoint(round(canvas.width() * 0.56), round(canvas.height() * 0.55))
    QTest.mouseMove(canvas, cheek)
    qtbot.waitUntil(lambda: window.viewport.pointer.isVisible())
    words = window.viewport.pointer.text()
    named = {muscle.key for muscle in project.muscles if muscle_label(muscle) == words}
    assert len(named) == 1
    QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=cheek)
    assert window.context.view.state.muscle in named


def test_the_turntable_turns_until_it_is_stopped(window):
    QTest.keyClick(window, Qt.Key.Key_T)
    one = picture(window)
    QTest.qWait(300)
    assert differs(picture(window), one)
    QTest.keyClick(window, Qt.Key.Key_T)
    still = picture(window)
    QTest.qWait(150)
    assert not differs(picture(window), still)


def test_a_double_click_on_the_face_leaves_the_left_button_to_the_tools(window):
    canvas, middle = window.viewport.canvas, window.viewport.canvas.rect().center()
    before = camera(window)
    for _ in range(2):
        QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=middle)
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=middle)
    QTest.mouseMove(canvas, middle + QPoint(60, 40))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=middle + QPoint(60, 40))
    assert camera(window) == before


def test_a_low_window_shows_where_the_rest_of_the_toolbar_is(window):
    window.resize(window.minimumSize())
    QApplication.processEvents()
    rest = window.strip.rest
    assert rest.isVisible()
    marked = rest.grab().toImage()
    rest.setIcon(QIcon())
    assert rest.grab().toImage() != marked


def test_a_low_window_leaves_the_lists_of_units_and_muscles_some_rows(window):
    window.resize(window.minimumSize())
    for workspace, part in (("actions", "units"), ("muscles", "tree")):
        window.show_workspace(workspace)
        QApplication.processEvents()
        assert getattr(window.panels.panel(workspace), part).height() >= 5 * ROW


def test_an_empty_timeline_fits_what_it_says_into_a_narrow_window(window, qtbot):
    window.timeline.dock.open()
    hint, sheet = window.timeline.panel.empty, window.timeline.panel.sheet
    for wide in (window.minimumWidth(), 1600, window.minimumWidth()):
        window.resize(wide, 900)
        qtbot.waitUntil(lambda: sheet.rect().contains(hint.geometry()))
        assert all(hint.rect().contains(button.geometry()) for button in hint.offers)


def test_what_people_call_things_is_no_markup_in_a_tooltip(window, document):
    joy = replace(document.project.emotions[0], name="<h1>joy</h1>")
    document.edit(replace(document.project, emotions=(joy, *document.project.emotions[1:])), "Rename")
    assert "&lt;h1&gt;" in window.expression.emotions.buttons[joy.name].toolTip()
    window.binding.rebuild()
    assert "&lt;h1&gt;" in window.binding.qt[f"emotion.{joy.name}"].toolTip()
