"""A hand on the timeline: one gesture is one step, Esc leaves no trace, and undo restores what was."""

from collections.abc import Callable
from itertools import pairwise

import pytest

from app.document import Document
from app.timeline.chosen import Chosen
from app.timeline.gestures import Gesture, Spot
from app.timeline.gestures.box import Box, ChooseInBox
from app.timeline.gestures.chosen_things import MoveChosen, ScaleChosen
from app.timeline.gestures.events import DragEvent
from app.timeline.gestures.handles import DragHandle, DragSpacing
from app.timeline.gestures.sound import MoveSound
from app.timeline.gestures.speech import DragBound
from app.timeline.gestures.time import DragPlayed, DragRange, Scrub
from app.timeline.gestures.values import DragValue
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from facemodel.animation.editing.selection import curve_of_row
from facemodel.sameness import same

KEY = Chosen({("12L", 0): (1,)})
TWO = Chosen({("12L", 0): (1, 2), ("17", 0): (0,)})

GESTURES: dict[str, Callable[[Timeline], Gesture]] = {
    "a key": lambda t: (t.choose(KEY), MoveChosen(t, 1.0, Spot(1.0)))[1],
    "several keys": lambda t: (t.choose(TWO), MoveChosen(t, 1.0, Spot(1.0), rises=True))[1],
    "copies": lambda t: (t.choose(TWO), MoveChosen(t, 1.0, Spot(1.0), copies=True))[1],
    "an expression": lambda t: (t.choose(Chosen(expressions=frozenset((1.0,)))), MoveChosen(t, 1.0, Spot(1.0)))[1],
    "events": lambda t: (t.choose(Chosen(events=frozenset(("smirk 1",)))), MoveChosen(t, 0.4, Spot(0.4)))[1],
    "sounds": lambda t: (t.choose(Chosen(sounds=frozenset((3,)))), MoveChosen(t, 1.6, Spot(1.6)))[1],
    "a marker": lambda t: (t.choose(Chosen(markers=frozenset((1.5,)))), MoveChosen(t, 1.5, Spot(1.5)))[1],
    "a range": lambda t: (t.choose(Chosen(ranges=frozenset(("Line",)))), MoveChosen(t, 1.0, Spot(1.0)))[1],
    "scaled keys": lambda t: (t.choose(TWO), ScaleChosen(t, 2.0, 1.0))[1],
    "played": lambda t: DragPlayed(t, "end", Spot(4.0)),
    "all that is played": lambda t: DragPlayed(t, "both", Spot(1.0)),
    "the end of a range": lambda t: DragRange(t, "Line", "end", Spot(2.0)),
    "an onset": lambda t: DragEvent(t, "smirk 1", "onset", Spot(0.4)),
    "a rise": lambda t: DragEvent(t, "smirk 1", "rise", Spot(0.5)),
    "a peak": lambda t: DragEvent(t, "smirk 1", "peak", Spot(0.7, 0.5)),
    "a fall": lambda t: DragEvent(t, "smirk 1", "fall", Spot(0.9)),
    "an offset": lambda t: DragEvent(t, "smirk 1", "offset", Spot(1.2)),
    "a bound": lambda t: DragBound(t, 1, True, Spot(1.3)),
    "a handle": lambda t: DragHandle(t, ("12L", 0), 1, True),
    "knots": lambda t: DragSpacing(t, "26", 1, 2.0),
    "the sound": lambda t: MoveSound(t, Spot(0.5)),
    "a value": lambda t: DragValue(t, "17", Spot(0.0, x=0.0)),
}
"""What each gesture takes hold of."""

AWAY = Spot(2.31, 0.44, x=60.0, y=30.0)


@pytest.fixture(params=GESTURES)
def begin(request: pytest.FixtureRequest) -> Callable[[Timeline], Gesture]:
    return GESTURES[request.param]


def test_a_gesture_is_one_step_that_undo_takes_back(timeline: Timeline, document: Document, begin) -> None:
    before = document.project
    gesture = begin(timeline)
    for part in (0.2, 0.5, 0.8):
        gesture.move(Spot(part * AWAY.time, part * AWAY.value, x=part * AWAY.x))
    gesture.release(AWAY)
    assert len(document.history.done) == 1
    assert document.project.animation is not before.animation
    assert gesture.advice
    document.undo()
    assert same(document.project.animation, before.animation)


def test_escape_leaves_no_trace(timeline: Timeline, document: Document, begin) -> None:
    before = document.project
    gesture = begin(timeline)
    chosen = timeline.chosen
    gesture.move(AWAY)
    gesture.move(Spot(0.1, 0.9, x=-40.0))
    gesture.cancel()
    assert document.history.done == ()
    assert same(document.project.animation, before.animation)
    assert timeline.chosen == chosen


def times(timeline: Timeline, channel: str, layer: int = 0) -> list[float]:
    return curve_of_row(timeline.animation, (channel, layer)).times.tolist()


def test_keys_land_on_frames_and_ctrl_lets_them_float(timeline: Timeline) -> None:
    timeline.choose(KEY)
    gesture = MoveChosen(timeline, 1.0, Spot(1.0))
    gesture.move(Spot(1.311))
    assert times(timeline, "12L")[1] == pytest.approx(39 / 30)
    gesture.move(Spot(1.311, control=True))
    assert times(timeline, "12L")[1] == pytest.approx(1.311)


def test_a_key_that_lands_on_another_takes_its_place(timeline: Timeline) -> None:
    timeline.choose(KEY)
    MoveChosen(timeline, 1.0, Spot(1.0)).release(Spot(2.0))
    assert times(timeline, "12L") == [0.5, 2.0, 3.0]
    assert curve_of_row(timeline.animation, ("12L", 0)).values[1] == pytest.approx(0.8)
    assert timeline.chosen.keys == {("12L", 0): (1,)}


def test_copies_leave_what_was_where_it_was(timeline: Timeline) -> None:
    timeline.choose(KEY)
    MoveChosen(timeline, 1.0, Spot(1.0), copies=True).release(Spot(1.5))
    assert times(timeline, "12L") == [0.5, 1.0, 1.5, 2.0, 3.0]
    assert timeline.chosen.keys == {("12L", 0): (2,)}


def test_a_key_expression_goes_with_the_last_of_its_keys_that_is_not_locked(timeline: Timeline) -> None:
    keys = {("12L", 0): (1,), ("12R", 0): (0,), ("17", 0): (0,)}
    timeline.choose(Chosen(keys))
    MoveChosen(timeline, 1.0, Spot(1.0)).release(Spot(1.2))
    assert [round(each.time, 6) for each in timeline.animation.expressions] == [1.0]
    timeline.document.undo()
    timeline.choose(Chosen({**keys, ("head.yaw", 0): (1,)}))
    MoveChosen(timeline, 1.0, Spot(1.0)).release(Spot(1.2))
    assert [round(each.time, 6) for each in timeline.animation.expressions] == [1.2]


def test_a_locked_track_stays(timeline: Timeline) -> None:
    timeline.choose(Chosen({("20L", 0): (0,), ("17", 0): (0,)}))
    MoveChosen(timeline, 1.0, Spot(1.0)).release(Spot(1.5))
    assert times(timeline, "20L") == [1.0, 2.0]
    assert times(timeline, "17")[0] == 1.5


def test_scaling_keeps_the_far_end_and_shift_the_playhead(timeline: Timeline) -> None:
    timeline.choose(Chosen({("12L", 0): (0, 1, 2)}))
    gesture = ScaleChosen(timeline, 2.0, 0.5)
    gesture.move(Spot(3.5))
    assert times(timeline, "12L")[:2] == pytest.approx([0.5, 1.5])
    timeline.playhead.go(1.0)
    gesture.move(Spot(3.0, shift=True))
    assert times(timeline, "12L")[:2] == pytest.approx([0.0, 1.0])


def test_shift_keeps_to_one_direction(timeline: Timeline) -> None:
    timeline.choose(KEY)
    gesture = MoveChosen(timeline, 1.0, Spot(1.0, 0.8, 0.05, 0.05), rises=True)
    gesture.move(Spot(1.1, 0.5, 0.05, 0.05, shift=True))
    assert times(timeline, "12L")[1] == 1.0
    assert curve_of_row(timeline.animation, ("12L", 0)).values[1] == pytest.approx(0.5)


def test_things_are_drawn_to_markers_and_keys(timeline: Timeline) -> None:
    timeline.change(snaps=frozenset(("keys", "markers")))
    timeline.choose(KEY)
    gesture = MoveChosen(timeline, 1.0, Spot(1.0))
    gesture.move(Spot(1.46, reach=0.05))
    assert times(timeline, "12L")[1] == 1.5
    gesture.move(Spot(2.47, reach=0.05))
    assert 2.5 in times(timeline, "12L")
    gesture.move(Spot(2.73, reach=0.001))
    assert 2.73 in [round(time, 6) for time in times(timeline, "12L")]


def test_the_handles_of_a_bump_are_its_parameters(timeline: Timeline) -> None:
    def event():
        return next(each for each in timeline.animation.events if each.key == "smirk 1")

    DragEvent(timeline, "smirk 1", "peak", Spot(0.7, 0.5)).release(Spot(0.8, 0.9))
    assert (event().peak, event().amplitude) == (pytest.approx(0.4), pytest.approx(0.9))
    DragEvent(timeline, "smirk 1", "offset", Spot(1.2)).release(Spot(1.4))
    assert event().ends == pytest.approx(1.4)
    rises, _ = event().full
    DragEvent(timeline, "smirk 1", "rise", Spot((event().begins + rises) / 2)).release(Spot(0.5))
    assert event().full[0] == pytest.approx(0.6)
    _, falls = event().full
    DragEvent(timeline, "smirk 1", "fall", Spot((event().ends + falls) / 2)).release(Spot(1.25))
    assert event().full[1] == pytest.approx(1.1)
    DragEvent(timeline, "smirk 1", "onset", Spot(0.4)).release(Spot(0.5))
    assert event().begins == pytest.approx(0.5)


def test_a_head_is_turned_the_other_way_by_a_peak_below_zero(timeline: Timeline) -> None:
    DragEvent(timeline, "smirk 2", "peak", Spot(0.7, -3.0)).release(Spot(0.7, 400.0))
    assert next(each for each in timeline.animation.events if each.key == "smirk 2").amplitude == 50.0


def test_a_sound_pushes_no_neighbour_away(timeline: Timeline) -> None:
    timeline.choose(Chosen(sounds=frozenset((1,))))
    MoveChosen(timeline, 1.1, Spot(1.1)).release(Spot(9.0))
    sounds = timeline.animation.speech.phonemes
    assert [each.symbol for each in sounds] == ["M", "AA", "P", "AA"]
    assert all(one.end <= other.start + 1e-9 for one, other in pairwise(sounds))
    assert all(each.end > each.start for each in sounds)


def test_the_region_of_a_layer_is_as_wide_as_the_hand_is_away(timeline: Timeline) -> None:
    DragSpacing(timeline, "26", 1, 2.0).release(Spot(3.4))
    track = timeline.animation.track("26")
    assert track is not None
    assert track.layers[0].spacing == pytest.approx(0.4)


def test_alt_breaks_the_handles_of_a_key_apart(timeline: Timeline) -> None:
    gesture = DragHandle(timeline, ("12L", 0), 1, True)
    gesture.move(Spot(1.3, 0.5))
    curve = curve_of_row(timeline.animation, ("12L", 0))
    assert curve.handles[1, 2:] == pytest.approx([0.3, -0.3])
    assert not curve.broken[1]
    gesture.move(Spot(1.3, 0.5, alt=True))
    assert curve_of_row(timeline.animation, ("12L", 0)).broken[1]
    gesture.move(Spot(1.3, 0.5, shift=True))
    assert curve_of_row(timeline.animation, ("12L", 0)).handles[1, 3] == 0.0


def test_scrubbing_makes_no_step_and_escape_goes_back(timeline: Timeline, document: Document) -> None:
    timeline.playhead.go(0.5)
    gesture = Scrub(timeline, Spot(1.02))
    assert timeline.playhead.time == pytest.approx(31 / 30)
    gesture.move(Spot(1.517, control=True))
    assert timeline.playhead.time == pytest.approx(1.517)
    gesture.cancel()
    assert timeline.playhead.time == 0.5
    assert document.history.done == ()


def test_a_value_that_is_dragged_is_a_key_under_the_playhead(timeline: Timeline) -> None:
    timeline.playhead.go(2.0)
    DragValue(timeline, "17", Spot(0.0, x=0.0)).release(Spot(0.0, x=20.0))
    assert times(timeline, "17") == [1.0, 2.0, 2.5]
    assert timeline.document.shown["17"] == pytest.approx(0.48, abs=0.12)


def test_a_box_chooses_adds_and_takes_out(timeline: Timeline) -> None:
    boxes: list[Box | None] = []
    gesture = ChooseInBox(timeline, Spot(0.0, x=10, y=20), lambda _box: KEY, boxes.append)
    gesture.move(Spot(1.0, x=0, y=40))
    assert boxes[-1] == (0, 20, 10, 40)
    assert timeline.chosen == KEY
    timeline.choose(TWO)
    ChooseInBox(timeline, Spot(0.0), lambda _box: KEY, boxes.append).release(Spot(1.0, control=True))
    assert timeline.chosen.keys == {("12L", 0): (2,), ("17", 0): (0,)}
    other = ChooseInBox(timeline, Spot(0.0), lambda _box: KEY, boxes.append)
    other.move(Spot(1.0, shift=True))
    assert timeline.chosen.keys == TWO.keys
    other.move(Spot(1.0))
    other.cancel()
    assert timeline.chosen.keys == {("12L", 0): (2,), ("17", 0): (0,)}
    assert boxes[-1] is None


def test_a_gesture_is_over_once_the_animation_is_changed_by_something_else(
    timeline: Timeline, document: Document, begin
) -> None:
    gesture = begin(timeline)
    gesture.move(AWAY)
    timeline.edit(Animation(), "Empty it")
    gesture.move(Spot(1.9, 0.2, x=20.0, y=10.0))
    gesture.release(AWAY)
    assert same(timeline.animation, Animation())
    assert document.history.done[-1] == "Empty it"
