"""Buttons and menus of the dock, by hand: mute and solo, the band, ranges, snapping, rates, groups."""

import time
from collections.abc import Callable

import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QInputDialog, QLineEdit, QMenu, QPushButton, QWidget

from facemodel.animation.clip import FASTEST, SLOWEST
from tests.ui.timeline.stage import CTRL, LEFT, SHIFT, Stage
from ui.timeline.paint.heads import switch_area
from ui.timeline.paint.ruler import BAND, MARKS, TIMES
from ui.widgets.number_edit import NumberEdit

PATIENCE = 60.0
"""Seconds after which no menu opens any more."""

MUTE, SOLO = 0, 1
"""Places of switches at the right of a head."""


def switch(stage: Stage, line: str, place: int) -> None:
    placed = stage.view.layout.of(line)
    area = switch_area(placed.line, stage.panel.heads.area(placed), place, 3)
    stage.click(area.center().toPoint(), widget=stage.panel.heads)


def on_band(stage: Stage, time: float) -> QPoint:
    return QPoint(stage.x(time), TIMES + MARKS + BAND // 2)


def head_of(stage: Stage, line: str) -> QPoint:
    return stage.panel.heads.area(stage.view.layout.of(line)).topLeft().toPoint() + QPoint(60, 8)


def choose_from_menu(open_menu: Callable[[], None], title: str) -> None:
    """Open a menu and click an entry of it, also where opening waits for the menu to close."""
    clicked: list[bool] = []

    def click() -> None:
        menu = QApplication.activePopupWidget()
        if not isinstance(menu, QMenu):
            return
        timer.stop()
        entry = next(action for action in menu.actions() if action.text() == title)
        QTest.mouseClick(menu, LEFT, Qt.KeyboardModifier.NoModifier, menu.actionGeometry(entry).center())
        clicked.append(True)
        menu.close()

    timer = QTimer()
    timer.timeout.connect(click)
    timer.start(10)
    open_menu()
    end = time.monotonic() + PATIENCE
    while not clicked:
        assert time.monotonic() < end, f"No menu with {title} opened."
        QTest.qWait(5)


def push(widget: QWidget) -> None:
    QTest.mouseClick(widget, LEFT)


def test_a_muted_track_is_still_and_comes_back(stage: Stage) -> None:
    stage.timeline.playhead.go(2.0)
    moved = stage.context.document.shown["12L"]
    switch(stage, "track 12L", MUTE)
    assert stage.context.document.shown.get("12L", 0.0) < moved - 0.1
    switch(stage, "track 12L", MUTE)
    assert stage.context.document.shown["12L"] == moved
    assert stage.steps == ("Mute Lip corner puller", "Unmute Lip corner puller")


def test_a_solo_track_moves_alone(stage: Stage) -> None:
    stage.timeline.playhead.go(2.0)
    alone = stage.context.document.shown["17"]
    assert alone > 0
    switch(stage, "track 17", SOLO)
    shown = stage.context.document.shown
    assert shown["17"] == pytest.approx(alone)
    assert stage.animation.track("12L").solo is False
    at_rest = stage.context.document.shown.get("12L", 0.0)
    switch(stage, "track 17", SOLO)
    assert stage.context.document.shown["12L"] > at_rest


def test_a_switch_of_one_of_several_chosen_tracks_is_that_of_all(stage: Stage) -> None:
    stage.click(head_of(stage, "track 12L"), widget=stage.panel.heads)
    stage.click(head_of(stage, "track 12R"), SHIFT, stage.panel.heads)
    switch(stage, "track 12R", MUTE)
    assert stage.animation.track("12L").muted
    assert stage.animation.track("12R").muted
    assert len(stage.steps) == 1


def test_the_left_end_of_the_band_stretches_about_the_right_one_and_escape_restores(stage: Stage) -> None:
    stage.click(stage.at("track 12L", 1.0))
    stage.click(stage.at("track 12L", 2.0), SHIFT)
    stage.drag(on_band(stage, 1.0), on_band(stage, 1.4), widget=stage.panel.ruler, release=False)
    assert stage.curve("12L").times.tolist() == pytest.approx([0.5, 1.4, 2.0, 3.0], abs=0.02)
    QTest.keyClick(stage.panel.ruler, Qt.Key.Key_Escape)
    assert stage.curve("12L").times.tolist() == [0.5, 1.0, 2.0, 3.0]
    QTest.mouseRelease(stage.panel.ruler, LEFT, pos=on_band(stage, 1.4))
    assert stage.steps == ()


def test_the_band_with_shift_stretches_about_the_playhead(stage: Stage) -> None:
    stage.timeline.playhead.go(0.0)
    stage.click(stage.at("track 12L", 1.0))
    stage.click(stage.at("track 12L", 2.0), SHIFT)
    stage.drag(on_band(stage, 2.0), on_band(stage, 2.8), SHIFT, stage.panel.ruler)
    assert stage.curve("12L").times[1:3].tolist() == pytest.approx([1.4, 2.8], abs=0.03)


def test_a_named_range_is_played_by_its_button(stage: Stage) -> None:
    (each,) = stage.animation.ranges
    stage.click(QPoint(stage.x(0.75 * each.start + 0.25 * each.end), TIMES + MARKS // 2), widget=stage.panel.ruler)
    assert stage.timeline.chosen.ranges == {each.name}
    stage.settle()
    button = next(b for b in stage.panel.inspector.page.findChildren(QPushButton) if "Play" in b.text())
    push(button)
    assert (stage.animation.start, stage.animation.end) == (each.start, each.end)
    assert stage.steps == ("Play range",)
    head = stage.timeline.playhead
    assert head.playing
    assert each.start <= head.time <= each.end
    head.pause()


def test_snapping_is_chosen_from_its_menu(stage: Stage) -> None:
    snap = stage.transport.snap
    choose_from_menu(lambda: push(snap), "Frames")
    assert stage.timeline.state.snaps == frozenset()
    stage.drag(stage.at("track 17", 1.0), stage.at("track 17", 1.0) + QPoint(37, 0))
    free = float(stage.curve("17").times[0])
    assert free * 30 != pytest.approx(round(free * 30), abs=1e-6)
    choose_from_menu(lambda: push(snap), "Keys")
    stage.drag(stage.at("track 17", free), stage.at("track 17", 2.0) + QPoint(4, 0))
    assert stage.curve("17").times[0] == 2.0
    choose_from_menu(lambda: push(snap), "Keys")
    choose_from_menu(lambda: push(snap), "Markers and ranges")
    stage.drag(stage.at("track 17", 2.0), stage.at("track 17", 1.5) + QPoint(4, 0))
    assert stage.curve("17").times[0] == 1.5
    assert snap.menu().actions()[2].isChecked()


@pytest.mark.parametrize("rate", [12, 24, 60, 120])
def test_a_rate_is_chosen_from_its_menu_and_keys_stay_where_they_are(stage: Stage, rate: int) -> None:
    times = stage.curve("12L").times.tolist()
    choose_from_menu(lambda: push(stage.transport.rate), f"{rate} fps")
    assert stage.animation.rate == rate
    assert stage.transport.rate.text == f"{rate} fps"
    assert stage.curve("12L").times.tolist() == times
    assert stage.steps == (f"{rate} frames per second",)


@pytest.mark.parametrize(("typed", "kept"), [("11", SLOWEST), ("29.97", 29.97), ("1000", FASTEST)])
def test_another_rate_is_typed_within_what_is_possible(stage: Stage, typed: str, kept: float) -> None:
    choose_from_menu(lambda: push(stage.transport.rate), "Another rate…")
    editor = stage.transport.rate.findChild(NumberEdit)
    editor.selectAll()
    QTest.keyClicks(editor, typed)
    QTest.keyClick(editor, Qt.Key.Key_Return)
    assert stage.animation.rate == kept


def group_box(stage: Stage) -> QComboBox:
    stage.settle()
    return stage.panel.inspector.page.findChild(QComboBox)


def pick(box: QComboBox, title: str) -> None:
    """Choose an entry by the keyboard."""
    box.setFocus()
    steps = box.findText(title) - box.currentIndex()
    for _ in range(abs(steps)):
        QTest.keyClick(box, Qt.Key.Key_Down if steps > 0 else Qt.Key.Key_Up)


def test_tracks_are_put_into_a_group_of_ones_own_and_back(stage: Stage) -> None:
    stage.click(head_of(stage, "track 12L"), widget=stage.panel.heads)
    stage.click(head_of(stage, "track 17"), CTRL, stage.panel.heads)

    def name() -> None:
        asked = QApplication.activeModalWidget()
        if isinstance(asked, QInputDialog):
            timer.stop()
            QTest.keyClicks(asked.findChild(QLineEdit), "Smirk")
            QTest.keyClick(asked, Qt.Key.Key_Return)

    timer = QTimer()
    timer.timeout.connect(name)
    timer.start(10)
    pick(group_box(stage), "New group…")
    timer.stop()
    assert [track.channel for track in stage.animation.tracks if track.group == "Smirk"] == ["12L", "17"]
    assert stage.steps == ("Group tracks",)
    (line,) = (each for each in stage.view.lines if each.key == "group Smirk")
    assert set(line.members) == {"12L", "17"}
    pick(group_box(stage), "Group of the face")
    assert not any(track.group for track in stage.animation.tracks)


def test_a_filter_opens_groups_and_finds_them_by_name(stage: Stage) -> None:
    stage.timeline.change(flipped=frozenset(("group Jaw",)))
    assert stage.view.layout.of("track 26") is None
    QTest.keyClicks(stage.panel.search, "jaw")
    assert [line.key for line in stage.view.lines if line.kind == "track"] == ["track 26"]
    QTest.keyClick(stage.panel.search, Qt.Key.Key_Escape)
    assert stage.view.layout.of("track 26") is None


@pytest.mark.parametrize("right", [False, True], ids=["esc", "right button"])
def test_a_drag_through_time_is_taken_back(stage: Stage, right: bool) -> None:
    field, style = stage.transport.time, stage.timeline.state.style
    stage.timeline.playhead.go(1.0)
    middle = field.rect().center()
    stage.drag(middle, middle + QPoint(40, 0), widget=field, release=False)
    assert stage.timeline.playhead.time > 1.0
    assert stage.window.focusWidget() is field
    if right:
        QTest.mouseClick(field, Qt.MouseButton.RightButton)
    else:
        QTest.keyClick(field, Qt.Key.Key_Escape)
    QTest.mouseRelease(field, LEFT)
    assert stage.timeline.playhead.time == 1.0
    assert stage.timeline.state.style == style
