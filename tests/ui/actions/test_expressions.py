"""Named expressions: dragged, typed, copied, laid on the pad and blended, each gesture in one step."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit

from facemodel.actions import expand
from tests.ui.hands import move
from ui.panels.actions.expression_rows import NAME, SHOWN
from ui.panels.actions.panel import EXPRESSIONS, UNITS, ActionsPanel

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def panel(make_panel, context) -> ActionsPanel:
    panel = make_panel(360, 900)
    panel.tabs.setCurrentIndex(EXPRESSIONS)
    QApplication.processEvents()
    return panel


def names(context) -> list[str]:
    return [each.name for each in context.document.project.emotions]


def row_of(panel: ActionsPanel, name: str) -> int:
    rows = panel.expressions.names
    return next(row for row in range(rows.count()) if rows.item(row).data(NAME) == name)


def drag_row(panel: ActionsPanel, name: str, over: QPoint, release: bool = True) -> None:
    """Drag the row of an expression to a place of the screen."""
    rows = panel.expressions.names
    start = rows.visualItemRect(rows.item(row_of(panel, name))).center()
    end = rows.viewport().mapFromGlobal(over)
    QTest.mousePress(rows.viewport(), LEFT, pos=start)
    for share in (0.2, 0.6, 1.0):
        move(rows.viewport(), start + share * (end - start))
    if release:
        QTest.mouseRelease(rows.viewport(), LEFT, pos=end)
    QApplication.processEvents()


def lay(panel: ActionsPanel, name: str, x: float, y: float) -> None:
    """Drag an expression from the list to a place of the pad."""
    pad = panel.blend.pad
    drag_row(panel, name, pad.mapToGlobal(pad.spot((x, y)).toPoint()))


def drag_on_pad(panel: ActionsPanel, start: tuple[float, float], end: QPoint, release: bool = True) -> None:
    pad = panel.blend.pad
    first = pad.spot(start).toPoint()
    QTest.mousePress(pad, LEFT, pos=first)
    for share in (0.3, 0.7, 1.0):
        move(pad, first + share * (end - first))
    if release:
        QTest.mouseRelease(pad, LEFT, pos=end)


def spot(panel: ActionsPanel, x: float, y: float) -> QPoint:
    return panel.blend.pad.spot((x, y)).toPoint()


def test_rows_are_dragged_to_another_place_in_one_step(panel, context):
    rows = panel.expressions.names
    below = rows.visualItemRect(rows.item(1)).bottomLeft() + QPoint(40, 4)
    drag_row(panel, "happiness", rows.viewport().mapToGlobal(below))
    assert names(context) == ["surprise", "happiness"]
    assert panel.expressions.chosen.name == "happiness"
    QTest.keyClick(rows, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert names(context) == ["happiness", "surprise"]
    context.document.undo(), context.document.undo()
    assert not context.document.history.done


@pytest.mark.parametrize("right", [False, True], ids=["esc", "right button"])
def test_a_row_in_the_middle_of_a_drag_is_left_where_it_is(panel, context, right):
    rows, pad = panel.expressions.names, panel.blend.pad
    bare = pad.grab().toImage()
    for over in (rows.viewport().mapToGlobal(rows.visualItemRect(rows.item(1)).bottomLeft()), on_pad(panel, 0.5, 0.5)):
        drag_row(panel, "happiness", over, release=False)
        if right:
            QTest.mouseClick(rows.viewport(), Qt.MouseButton.RightButton, pos=rows.viewport().mapFromGlobal(over))
        else:
            QTest.keyClick(rows, Qt.Key.Key_Escape)
        QTest.mouseRelease(rows.viewport(), LEFT, pos=rows.viewport().mapFromGlobal(over))
        assert pad.grab().toImage() == bare
    assert not context.document.history.done


def on_pad(panel: ActionsPanel, x: float, y: float) -> QPoint:
    return panel.blend.pad.mapToGlobal(spot(panel, x, y))


def test_an_expression_that_is_shown_is_marked_and_enter_shows_one(panel, context):
    rows = panel.expressions.names
    panel.expressions.choose("happiness")
    QTest.keyClick(rows, Qt.Key.Key_Return)
    assert context.document.shown == {"12L": 0.9, "12R": 0.9}
    assert rows.item(0).data(SHOWN)
    context.document.set_weights({"17": 0.5})
    assert not rows.item(0).data(SHOWN)


def test_the_weights_are_typed_and_a_wrong_text_changes_nothing(panel, context, desk):
    panel.expressions.choose("happiness")
    line: QLineEdit = panel.expressions.text
    assert line.text() == "12=0.9"
    line.setFocus()
    line.selectAll()
    QTest.keyClicks(line, "12L=0.5 17=25%")
    QTest.keyClick(line, Qt.Key.Key_Return)
    project = context.document.project
    assert expand(project.emotions[0].weights, project.units) == {"12L": 0.5, "17": 0.25}
    assert len(context.document.history.done) == 1
    line.selectAll()
    QTest.keyClicks(line, "99=1")
    QTest.keyClick(line, Qt.Key.Key_Return)
    assert "99" in desk.messages[-1]
    assert context.document.project is project
    panel.expressions.names.setFocus()
    assert line.text() == "12L=0.5 17=0.25"


def test_copied_as_text_and_pasted_it_stands_at_the_end_of_the_list(panel, context, desk):
    rows = panel.expressions.names
    panel.expressions.choose("surprise")
    rows.setFocus()
    QTest.keyClick(rows, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert desk.text == "surprise: 20L=0.1 26=0.8"
    desk.text = "smirk: 12L=0.4 14=1"
    QTest.keyClick(rows, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    assert names(context)[-1] == "smirk"
    assert "Left out “14”" in desk.messages[-1]
    desk.text = "nothing of the kind"
    QTest.mouseClick(panel.expressions.paste_it, LEFT)
    assert len(names(context)) == 3


def test_expressions_are_dragged_onto_the_pad_about_it_and_off_it(panel, context):
    lay(panel, "happiness", 0.1, 0.9)
    lay(panel, "surprise", 0.9, 0.9)
    happiness, surprise = context.document.project.emotions
    assert happiness.place == pytest.approx((0.1, 0.9), abs=0.01)
    assert surprise.place == pytest.approx((0.9, 0.9), abs=0.01)
    drag_on_pad(panel, happiness.place, spot(panel, 0.2, 0.2))
    assert context.document.project.emotions[0].place == pytest.approx((0.2, 0.2), abs=0.01)
    drag_on_pad(panel, surprise.place, QPoint(-60, -60))
    assert context.document.project.emotions[1].place is None
    assert context.document.history.done == (
        "Place Happiness",
        "Place Surprise",
        "Place Happiness",
        "Take Surprise off the pad",
    )
    for _ in range(4):
        context.document.undo()
    assert [each.place for each in context.document.project.emotions] == [None, None]


def test_the_pointer_blends_while_it_is_dragged_and_that_is_one_step(panel, context):
    lay(panel, "happiness", 0.0, 1.0)
    steps = len(context.document.history.done)
    drag_on_pad(panel, (0.5, 0.5), spot(panel, 0.25, 0.75), release=False)
    assert context.document.shown["12L"] == pytest.approx(0.45, abs=0.02)
    assert context.document.project.expression == {}
    assert panel.blend.pad.meant
    QTest.keyClick(panel.blend.pad, Qt.Key.Key_Escape)
    assert context.document.shown == {}
    assert panel.blend.pad.pointer == (0.5, 0.5)
    drag_on_pad(panel, (0.5, 0.5), spot(panel, 0.1, 0.9))
    assert context.document.history.done[steps:] == ("Blend expressions",)
    assert context.document.shown["12L"] > 0.8
    context.document.set_weights({"17": 0.3})
    assert not panel.blend.pad.meant
    context.document.undo(), context.document.undo()
    assert context.document.shown == {}


def test_numbers_place_what_is_picked_and_else_the_pointer(panel, context):
    lay(panel, "happiness", 0.1, 0.9)

    def type_into(bar, text: str) -> None:
        QTest.mouseDClick(bar, LEFT)
        line = bar.findChild(QLineEdit)
        line.selectAll()
        QTest.keyClicks(line, text)
        QTest.keyClick(line, Qt.Key.Key_Return)

    assert panel.blend.x.label == "Happiness across"
    type_into(panel.blend.x, "0.25")
    assert context.document.project.emotions[0].place == pytest.approx((0.25, 0.9), abs=0.01)
    QTest.mouseClick(panel.blend.pad, LEFT, pos=spot(panel, 0.8, 0.1))
    assert panel.blend.x.label == "Pointer across"
    steps = len(context.document.history.done)
    type_into(panel.blend.y, "1/2")
    assert panel.blend.pad.pointer[1] == 0.5
    assert len(context.document.history.done) == steps + 1


def test_arrow_keys_step_the_pointer_and_a_held_key_is_one_step(panel, context):
    lay(panel, "happiness", 0.1, 0.9)
    steps, pad = len(context.document.history.done), panel.blend.pad
    pad.setFocus()
    for _ in range(5):
        QTest.keyPress(pad, Qt.Key.Key_Left)
    QTest.keyRelease(pad, Qt.Key.Key_Left)
    assert pad.pointer[0] == pytest.approx(0.4)
    assert len(context.document.history.done) == steps + 1


def test_a_double_click_shows_one_alone_and_delete_takes_it_off(panel, context):
    lay(panel, "happiness", 0.1, 0.9)
    pad = panel.blend.pad
    QTest.mouseClick(pad, LEFT, pos=spot(panel, 0.1, 0.9))
    QTest.mouseDClick(pad, LEFT, pos=spot(panel, 0.1, 0.9))
    QTest.mouseRelease(pad, LEFT, pos=spot(panel, 0.1, 0.9))
    assert context.document.shown == {"12L": 0.9, "12R": 0.9}
    pad.setFocus()
    QTest.keyClick(pad, Qt.Key.Key_Delete)
    assert context.document.project.emotions[0].place is None


def test_all_are_arranged_put_and_taken_off_by_buttons(panel, context):
    QTest.mouseClick(panel.blend.arrange, LEFT)
    assert all(each.place for each in context.document.project.emotions)
    QTest.mouseClick(panel.blend.empty, LEFT)
    assert not any(each.place for each in context.document.project.emotions)
    panel.expressions.choose("surprise")
    QTest.mouseClick(panel.blend.put, LEFT)
    assert context.document.project.emotions[1].place is not None
    QTest.mouseClick(panel.blend.put, LEFT)
    assert context.document.project.emotions[1].place is None


def test_the_sculpting_brush_belongs_to_the_units(panel, context, toolbox):
    assert context.view.state.mixing
    toolbox.take("sculpt")
    assert panel.tabs.currentIndex() == UNITS
    panel.tabs.setCurrentIndex(EXPRESSIONS)
    assert toolbox.tool.id == "select"


def test_nothing_sticks_out_of_a_panel_of_its_smallest_width(make_panel, context):
    panel = make_panel(344, 900)
    for tab in (UNITS, EXPRESSIONS):
        panel.tabs.setCurrentIndex(tab)
        QApplication.processEvents()
        page = panel.tabs.currentWidget()
        for child in page.findChildren(QLineEdit) + page.findChildren(type(panel.blend.x)):
            if child.isVisible():
                right = child.mapTo(panel, QPointF(child.width(), 0)).x()
                assert right <= panel.width() + 0.5, child.accessibleName()
