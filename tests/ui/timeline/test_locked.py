"""What is locked cannot be taken hold of: no box, click, key or field changes it, and no step counts it."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from tests.ui.timeline.stage import CTRL, SHIFT, Stage
from ui.timeline.paint.heads import switch_area, value_area
from ui.widgets.number_edit import NumberEdit

LOCK = 2
"""Which of the three switches of a track it is."""


def lock(stage: Stage, channel: str) -> None:
    placed = stage.view.layout.of(f"track {channel}")
    area = switch_area(placed.line, stage.panel.heads.area(placed), LOCK, 3)
    stage.click(area.center().toPoint(), widget=stage.panel.heads)
    assert stage.animation.track(channel).locked


def box(stage: Stage, first: str, last: str, start: float, end: float) -> None:
    """Draw a box over two lines and those between them."""
    one, two = stage.at(first, start, 0.1), stage.at(last, end, 0.9)
    top, foot = min(one.y(), two.y()), max(one.y(), two.y())
    stage.drag(QPoint(one.x(), top), QPoint(two.x(), foot))


def test_a_box_leaves_locked_keys_out_and_the_step_does_not_count_them(stage: Stage) -> None:
    lock(stage, "12R")
    box(stage, "track 12L", "track 12R", 0.8, 2.2)
    assert stage.timeline.chosen.keys == {("12L", 0): (1, 2)}
    stage.drag(stage.at("track 12L", 1.0), stage.at("track 12L", 1.3))
    assert stage.curve("12L").times[1] == pytest.approx(1.3, abs=0.02)
    assert stage.curve("12R").times.tolist() == [1.0]
    assert stage.steps[-1] == "Move 2 keys"


def test_locking_lets_go_of_keys_that_were_chosen(stage: Stage) -> None:
    stage.click(stage.at("track 12L", 1.0))
    stage.click(stage.at("track 12R", 1.0), SHIFT)
    lock(stage, "12R")
    assert stage.timeline.chosen.keys == {("12L", 0): (1,)}


def test_a_locked_key_is_neither_clicked_nor_dragged(stage: Stage) -> None:
    lock(stage, "12L")
    stage.click(stage.at("track 12L", 1.0))
    assert not stage.timeline.chosen
    stage.drag(stage.at("track 12L", 1.0), stage.at("track 12L", 1.6, 0.6))
    assert stage.curve("12L").times.tolist() == [0.5, 1.0, 2.0, 3.0]
    assert stage.steps == ("Lock Lip corner puller",)


@pytest.mark.parametrize("held", [Qt.KeyboardModifier.NoModifier, CTRL])
def test_choosing_all_or_the_others_leaves_locked_keys_out(stage: Stage, held) -> None:
    lock(stage, "17")
    stage.key(Qt.Key.Key_I if held else Qt.Key.Key_A, held)
    assert stage.timeline.chosen.keys
    assert ("17", 0) not in stage.timeline.chosen.keys


def test_a_sum_stands_for_the_keys_that_can_be_changed(stage: Stage) -> None:
    lock(stage, "12R")
    stage.click(stage.at("group Lower face · diagonal", 1.0))
    assert stage.timeline.chosen.keys == {("12L", 0): (1,)}


def test_in_the_graph_a_locked_curve_is_only_looked_at(stage: Stage) -> None:
    lock(stage, "17")
    stage.timeline.change(lines=frozenset(("track 17",)), mode="curves")
    stage.settle()
    graph = stage.panel.graph
    place = QPoint(stage.x(1.0), round(graph.values.y(stage.curve("17").values[0])))
    stage.click(place, widget=graph)
    assert not stage.timeline.chosen
    stage.drag(place - QPoint(30, 30), place + QPoint(30, 30), widget=graph)
    assert not stage.timeline.chosen


def test_what_would_set_a_key_there_says_why_it_does_not(stage: Stage) -> None:
    said: list[str] = []
    stage.panel.failed.connect(said.append)
    lock(stage, "17")
    steps = stage.steps
    place = stage.at("track 17", 2.0)
    stage.click(place)
    QTest.mouseDClick(stage.panel.sheet, Qt.MouseButton.LeftButton, pos=place)
    placed = stage.view.layout.of("track 17")
    value = value_area(placed.line, stage.panel.heads.area(placed)).center().toPoint()
    stage.drag(value, value - QPoint(60, 0), widget=stage.panel.heads)
    QTest.mouseDClick(stage.panel.heads, Qt.MouseButton.LeftButton, pos=value)
    editor = stage.panel.heads.findChild(NumberEdit)
    editor.selectAll()
    QTest.keyClicks(editor, "0.5")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    assert said == ["The track of chin raiser is locked; open its padlock to change it."] * 3
    assert stage.steps == steps
