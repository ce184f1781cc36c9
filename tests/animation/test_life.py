"""Idle life is the same for ever from one seed, and looks alive; the library holds expressions that move."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.actions import Emotion
from facemodel.animation.clip import STILL, Animation
from facemodel.animation.evaluation import Evaluator
from facemodel.animation.idle import Idle, Life, blink_events, idle_curves
from facemodel.animation.library import dynamic, find_expression, library, placed
from facemodel.errors import UnknownNameError
from facemodel.facs import action_units

UNITS = action_units()


@given(st.integers(0, 2**31 - 1))
def test_one_seed_is_one_life_however_long_it_is_asked_for(seed: int) -> None:
    times = np.linspace(0, 20, 400)
    short, long = Life(Idle(seed), 20.0), Life(Idle(seed), 60.0)
    assert short.channels == long.channels
    assert short.at(times) == pytest.approx(long.at(times), abs=1e-9)


def test_the_first_blinks_of_seed_one_are_these_for_ever() -> None:
    starts = [event.start for event in blink_events(Idle(1), 20.0)]
    assert starts == pytest.approx(FIRST_BLINKS, abs=1e-9)


FIRST_BLINKS = [2.5446465859769965, 6.805063056023565, 10.239726121225221, 18.61923878790845]


def test_people_blink_about_as_often_as_asked() -> None:
    for rate in (6.0, 15.0, 30.0):
        assert len(blink_events(Idle(3, blinks=rate), 3600.0)) / 60.0 == pytest.approx(rate, rel=0.15)
    assert blink_events(Idle(blinks=0.0), 60.0) == ()


def test_eyes_rest_and_jump_and_never_look_far() -> None:
    curves = idle_curves(Idle(2), 60.0)
    assert np.array_equal(curves["eyeL.yaw"].values, curves["eyeR.yaw"].values)
    times = np.arange(0, 60, 1 / 240)
    yaw = Life(Idle(2, blinks=0.0), 60.0).at(times)[:, 0]
    moving = np.abs(np.diff(yaw)) > 1e-9
    assert 0.01 < moving.mean() < 0.2
    assert 0.3 < np.abs(yaw).max() <= 3.0


def test_one_kind_of_life_does_not_change_another() -> None:
    often, seldom = (idle_curves(Idle(5, blinks=rate), 30.0) for rate in (30.0, 5.0))
    assert np.array_equal(often["eyeL.yaw"].times, seldom["eyeL.yaw"].times)
    calm = Life(Idle(5, saccades=0.0, breathing=0.0), 30.0)
    assert calm.channels == ("43L", "43R")
    assert Life(Idle(5, muted=True), 30.0).channels == ()


def test_lids_close_fully_and_open_again() -> None:
    idle = Idle(1)
    (first, *_) = blink_events(idle, 30.0)
    pose = Evaluator(Animation(idle=idle, end=30.0), UNITS).pose(first.begins + first.peak)
    assert pose.weights["43L"] == pose.weights["43R"] == pytest.approx(1.0)
    assert Evaluator(Animation(idle=idle, end=30.0), UNITS).pose(first.ends + 0.05).weights["43L"] == 0.0


@pytest.mark.parametrize("expression", library(), ids=lambda each: each.name)
def test_every_expression_of_the_library_comes_and_goes(expression) -> None:  # type: ignore[no-untyped-def]
    animation, group = placed(STILL, expression, 1.0, UNITS, strength=0.8)
    evaluator = Evaluator(animation, UNITS)
    values = evaluator.at(np.linspace(0.9, 1.1 + expression.duration, 300))
    assert group == expression.title
    assert {event.group for event in animation.events} == {group}
    assert np.abs(values[[0, -1]]).max() == pytest.approx(0.0, abs=1e-12)
    assert np.abs(values).max() > 0.3
    assert all(event.channels for event in animation.events)
    twice, second = placed(animation, expression, 9.0, UNITS)
    assert second == f"{group} 2"
    assert len({event.key for event in twice.events}) == len(twice.events)


def test_a_placed_expression_can_be_longer_and_leaves_out_what_a_face_does_not_have() -> None:
    smile = find_expression("Happiness")
    slow, _ = placed(STILL, smile, 0.0, UNITS, duration=2 * smile.duration)
    assert max(event.ends for event in slow.events) == pytest.approx(2 * smile.duration)
    few, _ = placed(STILL, smile, 0.0, [unit for unit in UNITS if unit.number == 6])
    assert {channel for event in few.events for channel in event.channels} == {"6L", "6R", "head.roll"}
    with pytest.raises(UnknownNameError, match="happiness, sadness"):
        find_expression("joy")


def test_a_named_expression_of_the_project_becomes_a_dynamic_one() -> None:
    made = dynamic(Emotion("grin", {"12": 0.9, "26": 0.2}), UNITS)
    animation, _ = placed(STILL, made, 0.0, UNITS)
    assert Evaluator(animation, UNITS).pose(1.0).weights == pytest.approx({"12L": 0.9, "12R": 0.9, "26": 0.2})
