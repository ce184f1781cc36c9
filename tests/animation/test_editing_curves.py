"""Whole curves are baked, simplified, smoothed, warped, offset and looped."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.curve import Key, curve_of
from facemodel.animation.displacement import Displacement
from facemodel.animation.editing import dense
from facemodel.animation.editing.layers import baked_layers
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track
from tests.animation.strategies import tracks

SINGLE = 1e-7
"""Share by which a number in single precision, as samples are, may be off."""


def tremor(count: int = 600, rate: float = 60.0) -> Samples:
    at = np.arange(count) / rate
    fine = 0.02 * np.random.default_rng(5).standard_normal(count)
    return Samples((0.5 + 0.3 * np.sin(2 * np.pi * 0.4 * at) + fine).astype(np.float32), rate, 1.0)


@given(tracks(), st.sampled_from([24.0, 60.0]))
def test_baking_keeps_every_frame(track: Track, rate: float) -> None:
    begin, end = dense.extent(track)
    frames = dense.frame_times(begin, end, rate)
    before = dense.own_values(track, frames)
    samples, keyed = dense.baked_to_samples(track, rate), dense.baked_to_keys(track, rate)
    assert dense.own_values(samples, frames) == pytest.approx(before, rel=SINGLE, abs=1e-6)
    assert dense.own_values(keyed, frames) == pytest.approx(before, abs=1e-6)
    assert samples.layers == keyed.layers == ()
    assert keyed.captured is None


@given(tracks(), st.sampled_from([0.3, 0.05, 0.001]))
def test_a_simplified_curve_stays_within_its_bound(track: Track, tolerance: float) -> None:
    made = dense.simplified(track, tolerance)
    begin, end = dense.extent(track)
    captured = track.captured is not None and not len(track.curve)
    at = track.captured.times if captured else dense.frame_times(begin, end, 60.0)
    assert np.abs(dense.own_values(made, at) - dense.own_values(track, at)).max() <= tolerance + 1e-9
    assert made.captured is None


def test_simplifying_a_captured_curve_leaves_few_keys_where_much_may_be_lost() -> None:
    track = Track("12L", captured=tremor())
    counts = [len(dense.simplified(track, tolerance).curve) for tolerance in (0.1, 0.05, 0.01)]
    assert counts == sorted(counts)
    assert counts[0] < 30
    assert len(dense.simplified(track, 0.0).curve) == 600


def test_smoothing_takes_the_tremor_and_leaves_the_motion() -> None:
    samples = tremor()
    found = dense.smoothed(Track("12L", captured=samples), 0.1).captured
    assert found is not None
    inside = slice(60, -60)
    slow = 0.5 + 0.3 * np.sin(2 * np.pi * 0.4 * (samples.times - 1.0))
    assert np.abs(found.values - slow)[inside].max() < 0.02
    assert np.diff(found.values, 2)[inside].std() < np.diff(samples.values, 2)[inside].std() / 20
    assert dense.smoothed(Track("12L", captured=samples), 0.0).captured is samples


def test_smoothing_levels_keys_and_leaves_a_level_curve() -> None:
    zigzag = Track("12L", curve_of([Key(k, k % 2, "linear") for k in range(9)]))
    found = dense.smoothed(zigzag, 1.0).curve.values
    assert found[2:-2].std() < 0.1
    level = Track("12L", curve_of([Key(0, 0.5), Key(1, 0.5)]))
    assert dense.smoothed(level, 2.0).curve.values == pytest.approx([0.5, 0.5])


@given(tracks(), st.floats(0.3, 3), st.floats(-2, 2))
def test_a_warp_carries_every_moment_along(track: Track, factor: float, start: float) -> None:
    begin, end = dense.extent(track)
    if end - begin < 0.1:
        return
    made = dense.warped(track, [begin, end], [start, start + factor * (end - begin)])
    only_keys = replace(track, captured=None, layers=())
    warped_keys = replace(made, captured=None, layers=())
    at = np.linspace(begin, end, 50)
    then = start + factor * (at - begin)
    assert dense.own_values(warped_keys, then) == pytest.approx(dense.own_values(only_keys, at), abs=1e-6)
    assert [len(layer.keys) for layer in made.layers] == [len(layer.keys) for layer in track.layers]


def test_a_warped_capture_keeps_its_rate_and_its_course() -> None:
    track = Track("12L", captured=dense.smoothed(Track("12L", captured=tremor()), 0.1).captured)
    made = dense.warped(track, [1.0, 5.0, 10.0], [2.0, 4.0, 12.0])
    assert made.captured is not None
    assert (made.captured.rate, made.captured.start) == (60.0, 2.0)
    assert dense.own_values(made, np.array([2.0, 3.0, 8.0])) == pytest.approx(
        dense.own_values(track, np.array([1.0, 3.0, 7.5])), abs=1e-3
    )


@given(tracks(), st.floats(-2, 2), st.floats(-0.5, 0.5))
def test_an_offset_moves_the_whole_track(track: Track, seconds: float, rise: float) -> None:
    at = np.linspace(*dense.extent(track), 20)
    lifted = rise if track.captured is not None or len(track.curve) else 0.0
    made = dense.offset(replace(track, layers=()), seconds, rise)
    assert dense.own_values(made, at + seconds) == pytest.approx(
        dense.own_values(replace(track, layers=()), at) + lifted, abs=1e-4
    )


@pytest.mark.parametrize("captured", [True, False])
def test_a_loop_does_the_same_again_and_goes_on_as_before(captured: bool) -> None:
    curve = curve_of([Key(0, 0.1, "linear"), Key(1, 0.9, "linear"), Key(2, 0.1, "linear"), Key(3, 0.6, "linear")])
    track = Track("12L", curve)
    if captured:
        track = dense.baked_to_samples(track, 60.0)
    made = dense.looped(track, (0.0, 2.0), 3)
    at = np.linspace(0.0, 2.0, 121)[:-1]
    for turn in range(3):
        assert dense.own_values(made, at + 2 * turn) == pytest.approx(dense.own_values(track, at), abs=1e-6)
    assert dense.own_values(made, np.array([6.5, 7.0])) == pytest.approx(dense.own_values(track, np.array([2.5, 3.0])))


@given(tracks())
def test_a_closed_loop_ends_where_it_begins(track: Track) -> None:
    begin, end = dense.extent(track)
    if track.captured is not None or end - begin < 0.2:
        return
    made = dense.closed(track, (begin, end), 0.5)
    first, last = dense.own_values(made, np.array([begin, end]))
    assert last == pytest.approx(first, abs=1e-6)


def test_baking_layers_leaves_the_curve_that_is_seen() -> None:
    layer = Displacement(curve_of([Key(3.0, 0.9)]), 0.3)
    track = Track("12L", captured=tremor(), layers=(layer, replace(layer, muted=True)))
    made = baked_layers(track)
    assert made.captured is not None
    assert made.layers == ()
    assert dense.own_values(made, made.captured.times) == pytest.approx(dense.own_values(track, made.captured.times))


def test_simplifying_never_adds_keys() -> None:
    curve = curve_of([Key(0.5, 0.0), Key(1.0, 0.8), Key(2.0, 0.2, "linear"), Key(3.0, 0.6)])
    track = Track("12L", curve)
    assert dense.simplified(track, 0.001) is track
