"""A curve meets its keys, runs between them as its shape says, and never passes beyond them unless asked."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.curve import EMPTY, SAME_TIME, Curve, Key, curve_of, curve_through
from facemodel.animation.keyed import KeyedCurves, values_of
from facemodel.animation.segments import parameter
from tests.animation.strategies import curves

ROUNDING = 1e-12
"""Values are about 1, and a cubic is a dozen operations."""


def fine(curve: Curve) -> np.ndarray:
    return np.linspace(curve.times[0] - 1.0, curve.times[-1] + 1.0, 1001)


@given(curves(1))
def test_it_meets_its_keys_exactly_and_rests_before_and_behind(curve: Curve) -> None:
    assert np.array_equal(values_of(curve, curve.times), curve.values)
    outside = np.array([curve.times[0] - 5.0, curve.times[-1] + 5.0])
    assert np.array_equal(values_of(curve, outside), curve.values[[0, -1]])


@given(curves(1, overshoot=st.just(False)))
def test_it_never_passes_beyond_its_highest_and_lowest_key_unless_asked(curve: Curve) -> None:
    found = values_of(curve, fine(curve))
    assert found.min() >= curve.values.min() - ROUNDING
    assert found.max() <= curve.values.max() + ROUNDING


def test_it_passes_beyond_them_when_asked() -> None:
    up = [
        Key(0, 0, "bezier", leaves=(0.5, 1.5), weighted=True),
        Key(1, 1, "bezier", arrives=(-0.5, 0.5), weighted=True),
    ]
    asked, unasked = curve_of(up, overshoot=True), curve_of(up)
    assert values_of(asked, fine(asked)).max() > 1.01
    assert values_of(unasked, fine(unasked)).max() <= 1.0 + ROUNDING


@given(st.lists(st.floats(0, 1), min_size=2, max_size=8))
def test_a_smooth_segment_stays_between_its_two_keys_and_goes_one_way(heights: list[float]) -> None:
    curve = curve_through(np.arange(float(len(heights))), np.array(heights))
    for left in range(len(heights) - 1):
        found = np.diff(values_of(curve, np.linspace(left, left + 1, 101)))
        rises = heights[left + 1] - heights[left]
        assert np.all(found * np.sign(rises) >= -ROUNDING)


@given(st.lists(st.floats(0, 1), min_size=3, max_size=8))
def test_a_smooth_curve_has_no_corner(heights: list[float]) -> None:
    curve = curve_through(np.arange(float(len(heights))), np.array(heights))
    step = 1e-6
    at = curve.times[1:-1]
    before = (values_of(curve, at) - values_of(curve, at - step)) / step
    after = (values_of(curve, at + step) - values_of(curve, at)) / step
    assert np.abs(after - before).max(initial=0) < 1e-4


def test_each_shape_runs_as_it_is_called() -> None:
    at = np.array([0.25, 0.5, 0.999])
    steps = values_of(curve_of([Key(0, 0.2, "step"), Key(1, 1)]), at)
    straight = values_of(curve_of([Key(0, 0, "linear"), Key(1, 1)]), at)
    smooth = values_of(curve_of([Key(0, 0, "smooth"), Key(1, 1)]), at)
    assert steps.tolist() == [0.2, 0.2, 0.2]
    assert straight == pytest.approx(at)
    assert smooth == pytest.approx(at**2 * (3 - 2 * at))


def test_only_the_slope_of_a_handle_counts_unless_it_is_weighted() -> None:
    def middle(length: float, weighted: bool) -> float:
        keys = [Key(0, 0, "bezier", leaves=(length, 0.0), weighted=weighted), Key(1, 1, "bezier", weighted=weighted)]
        return float(values_of(curve_of(keys), np.array([0.4]))[0])

    assert middle(0.1, False) == middle(0.9, False)
    assert middle(0.1, True) > middle(0.9, True) + 0.1


def test_an_unbroken_key_stays_smooth_where_its_handles_are_levelled() -> None:
    peak = Key(1, 1, "bezier", (-0.3, -0.3), (0.3, 0.3))
    curve = curve_of([Key(0, 0, "bezier"), peak, Key(2, 0, "bezier")])
    around = values_of(curve, np.array([1 - 1e-5, 1, 1 + 1e-5]))
    assert np.abs(np.diff(around)).max() < 1e-9


@given(st.floats(0, 1), st.floats(0, 1), st.floats(0, 1))
def test_time_along_a_weighted_segment_is_found_to_the_last_digits(share: float, p: float, q: float) -> None:
    s = float(parameter(np.array([share]), np.array([[p, q]]))[0])
    assert 0 <= s <= 1
    assert 3 * s * (1 - s) * ((1 - s) * p + s * q) + s**3 == pytest.approx(share, abs=1e-12)


@given(st.lists(curves(1), min_size=1, max_size=6), st.lists(st.floats(-1, 11), min_size=6, max_size=20))
def test_curves_are_worth_the_same_together_and_alone_at_one_time_and_at_many(
    many: list[Curve], at: list[float]
) -> None:
    times = np.array(at)
    together = KeyedCurves(many).at(times)
    alone = np.stack([values_of(curve, times) for curve in many], axis=1)
    one_by_one = np.concatenate([KeyedCurves(many).at(times[k : k + 1]) for k in range(len(times))])
    assert np.array_equal(together, alone)
    assert together == pytest.approx(one_by_one, abs=1e-9)


def test_of_two_keys_at_one_time_the_later_given_counts() -> None:
    curve = curve_of([Key(1, 0.1), Key(0, 0.5), Key(1 + SAME_TIME / 2, 0.2), Key(1 - SAME_TIME / 3, 0.3)])
    assert [key.value for key in curve.keys] == [0.5, 0.3]


def test_a_curve_without_keys_is_worth_nothing() -> None:
    assert not values_of(EMPTY, np.linspace(0, 1, 5)).any()
    assert EMPTY.near(0.0) is None


@given(curves(0))
def test_keys_go_in_and_come_out_the_same(curve: Curve) -> None:
    again = curve_of(curve.keys, curve.overshoot)
    assert again.keys == curve.keys
