"""Keys from what is seen, and everything that is done to chosen things."""

from dataclasses import replace

import numpy as np
import pytest

from app.document import Document
from app.timeline import deeds, keying, layers
from app.timeline.chosen import Chosen
from app.timeline.readings import (
    handle_of_key,
    length_of_events,
    of_event,
    start_of,
    strength_of_events,
    value_of_keys,
    with_event,
    with_handle_of_key,
    with_length_of_events,
    with_start,
    with_strength_of_events,
    with_value_of_keys,
)
from app.timeline.snapping import FREE, snapping
from app.timeline.timeline import Timeline
from app.timeline.values import key_value, value_text
from app.timeline.whole import OPERATIONS, target_of
from facemodel.animation.editing.dense import own_values
from facemodel.animation.editing.selection import curve_of_row
from facemodel.animation.library import find_expression

ALL = np.linspace(0.0, 4.0, 241)


def values(timeline: Timeline, channel: str) -> np.ndarray:
    track = timeline.animation.track(channel)
    assert track is not None
    return own_values(track, ALL)


def test_a_key_expression_holds_what_is_seen(timeline: Timeline, document: Document) -> None:
    timeline.playhead.go(3.0)
    document.preview({"17": 0.9})
    keying.key_expression(timeline)
    assert [each.time for each in timeline.animation.expressions] == [1.0, 3.0]
    assert timeline.animation.track("17").curve.near(3.0) is not None
    assert document.shown["17"] == pytest.approx(0.9)
    assert timeline.chosen.expressions == {3.0}
    timeline.playhead.go(0.0)
    timeline.playhead.go(3.0)
    assert document.shown["17"] == pytest.approx(0.9)


def test_what_is_keyed_already_is_no_step(timeline: Timeline, document: Document) -> None:
    keying.key_expression(timeline)
    steps = document.history.done
    keying.key_expression(timeline)
    assert document.history.done == steps


def test_keys_are_set_on_whole_frames(timeline: Timeline) -> None:
    timeline.playhead.go(1.016)
    keying.key_channels(timeline, ["17"])
    assert timeline.animation.track("17").curve.near(1.0) is not None
    assert len(timeline.animation.track("17").curve) == 2
    timeline.change(snaps=frozenset())
    timeline.playhead.go(1.216)
    keying.key_channels(timeline, ["17"])
    assert timeline.animation.track("17").curve.near(1.216) is not None


def test_only_the_chosen_tracks_are_keyed(timeline: Timeline) -> None:
    timeline.change(lines=frozenset(("track 17", "track 12R")))
    timeline.playhead.go(3.5)
    keying.key_channels(timeline, keying.chosen_channels(timeline))
    keyed = {track.channel for track in timeline.animation.tracks if track.curve.near(3.5) is not None}
    assert keyed == {"17", "12R"}


def test_an_inserted_key_changes_nothing_that_is_seen(timeline: Timeline) -> None:
    before = values(timeline, "12L")
    keying.insert_key(timeline, "12L", 2.5)
    assert len(timeline.animation.track("12L").curve) == 5
    assert np.abs(values(timeline, "12L") - before).max() < 0.03


def test_one_goes_from_key_to_key_of_the_chosen_tracks_or_of_all(timeline: Timeline) -> None:
    timeline.playhead.go(0.0)
    stops = []
    for _ in range(4):
        keying.go_to_key(timeline, 1)
        stops.append(timeline.playhead.time)
    assert stops == [0.5, 1.0, 2.0, 2.5]
    timeline.change(lines=frozenset(("track 17",)))
    keying.go_to_key(timeline, -1)
    assert timeline.playhead.time == 1.0
    keying.go_to_key(timeline, -1)
    assert timeline.playhead.time == 1.0


def test_a_typed_value_is_a_key_within_the_range(timeline: Timeline) -> None:
    timeline.playhead.go(2.0)
    key_value(timeline, "17", 99.0)
    assert timeline.document.shown["17"] == 2.0
    key_value(timeline, "head.yaw", -33.0)
    assert value_text(timeline, "head.yaw") == "-33.0°"


def test_a_captured_curve_is_keyed_in_its_layer(timeline: Timeline) -> None:
    timeline.playhead.go(3.0)
    before = timeline.animation.track("26").captured
    key_value(timeline, "26", 0.1)
    assert timeline.document.shown["26"] == pytest.approx(0.1, abs=1e-6)
    assert timeline.animation.track("26").captured is before
    assert len(timeline.animation.track("26").layers[0].keys) == 2


def test_layers_are_added_baked_and_removed(timeline: Timeline) -> None:
    before = values(timeline, "26")
    layers.add_layer(timeline, "26")
    assert timeline.state.lines == {"layer 26 2"}
    layers.remove_layer(timeline, "26", 2)
    layers.bake_layers(timeline, ["26"])
    assert timeline.animation.track("26").layers == ()
    assert np.abs(values(timeline, "26") - before).max() < 0.02
    assert layers.layered_channels(timeline) == ()


def test_deleting_takes_keys_or_else_the_chosen_tracks(timeline: Timeline) -> None:
    timeline.choose(Chosen({("12L", 0): (0, 1, 2, 3)}))
    deeds.delete(timeline)
    assert timeline.animation.track("12L") is not None
    timeline.change(lines=frozenset(("track 12L", "track 12R", "track 17", "track head.yaw", "track 20L")))
    deeds.delete(timeline)
    assert [track.channel for track in timeline.animation.tracks] == ["26", "20L"]


def test_a_mirror_changes_sides(timeline: Timeline) -> None:
    timeline.choose(Chosen({("12L", 0): (0,)}, frozenset(("smirk 1", "smirk 2"))))
    deeds.mirror(timeline)
    assert curve_of_row(timeline.animation, ("12R", 0)).times.tolist() == [0.5, 1.0]
    by_key = {event.key: event for event in timeline.animation.events}
    assert by_key["smirk 1"].channels == ("12R",)
    assert by_key["smirk 2"].amplitude == 3.0


def test_what_is_duplicated_comes_right_behind(timeline: Timeline) -> None:
    timeline.choose(Chosen({("17", 0): (0, 1)}))
    deeds.duplicate(timeline)
    assert timeline.animation.track("17").curve.times.tolist() == pytest.approx([1.0, 2.5, 2.5 + 1 / 30, 4 + 1 / 30])


def test_a_dropped_expression_makes_the_clip_long_enough(timeline: Timeline) -> None:
    timeline.playhead.go(3.5)
    deeds.drop(timeline, find_expression("happiness"))
    assert timeline.animation.end > 4.0
    assert timeline.chosen.events
    assert len(timeline.document.history.done) == 1


def test_a_marker_comes_and_goes(timeline: Timeline) -> None:
    timeline.playhead.go(0.3)
    deeds.mark(timeline)
    assert [each.time for each in timeline.animation.markers] == [0.3, 1.5]
    deeds.mark(timeline)
    assert [each.time for each in timeline.animation.markers] == [1.5]


def test_a_range_is_named_after_what_is_chosen(timeline: Timeline) -> None:
    timeline.choose(Chosen({("12L", 0): (0, 3)}))
    deeds.name_range(timeline)
    deeds.choose_all(timeline)
    named = {each.name: (each.start, each.end) for each in timeline.animation.ranges}
    assert named["Range 1"] == (0.5, 3.0)


def test_choosing_goes_over_tracks_and_times(timeline: Timeline) -> None:
    timeline.choose(Chosen({("12R", 0): (0,)}))
    deeds.choose_column(timeline)
    assert {row[0] for row in timeline.chosen.keys} == {"12L", "12R", "17", "head.yaw"}
    deeds.choose_others(timeline)
    assert not timeline.chosen.has_key(("12R", 0), 0)
    assert timeline.chosen.has_key(("12L", 0), 0)


def test_shapes_eases_and_flags_are_steps(timeline: Timeline) -> None:
    timeline.choose(Chosen({("12L", 0): (1,)}))
    deeds.shape(timeline, "step")
    deeds.ease(timeline, "in-out")
    deeds.flag(timeline, broken=False)
    deeds.level(timeline, 0.5)
    assert timeline.animation.track("12L").curve.values[1] == 0.5
    assert len(timeline.document.history.done) == 4
    for _ in range(4):
        timeline.document.undo()
    assert timeline.animation.track("12L").curve.values[1] == 0.8


READINGS = {
    "time": (start_of, with_start(()), Chosen({("12L", 0): (1, 2)}), 1.25),
    "value": (value_of_keys, with_value_of_keys(()), Chosen({("12L", 0): (1, 2)}), 0.37),
    "out": (handle_of_key(3), with_handle_of_key(3), Chosen({("12L", 0): (1,)}), 0.2),
    "onset": (
        of_event(lambda event: event.onset),
        with_event(lambda event, value: replace(event, onset=value)),
        Chosen(events=frozenset(("smirk 1",))),
        0.1,
    ),
    "length": (length_of_events, with_length_of_events, Chosen(events=frozenset(("smirk 1", "smirk 2"))), 1.7),
    "strength": (strength_of_events, with_strength_of_events, Chosen(events=frozenset(("smirk 1", "smirk 2"))), 0.9),
}


@pytest.mark.parametrize("name", READINGS)
def test_a_field_says_what_was_written_into_it(timeline: Timeline, name: str) -> None:
    read, write, chosen, value = READINGS[name]
    assert read(timeline.animation, chosen) is not None
    made, now = write(timeline.animation, chosen, value)
    reading = read(made, now)
    assert reading is not None
    assert reading.value == pytest.approx(value)
    assert read(timeline.animation, Chosen()) is None


@pytest.mark.parametrize("key", OPERATIONS)
def test_what_is_done_to_curves_leaves_locked_ones(timeline: Timeline, key: str) -> None:
    operation = OPERATIONS[key]
    values_of = {**operation.usual, **({"seconds": 0.3} if key == "offset" else {})}
    made = operation.apply(timeline.animation, values_of, target_of(timeline))
    assert made.track("20L") is timeline.animation.track("20L")
    assert made.track("26") is not timeline.animation.track("26")


def test_curves_are_meant_by_chosen_tracks_then_keys_then_all(timeline: Timeline) -> None:
    assert len(target_of(timeline).channels) == 6
    timeline.choose(Chosen({("17", 0): (0, 1)}))
    assert (target_of(timeline).channels, target_of(timeline).span) == (("17",), (1.0, 2.5))
    timeline.change(lines=frozenset(("track 12R",)))
    assert target_of(timeline).channels == ("12R",)


def test_simplified_curves_stay_within_the_tolerance(timeline: Timeline) -> None:
    before = values(timeline, "26")
    made = OPERATIONS["simplify"].apply(timeline.animation, {"tolerance": 0.02}, target_of(timeline))
    timeline.edit(made, "Simplify")
    assert np.abs(values(timeline, "26") - before).max() < 0.021
    assert len(timeline.animation.track("26").curve) < 60


def test_things_come_to_rest_on_the_nearest_place_within_reach(timeline: Timeline) -> None:
    found = snapping(timeline.animation, ("keys", "frames"), Chosen({("12L", 0): (0,)}))
    assert found.time(1.02, 0.05) == 1.0
    assert found.time(0.51, 0.05) == pytest.approx(0.5, abs=1 / 60)
    assert found.time(3.306, 0.001) == pytest.approx(99 / 30)
    assert FREE.time(0.123, 1.0) == 0.123


def test_what_is_played_goes_on_while_a_stretch_is_repeated_to_its_end(timeline: Timeline) -> None:
    operation = OPERATIONS["loop"]
    made = operation.apply(timeline.animation, {"times": 3.0, "blend": 0.0}, target_of(timeline))
    assert made.end == 3 * timeline.animation.end
    timeline.choose(Chosen({("12L", 0): (0, 2)}))
    part = operation.apply(timeline.animation, {"times": 2.0, "blend": 0.0}, target_of(timeline))
    assert part.end == timeline.animation.end
