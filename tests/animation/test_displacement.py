"""Captured curves are bent to keys: met, local, and with their fine motion untouched."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.captured import displaced
from facemodel.animation.curve import curve_through
from facemodel.animation.displacement import REACH, Displacement, Splines, regions, spline_through
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track

RATE, COUNT = 60.0, 1200
MET = 1e-6


def captured(seed: int = 7) -> Samples:
    """Twenty seconds of slow motion with a fine tremor over the whole of its spectrum."""
    random = np.random.default_rng(seed)
    times = np.arange(COUNT) / RATE
    slow = 0.5 + 0.2 * np.sin(2 * np.pi * 0.3 * times) + 0.1 * np.sin(2 * np.pi * 0.9 * times + 1)
    return Samples((slow + 0.02 * random.standard_normal(COUNT)).astype(np.float32), RATE)


@given(
    st.lists(st.tuples(st.integers(0, COUNT - 1), st.floats(-1, 2)), min_size=1, max_size=12, unique_by=lambda k: k[0]),
    st.sampled_from([0.05, 0.133, 0.25, 0.5, 2.0]),
)
def test_every_key_is_met_wherever_the_keys_are(keys: list[tuple[int, float]], spacing: float) -> None:
    keys.sort()
    times, values = np.array([(frame + 0.3) / RATE for frame, _ in keys]), np.array([value for _, value in keys])
    track = Track("12L", captured=captured(), layers=(Displacement(curve_through(times, values), spacing),))
    assert np.abs(displaced(track, times) - values).max() < MET


@pytest.mark.parametrize("spacing", [0.1, 0.2, 0.4])
def test_above_the_frequency_of_the_knots_the_spectrum_stays_within_a_percent(spacing: float) -> None:
    samples = captured()
    keys = curve_through(np.array([5.0, 9.5, 14.2]), np.array([0.9, 0.1, 0.8]))
    track = Track("12L", captured=samples, layers=(Displacement(keys, spacing),))
    before, after = (np.fft.rfft(each) for each in (samples.values, displaced(track, samples.times)))
    high = np.fft.rfftfreq(COUNT, 1 / RATE) > 1 / spacing
    low = np.fft.rfftfreq(COUNT, 1 / RATE) < 0.5 / spacing
    assert np.linalg.norm((after - before)[high]) < 0.01 * np.linalg.norm(before[high])
    assert np.linalg.norm((after - before)[low]) > np.linalg.norm(before[high])


@given(st.floats(0.5, 19), st.sampled_from([0.05, 0.25, 0.7]))
def test_outside_its_region_the_curve_is_the_same_to_the_bit(time: float, spacing: float) -> None:
    samples = captured()
    layer = Displacement(curve_through(np.array([time]), np.array([1.0])), spacing)
    ((begin, end),) = regions(layer)
    times = samples.times
    found = displaced(Track("12L", captured=samples, layers=(layer,)), times)
    outside = (times < begin) | (times > end)
    assert np.array_equal(found[outside], samples.values[outside].astype(np.float64))
    assert begin < time < end
    assert max(time - begin, end - time) <= REACH * spacing + 1e-9


def test_near_keys_with_other_values_do_not_throw_the_curve_far_out() -> None:
    random = np.random.default_rng(3)
    times = np.sort(random.uniform(0, 10, 40))
    values = random.uniform(-1, 1, 40)
    spline = spline_through(times, values, 0.25)
    assert np.abs(Splines([spline]).at(np.linspace(-1, 11, 4001))).max() < 2.0


def test_a_single_key_needs_no_finer_knots() -> None:
    assert len(spline_through(np.array([1.234]), np.array([0.7]), 0.25)) == 1


def test_layers_lie_over_each_other_and_can_be_muted_and_weighed() -> None:
    samples = captured()
    at = np.array([4.0, 6.0])
    first = Displacement(curve_through(at[:1], np.array([0.9])))
    second = Displacement(curve_through(at, np.array([0.1, 0.8])))
    both = Track("12L", captured=samples, layers=(first, second))
    assert displaced(both, at) == pytest.approx([0.1, 0.8], abs=MET)
    muted = Track("12L", captured=samples, layers=(first, Displacement(second.keys, muted=True)))
    assert displaced(muted, at[:1]) == pytest.approx([0.9], abs=MET)
    half = Track("12L", captured=samples, layers=(Displacement(first.keys, weight=0.5),))
    assert displaced(half, at[:1]) == pytest.approx((0.9 + samples.at(at[:1])) / 2, abs=MET)


def test_a_layer_shows_the_regions_it_may_change() -> None:
    layer = Displacement(curve_through(np.array([1.0, 1.5, 9.0]), np.zeros(3)), 0.25)
    assert regions(layer) == ((0.25, 2.5), (8.25, 10.0))
    assert regions(Displacement()) == ()


def test_samples_are_straight_between_frames_and_still_outside() -> None:
    samples = Samples(np.array([0, 1, 0.5], dtype=np.float32), 10.0, 1.0)
    assert samples.at(np.array([0, 1.05, 1.1, 1.15, 9])).tolist() == pytest.approx([0, 0.5, 1, 0.75, 0.5])
    assert samples.end == pytest.approx(1.2)
