"""Keys are put, moved, scaled, copied, pasted, mirrored and deleted; what was not chosen stays as it was."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from facemodel.animation.channels import channel_of
from facemodel.animation.clip import Animation
from facemodel.animation.curve import EMPTY, SAME_TIME, Curve, Key, curve_of, curve_through
from facemodel.animation.displacement import Displacement
from facemodel.animation.editing import bulk, clipboard, keys
from facemodel.animation.editing.eases import EASES, eased
from facemodel.animation.editing.selection import Selection, curve_of_row, rows, selected, span
from facemodel.animation.keyed import values_of
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track
from facemodel.io.keys_text import KeysError, keys_from, keys_text
from tests.animation.strategies import curves, times, tracks, values

moves = st.tuples(st.integers(-300, 300).map(lambda frame: frame / 60.0), st.floats(-0.5, 0.5))


@st.composite
def chosen(draw: st.DrawFn) -> tuple[Curve, list[int]]:
    curve = draw(curves(1))
    return curve, sorted(draw(st.sets(st.integers(0, len(curve) - 1), min_size=1)))


@st.composite
def edited(draw: st.DrawFn) -> tuple[Animation, Selection]:
    """Several tracks, and some of their keys."""
    names = draw(st.lists(st.sampled_from(["12L", "12R", "17", "head.yaw"]), min_size=1, max_size=4, unique=True))
    animation = Animation(tuple(replace(draw(tracks(name)), locked=False) for name in names))
    found = {}
    for row in rows(animation):
        count = len(curve_of_row(animation, row))
        places = draw(st.sets(st.integers(0, count - 1))) if count else set()
        if places:
            found[row] = tuple(sorted(places))
    return animation, found


@given(curves(0), times, values)
def test_a_key_that_is_put_is_met_and_the_others_stay(curve: Curve, time: float, value: float) -> None:
    made = keys.with_key(curve, time, value)
    assert values_of(made, np.array([time]))[0] == value
    others = curve.times[np.abs(curve.times - time) > SAME_TIME]
    assert np.array_equal(values_of(made, others), values_of(curve, others))
    assert len(made) == len(others) + 1


@given(curves(2, overshoot=st.just(True)), st.floats(0, 1))
def test_a_key_put_on_a_bezier_curve_changes_no_other_segment(curve: Curve, share: float) -> None:
    bent = keys.with_shape(curve, range(len(curve)), "bezier")
    place = int(share * (len(curve) - 2))
    time = float(bent.times[place] + 0.4 * (bent.times[place + 1] - bent.times[place]))
    made = keys.with_key(bent, time, float(values_of(bent, np.array([time]))[0]))
    elsewhere = np.linspace(curve.times[0] - 1, curve.times[-1] + 1, 301)
    elsewhere = elsewhere[(elsewhere < bent.times[place]) | (elsewhere > bent.times[place + 1])]
    assert values_of(made, elsewhere) == pytest.approx(values_of(bent, elsewhere), abs=1e-9)


@given(chosen(), moves)
def test_moved_keys_are_where_they_are_said_to_be(case: tuple[Curve, list[int]], move: tuple[float, float]) -> None:
    curve, places = case
    made, now = keys.moved(curve, places, *move)
    assert made.times[now] == pytest.approx(curve.times[places] + move[0])
    assert made.values[now] == pytest.approx(curve.values[places] + move[1])
    assert np.all(np.diff(made.times) > SAME_TIME)
    rest = np.setdiff1d(np.arange(len(curve)), places)
    landed = np.abs(curve.times[rest][:, None] - (curve.times[places] + move[0])).min(axis=1, initial=np.inf) <= 1e-9
    kept = [key for place, key in enumerate(curve.keys) if place in set(rest[~landed].tolist())]
    assert [key for place, key in enumerate(made.keys) if place not in set(now.tolist())] == kept


@given(chosen(), st.floats(0.1, 5), st.floats(0.1, 5))
def test_scaling_there_and_back_changes_nothing(case: tuple[Curve, list[int]], time: float, value: float) -> None:
    curve, _ = case
    everything = np.arange(len(curve))
    there, now = keys.scaled(curve, everything, (1.0, 0.5), (time, value))
    back, _ = keys.scaled(there, now, (1.0, 0.5), (1 / time, 1 / value))
    for name in ("times", "values", "handles"):
        assert getattr(back, name) == pytest.approx(getattr(curve, name), abs=1e-9)


@given(curves(2, overshoot=st.just(True)), st.sampled_from(["step", "linear", "smooth", "bezier"]))
@example(curve_through([0.0, 1 / 60], [0.0, 1.0]), "smooth")
def test_a_curve_that_becomes_bezier_keeps_its_course(curve: Curve, shape: str) -> None:
    plain = keys.with_shape(curve_through(curve.times, curve.values), range(len(curve)), shape)  # type: ignore[arg-type]
    bent = keys.with_shape(replace(plain, overshoot=True), range(len(curve)), "bezier")
    at = np.linspace(curve.times[0], curve.times[-1], 200)
    if shape != "step":
        assert values_of(bent, at) == pytest.approx(values_of(plain, at), abs=1e-4)


def test_the_handles_of_a_key_turn_together_until_they_are_broken() -> None:
    curve = curve_of([Key(0, 0), Key(1, 0.5, "bezier", (-0.2, -0.1), (0.4, 0.2)), Key(2, 1)])
    turned = keys.with_handles(curve, 1, leaves=(0.4, -0.4))
    assert turned.key(1).arrives == pytest.approx((-0.2, 0.2))
    broken = keys.with_handles(keys.with_flags(curve, [1], broken=True), 1, leaves=(0.4, -0.4))
    assert broken.key(1).arrives == (-0.2, -0.1)
    assert keys.with_flags(broken, [1], broken=False).key(1).arrives == pytest.approx((-0.2, 0.2))
    assert keys.with_flags(curve, [1], weighted=True).key(1).weighted


@given(chosen(), st.sampled_from(sorted(EASES)))
def test_an_ease_leads_from_key_to_key_and_passes_them_only_if_it_is_meant_to(
    case: tuple[Curve, list[int]], name: str
) -> None:
    curve, places = case
    made = eased(replace(curve, overshoot=False), places, EASES[name])
    assert np.array_equal(values_of(made, made.times), curve.values)
    if not EASES[name].passes:
        found = values_of(made, np.linspace(curve.times[0], curve.times[-1], 300))
        assert curve.values.min() - 1e-9 <= found.min() <= found.max() <= curve.values.max() + 1e-9


@given(edited(), moves)
def test_bulk_moves_touch_chosen_keys_alone_and_keep_them_in_range(
    case: tuple[Animation, Selection], move: tuple[float, float]
) -> None:
    animation, selection = case
    made, now = bulk.moved_keys(animation, selection, *move)
    assert now.keys() == {row for row, places in selection.items() if places}
    for row in rows(animation):
        if row not in selection:
            assert curve_of_row(made, row) is curve_of_row(animation, row)
        else:
            channel = channel_of(row[0])
            values = curve_of_row(made, row).values[list(now[row])]
            assert values.max() <= channel.high
    assert [track.captured for track in made.tracks] == [track.captured for track in animation.tracks]


@given(edited(), moves)
def test_locked_tracks_are_left_alone(case: tuple[Animation, Selection], move: tuple[float, float]) -> None:
    animation, selection = case
    locked = replace(animation, tracks=tuple(replace(track, locked=True) for track in animation.tracks))
    made, now = bulk.moved_keys(locked, selection, *move)
    assert all(a is b for a, b in zip(made.tracks, locked.tracks, strict=True))
    assert now == selection
    assert bulk.deleted_keys(locked, selection).tracks == locked.tracks


@given(edited())
def test_deleted_keys_are_gone_and_the_others_stay(case: tuple[Animation, Selection]) -> None:
    animation, selection = case
    made = bulk.deleted_keys(animation, selection)
    for row in rows(animation):
        kept = [
            key for place, key in enumerate(curve_of_row(animation, row).keys) if place not in selection.get(row, ())
        ]
        assert list(curve_of_row(made, row).keys) == kept


@given(edited(), times)
def test_what_was_copied_is_pasted_with_its_distances(case: tuple[Animation, Selection], time: float) -> None:
    animation, selection = case
    begin, _ = span(animation, selection)
    made, now = clipboard.pasted_keys(animation, clipboard.copied_keys(animation, selection), time)
    assert now.keys() == selection.keys()
    for row, places in selection.items():
        source, target = curve_of_row(animation, row), curve_of_row(made, row)
        assert target.times[list(now[row])] - time == pytest.approx(source.times[list(places)] - begin, abs=1e-6)
        assert [target.key(k).shape for k in now[row]] == [source.key(k).shape for k in places]


@given(edited())
def test_copied_keys_travel_as_text(case: tuple[Animation, Selection]) -> None:
    copied = clipboard.copied_keys(*case)
    if not copied:
        return
    again = keys_from(keys_text(copied))
    assert {row: curve.keys for row, curve in again.items()} == {row: curve.keys for row, curve in copied.items()}


@pytest.mark.parametrize("text", ["", "{}", "hello", '{"format": "risorius-keys", "rows": []}', "[" * 2000])
def test_a_text_without_keys_is_refused_in_a_sentence(text: str) -> None:
    with pytest.raises(KeysError, match="copy some in the timeline first"):
        keys_from(text)


def test_a_copied_row_is_pasted_onto_others() -> None:
    animation = Animation((Track("12L", curve_of([Key(1, 0.5), Key(2, 0.7)])),))
    copied = clipboard.copied_keys(animation, selected(animation, 0, 9))
    made, now = clipboard.pasted_keys(animation, copied, 3.0, onto=[("6L", 0), ("6R", 0)])
    assert [track.channel for track in made.tracks] == ["12L", "6L", "6R"]
    assert made.tracks[2].curve.times.tolist() == [3.0, 4.0]
    assert now == {("6L", 0): (0, 1), ("6R", 0): (0, 1)}


def test_mirroring_changes_sides_and_turns() -> None:
    animation = Animation(
        (
            Track("12L", curve_of([Key(1, 0.5)])),
            Track("12R", curve_of([Key(1, 0.2), Key(2, 0.3)])),
            Track("head.yaw", curve_of([Key(1, 10.0, "bezier", (-0.1, 1), (0.1, 2))])),
        )
    )
    made, _ = clipboard.mirrored_keys(animation, selected(animation, 1, 1))
    left, right, yaw = (track.curve.keys for track in made.tracks)
    assert [(key.time, key.value) for key in left] == [(1, 0.2)]
    assert [(key.time, key.value) for key in right] == [(1, 0.5), (2, 0.3)]
    assert (yaw[0].value, yaw[0].arrives, yaw[0].leaves) == (-10, (-0.1, -1), (0.1, -2))


@given(edited())
def test_mirroring_twice_changes_nothing_where_both_sides_are_chosen(case: tuple[Animation, Selection]) -> None:
    animation, _ = case
    plain = replace(animation, tracks=tuple(replace(t, captured=None, layers=()) for t in animation.tracks))
    everything = selected(plain, -1, 99)
    once, now = clipboard.mirrored_keys(plain, everything)
    twice, _ = clipboard.mirrored_keys(once, now)
    for track in plain.tracks:
        again = twice.track(track.channel)
        assert again is not None
        assert again.curve.times == pytest.approx(track.curve.times, abs=1e-9)
        assert again.curve.values == pytest.approx(track.curve.values)


def test_keys_over_a_captured_curve_may_take_from_it() -> None:
    captured = Samples(np.ones(10, dtype=np.float32), 30.0)
    track = Track("12L", curve_of([Key(0, 0.0)]), captured, (Displacement(curve_of([Key(0, 0.5)])),))
    made, _ = bulk.moved_keys(Animation((track,)), {("12L", 0): (0,)}, 0.0, -0.8)
    assert made.tracks[0].curve.values[0] == pytest.approx(-0.8)
    alone = replace(track, curve=EMPTY)
    made, _ = bulk.moved_keys(Animation((alone,)), {("12L", 1): (0,)}, 0.0, -0.8)
    assert made.tracks[0].layers[0].keys.values[0] == 0.0


def test_keys_snap_to_frames_and_take_values() -> None:
    animation = Animation((Track("12L", curve_of([Key(0.99, 0.5), Key(2.03, 0.7)])),), rate=25.0)
    snapped, now = bulk.snapped_keys(animation, {("12L", 0): (0, 1)})
    assert snapped.tracks[0].curve.times == pytest.approx([1.0, 2.04])
    valued, _ = bulk.valued_keys(snapped, now, 0.25)
    assert valued.tracks[0].curve.values.tolist() == [0.25, 0.25]


def test_shapes_and_flags_are_set_in_bulk() -> None:
    animation = Animation((Track("12L", curve_of([Key(0, 0), Key(1, 1), Key(2, 0)])),))
    everything = selected(animation, 0, 2)
    shaped = bulk.shaped_keys(animation, everything, "step")
    assert {key.shape for key in shaped.tracks[0].curve.keys} == {"step"}
    flagged = bulk.flagged_keys(shaped, everything, weighted=True, broken=True)
    assert all(key.weighted and key.broken for key in flagged.tracks[0].curve.keys)
    assert bulk.eased_keys(animation, everything, EASES["overshoot"]).tracks[0].curve.overshoot
