"""What an animation shows at a time: in its order, clamped, the same at once and one by one."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.actions import ActionUnit
from facemodel.animation.channels import channel_of, channels, mirrored
from facemodel.animation.clip import STILL, Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.evaluation import Evaluator, sampled
from facemodel.animation.event import Event
from facemodel.animation.idle import Idle
from facemodel.animation.samples import Samples
from facemodel.animation.speech import Phoneme, Speech
from facemodel.animation.track import Track
from facemodel.facs import action_units
from tests.animation.strategies import animations

UNITS = action_units()


def still(value: float, channel: str = "12L") -> Track:
    return Track(channel, curve_of([Key(0, value)]))


def at(animation: Animation, time: float, channel: str = "12L") -> float:
    pose = Evaluator(animation, UNITS).pose(time)
    return {**pose.weights, **pose.rigid}[channel]


@given(animations(), st.lists(st.floats(-1, 12), min_size=5, max_size=9))
def test_all_times_at_once_and_one_by_one_are_the_same_and_in_range(animation: Animation, times: list[float]) -> None:
    evaluator = Evaluator(animation, UNITS)
    together = evaluator.at(np.array(times))
    alone = np.concatenate([evaluator.at(np.array([time])) for time in times])
    assert together == pytest.approx(alone, abs=1e-9)
    known = [channel_of(name, UNITS) for name in evaluator.channels]
    for channel, column in zip(known, together.T, strict=True):
        assert channel.low <= column.min() <= column.max() <= channel.high


def test_captured_curves_and_keys_are_summed() -> None:
    captured = Samples(np.full(10, 0.25, dtype=np.float32), 30.0)
    track = replace(still(0.5), captured=captured)
    assert at(Animation((track,)), 0.1) == 0.75


def test_events_are_added_to_keys_but_go_no_further_than_full() -> None:
    bump = Event("a", ("12L",), 0.0, peak=0.5, offset=1.0)
    assert at(Animation((still(0.2),), (replace(bump, amplitude=0.3),)), 0.5) == pytest.approx(0.5)
    assert at(Animation((still(0.7),), (bump,)), 0.5) == 1.0
    assert at(Animation((still(1.4),), (bump,)), 0.5) == pytest.approx(1.4)
    assert at(Animation((), (replace(bump, amplitude=1.3),)), 0.5) == pytest.approx(1.3)


def test_head_and_eyes_are_simply_summed() -> None:
    nod = Event("nod", ("head.pitch",), 0.0, amplitude=-20.0, peak=0.5, offset=1.0)
    assert at(Animation((still(-5.0, "head.pitch"),), (nod,)), 0.5, "head.pitch") == pytest.approx(-25.0)


def test_a_weight_ends_at_the_limit_of_its_unit() -> None:
    units = (ActionUnit(12, "smile", "diagonal", True, {}, 1.0, limit=1.2),)
    assert Evaluator(Animation((still(1.9),)), units).pose(0).weights == {"12L": 1.2}
    assert Evaluator(Animation((still(-0.5),)), units).pose(0).weights == {"12L": 0.0}


def test_lips_meet_for_m_whatever_is_felt() -> None:
    surprise = Animation((still(1.0, "26"), still(0.8, "25")), speech=Speech((Phoneme("M", 1.0, 1.2),)))
    assert at(surprise, 1.1, "26") == 0.0
    assert at(surprise, 1.1, "25") == 0.0
    assert at(surprise, 3.0, "26") == 1.0


def test_muted_channels_stand_still_and_soloed_ones_move_alone() -> None:
    pair = Animation((still(0.5), replace(still(0.6, "12R"), muted=True), still(0.7, "17")))
    assert Evaluator(pair, UNITS).channels == ("17", "12L")
    solo = replace(pair, tracks=(*pair.tracks[:2], replace(pair.tracks[2], solo=True)))
    assert Evaluator(solo, UNITS).channels == ("17",)


def test_muted_events_and_life_are_left_out() -> None:
    quiet = Animation(events=(Event("a", ("12L",), 0.0, muted=True),), idle=Idle(muted=True))
    assert Evaluator(quiet, UNITS).channels == ()
    assert not STILL.moves


def test_a_clip_has_a_frame_at_its_start_and_its_end() -> None:
    clip = sampled(Animation((still(0.5),), rate=29.97, start=1.0, end=1.0 + 30 / 29.97), UNITS)
    assert len(clip.times) == 31
    assert (clip.times[0], clip.times[-1]) == (1.0, pytest.approx(1.0 + 30 / 29.97))
    assert clip.pose(3).weights == {"12L": 0.5}
    assert len(sampled(Animation((still(0.5),), end=5.0), UNITS, 12.0, (0.0, 2.0)).times) == 25


def test_channels_of_a_face_are_its_fields_and_the_rigid_motions() -> None:
    names = [channel.name for channel in channels(UNITS)]
    assert names[:2] == ["1L", "1R"]
    assert names[-10:-7] == ["head.yaw", "head.pitch", "head.roll"]
    assert [mirrored(name) for name in ("12L", "17", "head.yaw", "eyeR.yaw")] == ["12R", "17", "head.yaw", "eyeL.yaw"]
