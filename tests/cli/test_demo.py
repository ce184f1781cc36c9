"""``risorius demo`` opens where there is a display, and films where there is none."""

import os
from pathlib import Path

import av
import numpy as np
import pytest

from app.cli import main
from app.speech import espeak_program
from facemodel.animation.demo import LENGTH, SPOKEN_AT
from facemodel.io.project_file import load_project
from facemodel.project import Project
from tests.cli.test_commands import Paper


@pytest.fixture
def silent(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine without a voice."""
    monkeypatch.setenv("PATH", "")


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_with_a_display_it_opens(silent: None) -> None:
    paper = Paper()
    assert main(["demo", "--face", "ben"], paper.screen) == 0
    project = paper.asked[0]["edit"]
    assert isinstance(project, Project)
    assert project.face.key == "ben"
    assert project.animation.end == LENGTH


def test_without_a_display_it_is_filmed_and_says_where(silent: None, capsys: pytest.CaptureFixture[str]) -> None:
    paper = Paper()
    paper.display = False
    assert main(["demo", "--size", "32x32", "--fps", "12"], paper.screen) == 0
    out = capsys.readouterr().out
    assert out.startswith("There is no display here, so the demo is filmed into risorius-demo.mp4\n")
    assert os.listdir() == ["risorius-demo.mp4"]
    with av.open("risorius-demo.mp4") as opened:
        assert opened.streams.video[0].frames == LENGTH * 12
        assert not opened.streams.audio
    assert paper.asked[0]["film"].close


def test_a_part_of_it_can_be_filmed(silent: None) -> None:
    paper = Paper()
    words = ["demo", "part.webm", "--size", "32x32", "--range", "1", "2", "--no-close"]
    assert main(words, paper.screen) == 0
    assert len(paper.asked[0]["times"]) == 30
    assert not paper.asked[0]["film"].close


@pytest.mark.skipif(espeak_program() is None, reason="eSpeak NG is not installed")
def test_with_a_voice_the_line_is_heard_when_it_is_said() -> None:
    assert main(["demo", "demo.mp4", "--size", "32x32", "--fps", "12"], Paper().screen) == 0
    assert os.listdir() == ["demo.mp4"]
    with av.open("demo.mp4") as opened:
        rate = opened.streams.audio[0].rate
        heard = np.concatenate([frame.to_ndarray() for frame in opened.decode(audio=0)], axis=1)[0]
    loud = np.flatnonzero(np.abs(heard) > 0.1) / rate
    phonemes = spoken("demo.risorius")
    assert SPOKEN_AT < loud[0] < SPOKEN_AT + 0.3
    assert loud[0] == pytest.approx(phonemes[0], abs=0.15)
    assert loud[-1] == pytest.approx(phonemes[1], abs=0.3)


def spoken(name: str) -> tuple[float, float]:
    """When the first sound of the project begins and the last ends."""
    assert main(["demo", name], Paper().screen) == 0
    project = load_project(Path(name))
    assert project.animation.audio is not None
    assert project.animation.audio.path == Path(name).with_suffix(".wav").name
    phonemes = project.animation.speech.phonemes
    return phonemes[0].start, phonemes[-1].end
