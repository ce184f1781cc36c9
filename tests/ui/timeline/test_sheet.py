"""A mouse on the sheet: keys, events, sounds and regions are chosen, dragged, copied, restored."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from tests.ui.hands import move
from tests.ui.timeline.stage import ALT, CTRL, SHIFT, Stage


def test_a_click_chooses_a_key_and_one_beside_it_lets_go(stage: Stage) -> None:
    stage.click(stage.at("track 12L", 1.0))
    assert stage.timeline.chosen.keys == {("12L", 0): (1,)}
    stage.click(stage.at("track 17", 1.0), SHIFT)
    assert stage.timeline.chosen.key_count == 2
    stage.click(stage.at("track 12L", 1.0), CTRL)
    assert stage.timeline.chosen.keys == {("17", 0): (0,)}
    stage.click(stage.at("track 12L", 1.6))
    assert not stage.timeline.chosen
    assert stage.steps == ()


def test_a_drag_moves_everything_chosen_in_one_step(stage: Stage) -> None:
    stage.click(stage.at("track 12L", 1.0))
    stage.click(stage.at("track 17", 1.0), SHIFT)
    stage.drag(stage.at("track 17", 1.0), stage.at("track 17", 1.4))
    assert stage.curve("12L").times[1] == pytest.approx(1.4, abs=0.02)
    assert stage.curve("17").times[0] == stage.curve("12L").times[1]
    assert stage.steps == ("Move 2 keys",)
    stage.context.document.undo()
    assert stage.curve("12L").times.tolist() == [0.5, 1.0, 2.0, 3.0]


def test_a_key_that_is_not_chosen_is_dragged_alone(stage: Stage) -> None:
    stage.click(stage.at("track 17", 1.0))
    stage.drag(stage.at("track 12L", 1.0), stage.at("track 12L", 1.2))
    assert stage.curve("17").times[0] == 1.0
    assert stage.curve("12L").times[1] == pytest.approx(1.2, abs=0.02)


def test_escape_in_a_drag_puts_everything_back(stage: Stage) -> None:
    stage.drag(stage.at("track 12L", 1.0), stage.at("track 12L", 2.6), release=False)
    assert stage.curve("12L").times[1] != 1.0
    QTest.keyClick(stage.panel.sheet, Qt.Key.Key_Escape)
    assert stage.curve("12L").times.tolist() == [0.5, 1.0, 2.0, 3.0]
    assert stage.steps == ()
    QTest.mouseRelease(stage.panel.sheet, Qt.MouseButton.LeftButton, pos=stage.at("track 12L", 2.6))
    assert stage.steps == ()


def test_the_right_button_ends_a_drag_too(stage: Stage) -> None:
    stage.drag(stage.at("track 12L", 1.0), stage.at("track 12L", 2.6), release=False)
    asked: list[object] = []
    stage.panel.sheet.asked.connect(lambda *menu: asked.append(menu))
    stage.press_right(stage.at("track 12L", 2.6))
    assert stage.curve("12L").times.tolist() == [0.5, 1.0, 2.0, 3.0]
    assert not asked
    move(stage.panel.sheet, stage.at("track 12L", 1.6))
    QTest.mouseRelease(stage.panel.sheet, Qt.MouseButton.LeftButton, pos=stage.at("track 12L", 1.6))
    assert stage.steps == ()
    stage.press_right(stage.at("track 12L", 1.0))
    assert asked


def test_escape_on_a_key_that_is_held_and_not_yet_moved_lets_it_go_and_keeps_the_choice(stage: Stage) -> None:
    stage.click(stage.at("track 12L", 1.0))
    QTest.mousePress(stage.panel.sheet, Qt.MouseButton.LeftButton, pos=stage.at("track 12L", 1.0))
    QTest.keyClick(stage.panel.sheet, Qt.Key.Key_Escape)
    assert stage.timeline.chosen.keys == {("12L", 0): (1,)}
    move(stage.panel.sheet, stage.at("track 12L", 1.8))
    QTest.mouseRelease(stage.panel.sheet, Qt.MouseButton.LeftButton, pos=stage.at("track 12L", 1.8))
    assert stage.curve("12L").times.tolist() == [0.5, 1.0, 2.0, 3.0]
    QTest.keyClick(stage.panel.sheet, Qt.Key.Key_Escape)
    assert not stage.timeline.chosen


def test_undo_in_a_drag_puts_everything_back_and_takes_no_step(stage: Stage) -> None:
    stage.drag(stage.at("track 17", 1.0), stage.at("track 17", 1.4))
    steps, moved = stage.steps, stage.curve("17").times[0]
    stage.drag(stage.at("track 12L", 1.0), stage.at("track 12L", 2.6), release=False)
    stage.settle()
    QTest.keyClick(stage.panel.sheet, Qt.Key.Key_Z, CTRL)
    move(stage.panel.sheet, stage.at("track 12L", 1.6))
    QTest.mouseRelease(stage.panel.sheet, Qt.MouseButton.LeftButton, pos=stage.at("track 12L", 1.6))
    assert stage.curve("12L").times.tolist() == [0.5, 1.0, 2.0, 3.0]
    assert stage.curve("17").times[0] == moved > 1.0
    assert stage.steps == steps


def test_a_box_chooses_across_tracks(stage: Stage) -> None:
    first, last = stage.at("track 12L", 0.8, 0.1), stage.at("track 12R", 2.2, 0.9)
    top, foot = min(first.y(), last.y()), max(first.y(), last.y())
    stage.drag(QPoint(first.x(), top), QPoint(last.x(), foot))
    assert stage.timeline.chosen.keys == {("12L", 0): (1, 2), ("12R", 0): (0,)}
    assert stage.steps == ()


def test_alt_leaves_a_copy(stage: Stage) -> None:
    stage.drag(stage.at("track 12R", 1.0), stage.at("track 12R", 2.0), ALT)
    assert stage.curve("12R").times.tolist() == pytest.approx([1.0, 2.0], abs=0.02)


def test_a_sum_stands_for_all_keys_of_its_tracks(stage: Stage) -> None:
    stage.click(stage.at("group Lower face · diagonal", 1.0))
    assert stage.timeline.chosen.keys == {("12L", 0): (1,), ("12R", 0): (0,)}


def test_a_key_expression_is_dragged_with_its_keys(stage: Stage) -> None:
    stage.drag(stage.at("expressions", 1.0, 0.4), stage.at("expressions", 1.3, 0.4))
    (mark,) = stage.animation.expressions
    assert mark.time == pytest.approx(1.3, abs=0.02)
    assert stage.curve("17").times[0] == mark.time
    assert stage.steps == ("Move 4 keys",)


def test_a_double_click_on_a_curve_inserts_a_key(stage: Stage) -> None:
    place = stage.at("track 17", 2.0)
    stage.click(place)
    QTest.mouseDClick(stage.panel.sheet, Qt.MouseButton.LeftButton, pos=place)
    assert stage.curve("17").times.tolist() == pytest.approx([1.0, 2.0, 2.5], abs=0.02)
    assert stage.steps == ("Insert key",)


def test_a_clip_opens_at_a_double_click_and_its_bump_has_handles(stage: Stage) -> None:
    place = stage.at("lane 0", 0.8)
    stage.click(place)
    QTest.mouseDClick(stage.panel.sheet, Qt.MouseButton.LeftButton, pos=place)
    assert stage.timeline.chosen.events == {"smirk 1", "smirk 2"}
    key = "event Smirk 12L"
    stage.view.frame(0.2, 1.6)
    stage.settle()
    stage.click(stage.at(key, 0.7, 0.7))
    assert stage.timeline.chosen.events == {"smirk 1"}
    stage.drag(stage.at(key, 1.2, 0.87), stage.at(key, 1.4, 0.87))
    event = next(each for each in stage.animation.events if each.key == "smirk 1")
    assert event.ends == pytest.approx(1.4, abs=0.03)
    assert stage.steps[-1] == "Event offset"


def test_a_peak_follows_the_hand_up_and_along(stage: Stage) -> None:
    stage.timeline.change(flipped=frozenset(("clip Smirk",)))
    stage.view.frame(0.2, 1.6)
    stage.settle()
    key = "event Smirk 12L"
    stage.click(stage.at(key, 0.7, 0.7))
    event = next(each for each in stage.animation.events if each.key == "smirk 1")
    half = stage.at(key, event.start + event.peak, 0.5)
    stage.drag(half, half + QPoint(40, -14))
    moved = next(each for each in stage.animation.events if each.key == "smirk 1")
    assert moved.amplitude > event.amplitude + 0.2
    assert moved.peak > event.peak


def test_sounds_are_moved_and_their_bounds_dragged(stage: Stage) -> None:
    stage.view.frame(0.9, 2.0)
    stage.settle()
    stage.click(stage.at("speech", 1.7, 0.7))
    assert stage.timeline.chosen.sounds == {3}
    stage.drag(stage.at("speech", 1.3, 0.7), stage.at("speech", 1.25, 0.7))
    sounds = stage.animation.speech.phonemes
    assert sounds[1].end == pytest.approx(1.25, abs=0.01)
    assert sounds[2].start == sounds[1].end
    assert stage.steps == ("Move sound",)


def test_the_edge_of_a_region_sets_the_knots(stage: Stage) -> None:
    stage.drag(stage.at("layer 26 1", 1.4, 0.2), stage.at("layer 26 1", 0.9, 0.2))
    track = stage.animation.track("26")
    assert track is not None
    assert track.layers[0].spacing == pytest.approx(1.1 / 3.5, abs=0.03)


def test_the_sound_is_dragged_along(stage: Stage) -> None:
    stage.drag(stage.at("audio", 2.0), stage.at("audio", 2.5))
    assert stage.animation.audio is not None
    assert stage.animation.audio.start == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize(
    ("key", "held", "step"),
    [
        (Qt.Key.Key_Delete, Qt.KeyboardModifier.NoModifier, "Delete key"),
        (Qt.Key.Key_X, Qt.KeyboardModifier.NoModifier, "Delete key"),
        (Qt.Key.Key_D, CTRL, "Duplicate key"),
        (Qt.Key.Key_X, CTRL, "Delete key"),
        (Qt.Key.Key_M, Qt.KeyboardModifier.NoModifier, "Mirror key"),
        (Qt.Key.Key_Right, ALT, "Move key"),
    ],
)
def test_keys_of_the_keyboard_mean_what_is_chosen(stage: Stage, key, held, step: str) -> None:
    stage.click(stage.at("track 12L", 2.0))
    stage.key(key, held)
    assert stage.steps == (step,)


def test_copied_keys_are_pasted_under_the_playhead(stage: Stage) -> None:
    stage.click(stage.at("track 17", 1.0))
    stage.key(Qt.Key.Key_C, CTRL)
    stage.timeline.playhead.go(3.5)
    stage.key(Qt.Key.Key_V, CTRL)
    assert stage.curve("17").times.tolist() == [1.0, 2.5, 3.5]


def test_arrows_go_through_frames_and_keys(stage: Stage) -> None:
    stage.timeline.playhead.go(1.0)
    stage.key(Qt.Key.Key_Right)
    assert stage.timeline.playhead.time == pytest.approx(1.0 + 1 / 30)
    stage.key(Qt.Key.Key_Right, CTRL)
    assert stage.timeline.playhead.time == 2.0
    stage.key(Qt.Key.Key_K)
    assert stage.animation.expressions[-1].time == 2.0


def test_the_wheel_zooms_to_the_pointer_and_goes_along(stage: Stage) -> None:
    stage.window.resize(1200, 420)
    stage.settle()
    place = stage.at("track 12L", 1.0)
    before = stage.view.scale
    stage.wheel(stage.panel.sheet, place, 2)
    assert stage.view.scale.per_second == pytest.approx(1.44 * before.per_second)
    assert stage.view.scale.x(1.0) == pytest.approx(before.x(1.0), abs=1.0)
    stage.wheel(stage.panel.sheet, place, -1, CTRL)
    assert stage.view.scale.begin > before.begin
    stage.wheel(stage.panel.sheet, place, -2, SHIFT)
    assert stage.view.top > 0


def test_the_middle_button_pans_both_ways(stage: Stage) -> None:
    stage.window.resize(1200, 420)
    stage.settle()
    scale = stage.view.scale
    stage.pan(stage.panel.sheet, QPoint(300, 100), QPoint(240, 60))
    assert stage.view.scale.begin == pytest.approx(scale.begin + 60 / scale.per_second)
    assert stage.view.top == 40


def test_home_and_f_bring_things_into_view(stage: Stage) -> None:
    stage.click(stage.at("track 12L", 1.0))
    stage.click(stage.at("track 12L", 2.0), SHIFT)
    stage.key(Qt.Key.Key_F)
    assert stage.view.scale.time(stage.view.width / 2) == pytest.approx(1.5, abs=0.05)
    stage.key(Qt.Key.Key_Home)
    assert stage.view.scale.x(4.0) < stage.view.width


def test_every_line_is_drawn(stage: Stage) -> None:
    stage.timeline.change(flipped=frozenset(("clip Smirk", "clip twitch 1")))
    picture = stage.panel.sheet.grab().toImage()
    ground = picture.pixelColor(picture.width() - 2, picture.height() - 2)
    for line in stage.view.lines:
        place = stage.view.layout.of(line.key)
        assert place is not None
        rows = range(place.top + 2, min(place.bottom - 2, picture.height()))
        colours = {picture.pixelColor(x, y).rgb() for y in rows for x in range(4, picture.width() - 4, 3)}
        assert len(colours) > 2, (line.key, ground)
