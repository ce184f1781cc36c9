"""Curves are bent in the graph by keys and handles, one gesture one step."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.timeline import deeds
from app.timeline.chosen import Chosen
from tests.ui.timeline.stage import ALT, SHIFT, Stage
from ui.timeline.paint.graph import handle_places, key_places
from ui.timeline.value_scale import fitted_values, value_step


@pytest.fixture
def graph(stage: Stage):
    stage.timeline.change(mode="curves", lines=frozenset(("track 12L", "track 17")))
    stage.settle()
    stage.panel.graph.frame_values()
    return stage.panel.graph


def key(graph, channel: str, place: int) -> QPoint:
    curve = next(each for each in graph.curves if each.row[0] == channel)
    return dict(key_places(graph.pane(), curve, graph.values))[place].toPoint()


def handle(graph, channel: str, ahead: bool) -> QPoint:
    curve = next(each for each in graph.curves if each.row[0] == channel)
    places = handle_places(graph.pane(), curve, graph.values)
    return next(at for _, way, at in places if way == ahead).toPoint()


def test_the_chosen_curves_are_shown(stage: Stage, graph) -> None:
    assert [curve.row[0] for curve in graph.curves] == ["17", "12L"]
    stage.timeline.change(lines=frozenset())
    assert len(graph.curves) == 6


def test_a_key_is_dragged_in_time_and_value(stage: Stage, graph) -> None:
    start = key(graph, "12L", 1)
    value = stage.curve("12L").values[1]
    stage.drag(start, start + QPoint(60, 50), widget=graph)
    assert stage.curve("12L").times[1] > 1.1
    assert stage.curve("12L").values[1] == pytest.approx(value - 50 / graph.values.per_unit, abs=0.02)
    assert stage.steps == ("Move key",)
    stage.context.document.undo()
    assert stage.curve("12L").values[1] == value


def test_shift_keeps_it_on_its_time(stage: Stage, graph) -> None:
    start, value = key(graph, "12L", 1), stage.curve("12L").values[1]
    QTest.mousePress(graph, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseRelease(graph, Qt.MouseButton.LeftButton, pos=start)
    stage.drag(start, start + QPoint(12, 60), SHIFT, widget=graph)
    assert stage.curve("12L").times[1] == 1.0
    assert stage.curve("12L").values[1] == pytest.approx(value - 60 / graph.values.per_unit, abs=0.02)


def test_a_handle_bends_the_curve_and_alt_breaks_it(stage: Stage, graph) -> None:
    stage.timeline.choose(Chosen({("12L", 0): (0, 1)}))
    deeds.shape(stage.timeline, "bezier")
    stage.timeline.choose(Chosen({("12L", 0): (1,)}))
    before = stage.curve("12L").handles.copy()
    start = handle(graph, "12L", ahead=True)
    stage.drag(start, start + QPoint(20, 30), widget=graph)
    after = stage.curve("12L").handles
    assert not np.allclose(after[1], before[1])
    assert not stage.curve("12L").broken[1]
    start = handle(graph, "12L", ahead=True)
    stage.drag(start, start - QPoint(0, 30), ALT, widget=graph)
    assert stage.curve("12L").broken[1]
    assert np.allclose(stage.curve("12L").handles[1, :2], after[1, :2])
    assert stage.steps == ("Make bezier", "Move handle", "Move handle")


def test_a_box_chooses_by_time_and_value(stage: Stage, graph) -> None:
    top, foot = key(graph, "12L", 1), key(graph, "17", 0)
    stage.drag(top - QPoint(20, 20), foot + QPoint(20, 20), widget=graph)
    assert stage.timeline.chosen.keys == {("12L", 0): (1,), ("17", 0): (0,)}
    stage.drag(top - QPoint(20, 20), top + QPoint(20, 20), widget=graph)
    assert stage.timeline.chosen.keys == {("12L", 0): (1,)}


def test_a_captured_curve_is_worked_on_in_its_layer(stage: Stage, graph) -> None:
    stage.timeline.change(lines=frozenset(("track 26",)))
    stage.settle()
    graph.frame_values()
    (curve,) = graph.curves
    assert curve.row == ("26", 1)
    start = key(graph, "26", 0)
    stage.drag(start, start + QPoint(0, 40), widget=graph)
    assert stage.curve("26", 1).values[0] < 0.7
    track = stage.animation.track("26")
    assert track is not None
    assert track.captured is not None


def test_weights_and_turns_share_the_axes(stage: Stage, graph) -> None:
    stage.timeline.change(lines=frozenset(("track 17", "track head.yaw")))
    factors = {curve.row[0]: curve.factor for curve in graph.curves}
    assert factors["17"] == 1.0
    assert factors["head.yaw"] == pytest.approx(1 / 80)
    graph.frame_values()
    start = key(graph, "head.yaw", 1)
    stage.drag(start, start - QPoint(0, 40), widget=graph)
    assert stage.curve("head.yaw").values[1] == pytest.approx(12 + 80 * 40 / graph.values.per_unit, abs=1)


def test_the_wheel_scrolls_and_zooms_values(stage: Stage, graph) -> None:
    place = QPoint(300, 100)
    before = graph.values
    stage.wheel(graph, place, 1, SHIFT)
    assert graph.values.top > before.top
    stage.wheel(graph, place, 1, ALT)
    assert graph.values.per_unit == pytest.approx(1.2 * before.per_unit)
    stage.pan(graph, QPoint(300, 100), QPoint(300, 60))
    assert graph.values.per_unit == pytest.approx(1.2 * before.per_unit)


def test_curves_are_drawn_in_colours_of_their_own(stage: Stage, graph) -> None:
    stage.timeline.change(lines=frozenset(("track 12L", "track 12R", "track 17", "track 20L")))
    stage.settle()
    assert len({curve.colour.name() for curve in graph.curves}) == 4
    picture = graph.grab().toImage()
    seen = {picture.pixelColor(x, y).name() for x in range(picture.width()) for y in range(0, picture.height(), 2)}
    assert sum(curve.colour.name() in seen for curve in graph.curves) == 4


@pytest.mark.parametrize(("least", "step"), [(0.3, 0.5), (1.0, 1.0), (0.011, 0.02), (7.0, 10.0)])
def test_lines_of_values_are_round_numbers(least: float, step: float) -> None:
    assert value_step(least) == pytest.approx(step)


def test_a_range_of_values_is_brought_into_view() -> None:
    scale = fitted_values(-1.0, 3.0, 200)
    assert 0 < scale.y(3.0) < scale.y(-1.0) < 200
    assert scale.value(scale.y(0.7)) == pytest.approx(0.7)
    assert fitted_values(0.5, 0.5, 200).per_unit > 0


def test_only_what_has_a_curve_is_listed_beside_the_graph(stage: Stage) -> None:
    kinds = {line.kind for line in stage.view.lines}
    assert {"expressions", "speech", "track"} <= kinds
    stage.timeline.change(mode="curves")
    assert {line.kind for line in stage.view.lines} == {"group", "track", "layer"}
    stage.timeline.change(mode="keys")
    assert {line.kind for line in stage.view.lines} == kinds
