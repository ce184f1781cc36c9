"""The sliders of a unit: where they end, how they are scored, in which order they stand, and two made one."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QLineEdit

from app.actions.context import Merge
from app.authoring.ordering import listed
from tests.ui.hands import drag, move
from ui.panels.actions.merge_page import MergePage, ask_merge
from ui.panels.actions.panel import ActionsPanel
from ui.panels.actions.unit_list import NUMBER


@pytest.fixture
def panel(make_panel) -> ActionsPanel:
    return make_panel(380, 1300)


def unit(context, number: int):
    return next(each for each in context.document.project.units if each.number == number)


def numbers(context) -> list[int]:
    return [each.number for each in listed(context.document.project)]


def choose(box: QComboBox, row: int) -> None:
    """Choose a row of a combo box by the keyboard, as a person does."""
    box.setFocus()
    QTest.keyClick(box, Qt.Key.Key_Home if row == 0 else Qt.Key.Key_End)


def drag_row(panel: ActionsPanel, number: int, onto: int, below: bool) -> None:
    """Drag the row of a unit to the upper or lower edge of another one's."""
    rows = panel.units
    start = rows.visualItemRect(rows.row_of(number)).center()
    area = rows.visualItemRect(rows.row_of(onto))
    end = QPoint(area.center().x(), area.bottom() - 2 if below else area.top() + 2)
    QTest.mousePress(rows.viewport(), Qt.MouseButton.LeftButton, pos=start)
    for share in (0.3, 0.6, 1.0):
        move(rows.viewport(), start + share * (end - start))
    QTest.mouseRelease(rows.viewport(), Qt.MouseButton.LeftButton, pos=end)
    QApplication.processEvents()


def test_sides_are_joined_and_split_again(panel, context):
    choose(panel.editor.range.sides, 1)
    assert not unit(context, 12).paired
    choose(panel.editor.range.sides, 0)
    assert unit(context, 12).paired
    context.document.undo(), context.document.undo()
    assert not context.document.history.done


def test_sliders_end_where_the_bar_says(panel, context):
    context.document.set_weights({"12L": 1.0})
    bar = panel.editor.range.limit
    QTest.mouseDClick(bar, Qt.MouseButton.LeftButton)
    line = bar.findChild(QLineEdit)
    line.selectAll()
    QTest.keyClicks(line, "0.8")
    QTest.keyClick(line, Qt.Key.Key_Return)
    assert unit(context, 12).limit == 0.8
    assert context.document.shown["12L"] == 0.8
    context.document.undo()
    assert context.document.shown["12L"] == 1.0


def test_a_cut_between_letters_is_dragged_and_taken_back(panel, context):
    bar = panel.editor.range.letters
    before = bar.letters
    share = bar.place("C") / bar.width()
    drag(bar, share, share - 0.1, release=False)
    assert bar.letters[2] < before[2]
    QTest.keyClick(bar, Qt.Key.Key_Escape)
    assert bar.letters == before
    drag(bar, share, share - 0.1, release=False)
    QTest.mouseClick(bar, Qt.MouseButton.RightButton)
    QTest.mouseRelease(bar, Qt.MouseButton.LeftButton)
    assert bar.letters == before
    drag(bar, share, share - 0.1)
    assert unit(context, 12).letters[2] == bar.letters[2] < before[2]
    assert len(context.document.history.done) == 1


def test_letters_choose_their_cut_and_arrows_step_it(panel, context):
    bar = panel.editor.range.letters
    bar.setFocus()
    before = bar.letters
    QTest.keyClick(bar, Qt.Key.Key_B)
    QTest.keyClick(bar, Qt.Key.Key_Right)
    assert unit(context, 12).letters[1] == pytest.approx(before[1] + 0.01)


def test_rows_are_dragged_and_stepped_to_another_place(panel, context):
    before = numbers(context)
    first, second = before[0], before[1]
    drag_row(panel, first, second, below=True)
    assert numbers(context)[:2] == [second, first]
    panel.units.setCurrentItem(panel.units.row_of(first))
    QTest.keyClick(panel.units, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert numbers(context) == before
    assert panel.units.currentItem().data(0, NUMBER) == first


def test_two_units_become_one_in_the_proportion_asked_for(panel, context, desk):
    project = context.document.project
    desk.merge = Merge(20, 1.0, 0.5)
    QTest.mouseClick(panel.buttons["unit.merge"], Qt.MouseButton.LeftButton)
    assert 20 not in numbers(context)
    both, other = unit(context, 12), next(each for each in project.units if each.number == 20)
    for name, weight in other.muscles.items():
        own = next(each for each in project.units if each.number == 12).muscles.get(name, 0.0)
        assert both.muscles[name] == pytest.approx(own + 0.5 * weight)
    context.document.undo()
    assert context.document.project.units == project.units


def test_the_page_asks_for_partner_and_shares(shown, context):
    units = context.document.project.units
    page = shown(MergePage(None, units[0], units[1:]))
    page.partner.setCurrentIndex(1)
    drag(page.share, 0.5, 0.25)
    assert page.asked.other == units[2].number
    assert page.asked.own == 1.0
    assert page.asked.share < 1.0
    QTest.keyClick(page, Qt.Key.Key_Return)
    assert page.result() == MergePage.DialogCode.Accepted


def test_a_page_that_is_left_asks_for_nothing(context, qtbot, monkeypatch):
    units = context.document.project.units
    monkeypatch.setattr(MergePage, "exec", lambda _self: MergePage.DialogCode.Rejected)
    assert ask_merge(None, units[0], units[1:]) is None
