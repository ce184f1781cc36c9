"""``risorius animate`` and ``risorius demo``: captures and speech in, weights and projects out."""

from pathlib import Path

import numpy as np
import pytest

from app.cli import main
from facemodel.animation.demo import EMOTIONS, LENGTH, demo_animation
from facemodel.animation.evaluation import sampled
from facemodel.facs import action_units
from facemodel.io.project_file import load_project, save_project
from facemodel.io.weights import read_capture
from tests.cli.test_commands import Paper
from tests.io.small_project import small_project

GOLDEN = Path(__file__).resolve().parents[1] / "animation" / "golden"


@pytest.fixture
def smile(tmp_path: Path) -> Path:
    path = tmp_path / "smile.risorius"
    save_project(small_project(), path)
    return path


def run(*words: object) -> int:
    return main([str(word) for word in words], Paper().screen)


def test_a_capture_becomes_tracks_of_a_project(smile: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "played.risorius"
    assert run("animate", smile, out, "--capture", GOLDEN / "weights.csv", "--speech", GOLDEN / "rhubarb.json") == 0
    animation = load_project(out).animation
    assert {track.channel for track in animation.tracks} == {"12L", "12R", "26", "head.yaw"}
    assert len(animation.speech.phonemes) == 5
    told = capsys.readouterr()
    assert "4 tracks" in told.out
    assert "risorius: Columns that this face has nothing for were left out: unheard of." in told.err
    assert load_project(smile).animation.tracks == ()


def test_weights_are_written_at_the_rate_that_is_asked_for(smile: Path, tmp_path: Path) -> None:
    out = tmp_path / "weights.csv"
    assert run("animate", smile, out, "--capture", GOLDEN / "weights.csv", "--fps", 50) == 0
    capture = read_capture(out, small_project().units)
    assert (capture.rate, len(capture.values)) == (50.0, 5)
    assert run("animate", smile, out, "--capture", GOLDEN / "weights.csv", "--format", "arkit") == 0
    assert out.read_text().startswith("time,eyeBlinkLeft")


def test_what_does_not_fit_is_one_sentence(smile: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for words, says in (
        ((smile, tmp_path / "a.csv"), "nothing moves in this project"),
        ((smile, tmp_path / "a.mov", "--capture", GOLDEN / "weights.csv"), "animations are exported to .mp4, .webm"),
        ((smile, tmp_path / "a.csv", "--capture", tmp_path / "none.csv"), "there is no such file"),
        ((smile, tmp_path / "a.fap", "--capture", GOLDEN / "weights.csv", "--format", "arkit"), "files end in .csv"),
    ):
        assert run("animate", *words) == 1
        told = capsys.readouterr().err.strip().splitlines()[-1]
        assert says in told
        assert told.startswith("risorius: ")
    assert run("animate", smile, tmp_path / "a.csv", "--fps", "fast") == 2


def test_the_demo_shows_seven_emotions_a_line_and_blinks(tmp_path: Path) -> None:
    out = tmp_path / "demo.risorius"
    assert run("demo", out) == 0
    project = load_project(out)
    animation = project.animation
    assert animation.duration == LENGTH == 20.0
    assert [marker.name.lower() for marker in animation.markers[:7]] == list(EMOTIONS)
    assert [word.text for word in animation.speech.words][:2] == ["Hello", "my"]
    assert animation.idle is not None


PEAKS = {"12L": 0.7, "15L": 0.6, "26": 0.6, "9L": 0.7, "14R": 0.7, "43L": 0.9, "24": 0.25, "head.pitch": 5.0}


def test_every_part_of_the_demo_is_seen_and_nothing_but_lids_jumps() -> None:
    clip = sampled(demo_animation(action_units()), action_units(), 30.0)
    moved = dict(zip(clip.channels, np.abs(clip.values).max(axis=0).tolist(), strict=True))
    assert {name: moved[name] for name, least in PEAKS.items() if moved[name] < least} == {}
    calm = [k for k, name in enumerate(clip.channels) if "." not in name and not name.startswith("43")]
    assert np.abs(np.diff(clip.values[:, calm], axis=0)).max() < 0.45
    assert np.isfinite(clip.values).all()
