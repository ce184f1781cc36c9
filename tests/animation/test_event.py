"""An event is the bump that its six temporal parameters describe."""

import numpy as np
import pytest
from hypothesis import given

from facemodel.animation.event import Event, bump
from tests.animation.strategies import events


@given(events())
def test_it_is_nothing_outside_and_never_above_its_peak(event: Event) -> None:
    times = np.linspace(event.begins - 1, event.ends + 1, 501)
    found = bump(event, times)
    assert not found[(times <= event.begins) | (times >= event.ends)].any()
    assert found.max() <= event.amplitude + 1e-12


@given(events())
def test_it_is_at_its_peak_from_when_it_has_risen_until_it_falls(event: Event) -> None:
    begin, end = event.full
    assert event.begins < begin <= end < event.ends
    assert bump(event, np.array([begin, (begin + end) / 2, end])) == pytest.approx(event.amplitude, abs=1e-9)


@given(events())
def test_it_rises_before_its_peak_and_falls_after(event: Event) -> None:
    begin, end = event.full
    assert np.all(np.diff(bump(event, np.linspace(event.begins, begin, 50))) >= -1e-12)
    assert np.all(np.diff(bump(event, np.linspace(end, event.ends, 50))) <= 1e-12)


def test_acceleration_and_deceleration_are_how_much_faster_it_comes_and_goes() -> None:
    event = Event(
        "a", ("12L",), 2.0, onset=0.5, acceleration=2.0, amplitude=0.8, peak=1.5, deceleration=4.0, offset=3.5
    )
    assert (event.begins, event.full, event.ends) == (2.5, (3.0, 5.0), 5.5)
    assert bump(event, np.array([2.75, 5.25])) == pytest.approx([0.4, 0.4])


def test_it_begins_and_ends_without_a_jerk() -> None:
    event = Event("a", ("12L",), 0.0, peak=1.0, offset=2.0)
    near = bump(event, np.array([0.001, 1.0 - 0.001, 2.0 - 0.001]))
    assert near == pytest.approx([0.0, 1.0, 0.0], abs=1e-7)
