"""Weights for other programs: golden files by hand, and back in as what they were."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.clip import Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.evaluation import Sampled, sampled
from facemodel.animation.mapping import default_mapping, mapped
from facemodel.animation.track import Track
from facemodel.errors import ProjectError
from facemodel.facs import action_units
from facemodel.io.weights.fap import FAPS
from facemodel.io.weights.live_link import read_live_link
from facemodel.io.weights.names import ARKIT
from facemodel.io.weights.plain import read_plain
from facemodel.io.weights.writing import (
    WEIGHT_EXPORTS,
    Animated,
    arkit_values,
    export_weights,
    live_link_text,
    plain_text,
)
from tests.io.small_project import small_face

UNITS = action_units()

SMALL = Sampled(
    25.0,
    np.array([0.0, 0.04, 0.08]),
    ("12L", "26", "head.yaw"),
    np.array([[0.0, 0.0, 0.0], [0.5, 0.25, 10.0], [1.0, 0.5, -10.0]]),
)


def animated(clip: Sampled = SMALL) -> Animated:
    return Animated(clip, UNITS, small_face())


def test_plain_weights_are_this_text() -> None:
    assert plain_text(animated()) == ("time,12L,26,head.yaw\n0,0,0,0\n0.04,0.5,0.25,10\n0.08,1,0.5,-10\n")


def test_live_link_is_this_table() -> None:
    heading, first, second, third, *rest = live_link_text(animated()).split("\n")
    assert rest == [""]
    names = heading.split(",")
    assert names[:4] == ["Timecode", "BlendShapeCount", "EyeBlinkLeft", "EyeLookDownLeft"]
    assert names[-3:] == ["RightEyeYaw", "RightEyePitch", "RightEyeRoll"]
    assert len(names) == 63
    assert first == ",".join(["00:00:00:00.000", "61", *["0.00000000"] * 61])
    row = dict(zip(names, second.split(","), strict=True))
    assert row["Timecode"] == "00:00:00:01.000"
    assert (row["MouthSmileLeft"], row["JawOpen"], row["HeadYaw"]) == ("0.52500000", "0.13000000", "0.17453290")
    assert third.startswith("00:00:00:02.000,61,")


def test_arkit_weights_have_its_own_names_and_stay_from_0_to_1(tmp_path: Path) -> None:
    path = tmp_path / "out.csv"
    export_weights(animated(replace(SMALL, values=SMALL.values * 1.8)), path, "arkit")
    heading, *rows = path.read_text().splitlines()
    assert heading.split(",")[:3] == ["time", "eyeBlinkLeft", "eyeLookDownLeft"]
    assert len(heading.split(",")) == 53
    values = np.array([[float(cell) for cell in row.split(",")[1:]] for row in rows])
    assert values.min() == 0.0
    assert values.max() == 1.0


@given(st.lists(st.floats(0, 1), min_size=4, max_size=4), st.floats(-40, 40))
def test_plain_weights_come_back_as_they_were(weights: list[float], yaw: float) -> None:
    values = np.outer([0.0, 0.5, 1.0, 0.25], [*weights, yaw])
    clip = Sampled(50.0, np.arange(4) / 50, ("12L", "12R", "26", "43L", "head.yaw"), values)
    capture = read_plain(plain_text(animated(clip)).encode(), UNITS)
    assert capture.channels == clip.channels
    assert capture.rate == 50.0
    assert capture.values == pytest.approx(values, abs=1e-5)


@pytest.mark.parametrize(
    "name",
    ["43L", "43R", "7L", "5R", "4L", "2R", "6L", "9R", "12L", "12R", "15L", "14R", "20L", "16R", "10L", "22", "26"],
)
def test_a_unit_that_arkit_has_comes_back_through_live_link(name: str) -> None:
    clip = Sampled(60.0, np.arange(3) / 60, (name,), np.array([[0.0], [0.3], [0.6]]))
    capture = read_live_link(live_link_text(animated(clip)).encode())
    found = {t.channel: t.captured.values for t in mapped(capture, default_mapping("live-link"), UNITS).tracks}  # type: ignore[union-attr]
    assert found[name][2] == pytest.approx(0.6, abs=0.2)
    assert all(values[2] < found[name][2] / 2 for other, values in found.items() if other != name)


def test_turns_of_head_and_eyes_come_back_through_live_link() -> None:
    channels = ("head.yaw", "head.pitch", "head.roll", "eyeL.yaw", "eyeR.pitch")
    values = np.array([[0, 0, 0, 0, 0], [10, -5, 3, 8, -6], [-10, 5, -3, -8, 6.0]])
    clip = Sampled(60.0, np.arange(3) / 60, channels, values)
    capture = read_live_link(live_link_text(animated(clip)).encode())
    tracks = mapped(capture, default_mapping("live-link"), UNITS).tracks
    found = {track.channel: track.captured.values for track in tracks}  # type: ignore[union-attr]
    for name, column in zip(channels, values.T, strict=True):
        assert found[name] == pytest.approx(column, abs=0.01)


def test_a_clip_at_a_rate_of_television_keeps_its_times() -> None:
    track = Track("26", curve_of([Key(0, 0, "linear"), Key(10, 1)]))
    clip = sampled(Animation((track,), rate=29.97, end=10.0), UNITS)
    capture = read_live_link(live_link_text(animated(clip)).encode())
    assert capture.rate == pytest.approx(29.97)
    assert len(capture.values) == len(clip.times)


def test_looks_are_told_to_arkit_by_side() -> None:
    clip = Sampled(30.0, np.zeros(2), ("eyeL.yaw", "eyeR.yaw"), np.array([[17.5, 17.5], [-17.5, -17.5]]))
    values = arkit_values(animated(clip))
    assert [values[f"EyeLook{way}"].tolist() for way in ("OutLeft", "InLeft")] == [
        pytest.approx([0.5, 0.0]),
        pytest.approx([0.0, 0.5]),
    ]
    assert values["EyeLookInRight"] == pytest.approx([0.5, 0.0])
    assert set(ARKIT) <= values.keys()


@pytest.mark.parametrize(
    ("name", "kind", "says"),
    [
        ("a.csv", "tea", "no format “tea”"),
        ("a.txt", "arkit", "files end in .csv"),
        ("a.fap", "fap", "solve the face first"),
        ("nowhere/a.csv", "weights", "no folder"),
    ],
)
def test_what_cannot_be_written_is_said(tmp_path: Path, name: str, kind: str, says: str) -> None:
    with pytest.raises(ProjectError, match=says):
        export_weights(animated(), tmp_path / name, kind)


def test_every_format_says_what_it_is() -> None:
    assert list(WEIGHT_EXPORTS) == ["weights", "arkit", "live-link", "fap"]
    assert len(FAPS) == 68
