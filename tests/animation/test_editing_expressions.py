"""Key expressions: set from what is shown, met, moved as a whole, over keyed and captured curves alike."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.clip import Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.editing import events, expressions, layers, marks, tracks
from facemodel.animation.evaluation import Evaluator
from facemodel.animation.event import Event
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track
from facemodel.facs import action_units
from tests.animation.strategies import CHANNELS
from tests.animation.strategies import animations as any_animations

UNITS = action_units()
SMILE = {"6L": 0.8, "6R": 0.8, "12L": 0.9, "12R": 0.9}
SURPRISE = {"1L": 1.0, "1R": 1.0, "26": 0.7}


def shown(animation: Animation, time: float) -> dict[str, float]:
    return {name: value for name, value in Evaluator(animation, UNITS).pose(time).weights.items() if value}


def test_three_key_expressions_are_each_met_and_what_came_later_rests_before() -> None:
    animation = expressions.with_expression(Animation(), 0.0, {}, "neutral", UNITS)
    animation = expressions.with_expression(animation, 1.0, SMILE, "smile", UNITS)
    animation = expressions.with_expression(animation, 2.0, SURPRISE, "surprise", UNITS)
    assert [each.name for each in animation.expressions] == ["neutral", "smile", "surprise"]
    for time, expected in ((0.0, {}), (1.0, SMILE), (2.0, SURPRISE)):
        assert shown(animation, time) == pytest.approx(expected)
    assert expressions.expression_weights(animation, 1.0)["12L"] == 0.9


def test_an_expression_set_anew_takes_the_place_of_the_old_one() -> None:
    animation = expressions.with_expression(Animation(), 1.0, SMILE, "smile", UNITS)
    animation = expressions.with_expression(animation, 1.0, {"12L": 0.3}, "smirk", UNITS)
    assert [each.name for each in animation.expressions] == ["smirk"]
    assert shown(animation, 1.0) == {"12L": 0.3}


def test_a_moved_expression_takes_all_its_keys_along() -> None:
    animation = expressions.with_expression(Animation(), 1.0, SMILE, "smile", UNITS)
    animation = expressions.with_expression(animation, 2.0, SURPRISE, "surprise", UNITS)
    moved = expressions.moved_expression(animation, 1.0, 3.0, UNITS)
    assert [(each.time, each.name) for each in moved.expressions] == [(2.0, "surprise"), (3.0, "smile")]
    assert shown(moved, 3.0) == pytest.approx(SMILE)
    gone = expressions.without_expression(moved, 3.0)
    assert [each.name for each in gone.expressions] == ["surprise"]
    assert expressions.expression_channels(gone, 3.0) == ()
    assert expressions.renamed_expression(gone, 2.0, "oh").expressions[0].name == "oh"


def test_a_captured_curve_is_taken_there_by_a_layer_and_keeps_its_samples() -> None:
    samples = Samples(np.linspace(0.2, 0.6, 120, dtype=np.float32), 30.0)
    animation = Animation((Track("12L", captured=samples),), end=4.0)
    made = expressions.with_expression(animation, 2.0, {"12L": 0.9}, "more", UNITS, spacing=0.2)
    track = made.track("12L")
    assert track is not None
    assert track.captured is samples
    assert [layer.spacing for layer in track.layers] == [0.2]
    assert shown(made, 2.0)["12L"] == pytest.approx(0.9, abs=1e-6)
    assert shown(made, 0.5) == shown(animation, 0.5)
    again = expressions.with_expression(made, 2.0, {"12L": 0.1}, "less", UNITS)
    assert shown(again, 2.0)["12L"] == pytest.approx(0.1, abs=1e-6)
    assert len(again.track("12L").layers) == 1  # type: ignore[union-attr]


def test_a_key_is_what_is_shown_less_what_events_add() -> None:
    bump = Event("a", ("12L",), 0.0, amplitude=0.3, peak=1.0, offset=2.0)
    animation = expressions.keyed(Animation(events=(bump,)), 1.0, {"12L": 0.8}, UNITS)
    assert shown(animation, 1.0)["12L"] == pytest.approx(0.8)
    assert animation.tracks[0].curve.values[0] == pytest.approx(0.5)


@given(
    any_animations(),
    st.floats(0, 10),
    st.dictionaries(st.sampled_from(CHANNELS[:8]), st.floats(0, 1), min_size=1),
)
def test_a_keyed_animation_shows_what_was_asked_of_unlocked_tracks(
    animation: Animation, time: float, wanted: dict[str, float]
) -> None:
    still = replace(
        animation,
        events=(),
        speech=replace(animation.speech, phonemes=()),
        idle=None,
        tracks=tuple(replace(track, muted=False, solo=False, locked=False) for track in animation.tracks),
    )
    for track in still.tracks:
        # A layer that is weighed down does not reach its keys; that is what its weight is for.
        still = tracks.with_track(still, replace(track, layers=tuple(replace(e, weight=1.0) for e in track.layers)))
    found = shown(expressions.keyed(still, time, wanted, UNITS), time)
    for name, value in wanted.items():
        assert found.get(name, 0.0) == pytest.approx(value, abs=2e-6)


def test_locked_tracks_get_no_key() -> None:
    animation = Animation((Track("12L", curve_of([Key(0, 0.1)]), locked=True),))
    assert expressions.keyed(animation, 1.0, {"12L": 0.9}, UNITS).tracks == animation.tracks


def test_layers_are_added_changed_and_removed() -> None:
    samples = Samples(np.full(60, 0.4, dtype=np.float32), 30.0)
    animation = Animation((layers.with_layer(Track("12L", captured=samples), 0.3, "a"),))
    made = layers.with_layer_changed(animation, "12L", 1, spacing=0.5, weight=0.7, muted=True, name="b")
    layer = made.tracks[0].layers[0]
    assert (layer.spacing, layer.weight, layer.muted, layer.name) == (0.5, 0.7, True, "b")
    assert layers.with_layer_changed(made, "12L", 1, spacing=0.0).tracks[0].layers[0].spacing == layers.CLOSEST
    assert layers.without_layer(made, "12L", 1).tracks[0].layers == ()
    assert layers.with_layer_changed(made, "12L", 2, muted=False) is made
    locked = tracks.flagged(made, ["12L"], locked=True)
    assert layers.without_layer(locked, "12L", 1) is locked


def test_tracks_are_ordered_flagged_grouped_and_removed() -> None:
    animation = Animation((Track("12L"), Track("12R"), Track("17")))
    assert [t.channel for t in tracks.moved_track(animation, "17", 0).tracks] == ["17", "12L", "12R"]
    made = tracks.flagged(animation, ["12L", "12R"], muted=True, group="mouth")
    assert [(t.muted, t.group) for t in made.tracks] == [(True, "mouth"), (True, "mouth"), (False, "")]
    assert made.tracks[2] is animation.tracks[2]
    locked = tracks.flagged(made, ["12R"], locked=True)
    assert [t.channel for t in tracks.without_tracks(locked, ["12L", "12R"]).tracks] == ["12R", "17"]


def test_events_are_placed_moved_stretched_and_shaped_by_their_handles() -> None:
    animation, key = events.with_event(Animation(), ("12L", "12R"), 1.0)
    (event,) = animation.events
    moved = events.moved_events(animation, [key], 0.5).events[0]
    assert moved == replace(event, start=1.5)
    longer = events.stretched_events(animation, [key], 1.0, 2.0).events[0]
    assert longer.ends - longer.begins == pytest.approx(2 * (event.ends - event.begins))
    assert events.with_rise(event, 1.1).full[0] == pytest.approx(1.1)
    assert events.with_fall(event, 1.6).full[1] == pytest.approx(1.6)
    assert events.with_rise(event, 9.9).acceleration == 1.0
    late = events.changed_events(animation, [key], lambda each: replace(each, onset=0.6)).events[0]
    assert late.onset <= late.peak <= late.offset
    assert events.without_events(animation, [key]).events == ()


def test_marks_and_ranges_are_kept_in_order_and_one_of_a_kind() -> None:
    animation = marks.with_marker(marks.with_marker(Animation(), 2.0, "b"), 1.0, "a")
    animation = marks.with_marker(animation, 2.0, "c")
    assert [(m.time, m.name) for m in animation.markers] == [(1.0, "a"), (2.0, "c")]
    assert [m.time for m in marks.moved_marker(animation, 1.0, 3.0).markers] == [2.0, 3.0]
    assert marks.without_marker(animation, 1.0).markers[0].name == "c"
    ranged = marks.with_range(marks.with_range(animation, "smile", 3.0, 1.0), "smile", 0.0, 2.0)
    assert [(r.name, r.start, r.end) for r in ranged.ranges] == [("smile", 0.0, 2.0)]
    assert marks.with_range(ranged, "nothing", 1.0, 1.0) is ranged
    assert marks.without_range(ranged, "smile").ranges == ()
    assert marks.with_rate(animation, 500).rate == 120
    assert marks.played(animation, 3.0, 1.0).duration == 2.0
    assert marks.played(animation, 1.0, 1.0).duration == pytest.approx(1 / 30)
