"""The ruler scrubs, bounds, marks and stretches; heads fold, mute, choose and set values."""

import pytest
from PySide6.QtCore import QPoint, QRectF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit

from tests.ui.timeline.stage import CTRL, SHIFT, Stage
from ui.timeline.paint.heads import fold_area, switch_area, value_area
from ui.timeline.paint.ruler import BAND, MARKS, TIMES
from ui.timeline.time_field import STYLES
from ui.timeline.time_scale import TimeScale, ticks
from ui.widgets.number_edit import NumberEdit


def on_ruler(stage: Stage, time: float, y: int) -> QPoint:
    return QPoint(stage.x(time), y)


def test_scrubbing_shows_the_face_and_makes_no_step(stage: Stage) -> None:
    stage.drag(on_ruler(stage, 0.5, 8), on_ruler(stage, 2.0, 8), widget=stage.panel.ruler)
    assert stage.timeline.playhead.time == pytest.approx(2.0, abs=1 / 30)
    assert stage.context.document.shown["12L"] > 0.1
    assert stage.steps == ()


def test_escape_while_scrubbing_goes_back(stage: Stage) -> None:
    stage.timeline.playhead.go(1.0)
    stage.drag(on_ruler(stage, 0.5, 8), on_ruler(stage, 2.0, 8), widget=stage.panel.ruler, release=False)
    QTest.keyClick(stage.panel.ruler, Qt.Key.Key_Escape)
    assert stage.timeline.playhead.time == 1.0


def test_the_handles_bound_what_is_played(stage: Stage) -> None:
    end = on_ruler(stage, 4.0, TIMES - 3) - QPoint(3, 0)
    stage.drag(end, end - QPoint(stage.x(4.0) - stage.x(3.0), 0), widget=stage.panel.ruler)
    assert stage.animation.end == pytest.approx(3.0, abs=1 / 30)
    assert stage.steps == ("Play range",)


def test_markers_are_dragged_and_named(stage: Stage) -> None:
    y = TIMES + MARKS // 2
    stage.drag(on_ruler(stage, 1.5, y), on_ruler(stage, 1.7, y), widget=stage.panel.ruler)
    assert stage.animation.markers[0].time == pytest.approx(1.7, abs=1 / 30)
    stage.settle()
    name = stage.panel.inspector.page.findChild(QLineEdit)
    name.selectAll()
    QTest.keyClicks(name, "Laugh")
    QTest.keyClick(name, Qt.Key.Key_Return)
    assert stage.animation.markers[0].name == "Laugh"


def test_a_double_click_on_the_marks_sets_one(stage: Stage) -> None:
    place = on_ruler(stage, 3.0, TIMES + MARKS // 2)
    stage.click(place, widget=stage.panel.ruler)
    QTest.mouseDClick(stage.panel.ruler, Qt.MouseButton.LeftButton, pos=place)
    assert [round(each.time, 1) for each in stage.animation.markers] == [1.5, 3.0]


def test_a_named_range_is_stretched_and_moved(stage: Stage) -> None:
    y = TIMES + MARKS // 2
    stage.drag(on_ruler(stage, 2.0, y), on_ruler(stage, 2.6, y), widget=stage.panel.ruler)
    (each,) = stage.animation.ranges
    assert (each.start, each.end) == (1.0, pytest.approx(2.6, abs=1 / 30))
    stage.drag(on_ruler(stage, 2.2, y), on_ruler(stage, 2.4, y), widget=stage.panel.ruler)
    (each,) = stage.animation.ranges
    assert each.start == pytest.approx(1.2, abs=1 / 15)


def test_the_band_stretches_what_is_chosen(stage: Stage) -> None:
    stage.click(stage.at("track 12L", 0.5))
    stage.click(stage.at("track 12L", 2.0), SHIFT)
    y = TIMES + MARKS + BAND // 2
    stage.drag(on_ruler(stage, 2.0, y), on_ruler(stage, 2.6, y), widget=stage.panel.ruler)
    assert stage.curve("12L").times.tolist()[:3] == pytest.approx([0.5, 1.0, 2.6], abs=0.04)
    assert stage.steps == ("Scale keys",)
    stage.drag(on_ruler(stage, 1.5, y), on_ruler(stage, 1.6, y), widget=stage.panel.ruler)
    assert stage.curve("12L").times[0] == pytest.approx(0.6, abs=0.04)


def head(stage: Stage, key: str) -> tuple[object, QRectF]:
    placed = stage.view.layout.of(key)
    assert placed is not None
    return placed.line, stage.panel.heads.area(placed)


@pytest.mark.parametrize(("place", "member"), [(0, "muted"), (1, "solo"), (2, "locked")])
def test_switches_are_clicked(stage: Stage, place: int, member: str) -> None:
    line, area = head(stage, "track 17")
    stage.click(switch_area(line, area, place, 3).center().toPoint(), widget=stage.panel.heads)
    track = stage.animation.track("17")
    assert getattr(track, member)
    assert len(stage.steps) == 1


def test_a_triangle_folds_a_group(stage: Stage) -> None:
    line, area = head(stage, "group Jaw")
    stage.click(fold_area(line, area).center().toPoint(), widget=stage.panel.heads)
    assert stage.view.layout.of("track 26") is None
    assert stage.steps == ()


def test_heads_are_chosen_one_by_one_and_in_a_row(stage: Stage) -> None:
    first, last = (head(stage, key)[1].topLeft().toPoint() + QPoint(60, 8) for key in ("track 12L", "track 12R"))
    stage.click(first, widget=stage.panel.heads)
    assert stage.timeline.state.lines == {"track 12L"}
    stage.click(last, SHIFT, stage.panel.heads)
    assert stage.timeline.state.lines == {"track 12L", "track 12R"}
    stage.click(head(stage, "track 12L")[1].topLeft().toPoint() + QPoint(60, 8), CTRL, stage.panel.heads)
    assert stage.timeline.state.lines == {"track 12R"}
    stage.key(Qt.Key.Key_Down, widget=stage.panel.heads)
    assert len(stage.timeline.state.lines) == 1


def test_tracks_are_made_higher_where_a_curve_is_to_be_read(stage: Stage) -> None:
    before = stage.view.layout.of("track 12L").height
    stage.wheel(stage.panel.heads, QPoint(40, 100), 4, CTRL)
    assert stage.view.layout.of("track 12L").height > 1.8 * before
    stage.wheel(stage.panel.heads, QPoint(40, 100), -40, CTRL)
    assert stage.view.layout.of("track 12L").height == 20


def test_a_dragged_value_is_a_key_under_the_playhead(stage: Stage) -> None:
    stage.timeline.playhead.go(3.5)
    line, area = head(stage, "track 17")
    place = value_area(line, area).center().toPoint()
    stage.drag(place, place - QPoint(60, 0), widget=stage.panel.heads)
    assert stage.curve("17").times[-1] == 3.5
    assert stage.curve("17").values[-1] == pytest.approx(0.2, abs=0.02)
    assert stage.steps == ("Key chin raiser",)


def test_a_typed_value_is_a_key_too(stage: Stage) -> None:
    stage.timeline.playhead.go(3.5)
    line, area = head(stage, "track head.yaw")
    QTest.mouseDClick(stage.panel.heads, Qt.MouseButton.LeftButton, pos=value_area(line, area).center().toPoint())
    editor = stage.panel.heads.findChild(NumberEdit)
    editor.selectAll()
    QTest.keyClicks(editor, "-5*4")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    assert stage.curve("head.yaw").values[-1] == -20.0
    assert stage.timeline.playhead.pose.rigid["head.yaw"] == -20.0


def test_the_filter_leaves_what_is_sought(stage: Stage) -> None:
    QTest.keyClicks(stage.panel.search, "chin")
    assert [line.key for line in stage.view.lines if line.kind == "track"] == ["track 17"]
    QTest.keyClick(stage.panel.search, Qt.Key.Key_Escape)
    assert len([line for line in stage.view.lines if line.kind == "track"]) == 6


def test_the_time_is_typed_dragged_and_written_otherwise(stage: Stage) -> None:
    field = stage.transport.time
    for text, time in (("45", 1.5), ("1.2s", 1.2), ("00:00:02:00", 2.0), ("+15", 2.5), ("-1s", 1.5)):
        QTest.mouseClick(field, Qt.MouseButton.LeftButton)
        editor = field.findChild(NumberEdit)
        editor.selectAll()
        QTest.keyClicks(editor, text)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        QApplication.processEvents()
        QTest.qWait(1)
        assert stage.timeline.playhead.time == pytest.approx(time)
    QTest.mouseClick(field, Qt.MouseButton.RightButton)
    assert field.text == "45"
    stage.drag(QPoint(20, 8), QPoint(40, 8), widget=field)
    assert stage.timeline.playhead.frame == 50


def test_a_rate_is_one_step(stage: Stage) -> None:
    menu = stage.transport.rate.menu()
    next(action for action in menu.actions() if action.text() == "24 fps").trigger()
    assert stage.animation.rate == 24.0
    assert stage.steps == ("24 frames per second",)
    stage.transport.rate.edit()
    editor = stage.transport.rate.findChild(NumberEdit)
    editor.selectAll()
    QTest.keyClicks(editor, "500")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    assert stage.animation.rate == 120.0


def test_labels_in_seconds_stand_on_tenths_and_others_on_frames() -> None:
    scale = TimeScale(0.0, 130.0)
    labels = {style: [tick.label for tick in ticks(scale, 400, 30.0, style) if tick.label] for style in STYLES}
    assert labels["seconds"][:3] == ["0.000 s", "1.000 s", "2.000 s"]
    assert labels["frames"][:3] == ["0", "20", "40"]
    assert [tick.label for tick in ticks(TimeScale(0.0, 500.0), 400, 30.0, "seconds") if tick.label][1] == "0.200 s"


def test_the_playhead_is_seen_wherever_it_goes(stage: Stage) -> None:
    stage.view.frame(0.0, 0.5)
    stage.key(Qt.Key.Key_Right, CTRL)
    stage.key(Qt.Key.Key_Right, CTRL)
    assert stage.timeline.playhead.time == 1.0
    assert 0 <= stage.x(1.0) <= stage.panel.ruler.width()


def test_what_is_seen_goes_along_with_a_hand_that_scrubs_over_the_edge(stage: Stage) -> None:
    stage.view.frame(0.0, 0.5)
    near = stage.view.scale.per_second
    ruler = stage.panel.ruler
    stage.drag(on_ruler(stage, 0.2, 8), QPoint(ruler.width() + 100, 8), widget=ruler)
    assert stage.timeline.playhead.time > 0.55
    assert stage.view.scale.per_second == near
    assert stage.x(stage.timeline.playhead.time) == pytest.approx(ruler.width(), abs=near / 30)
