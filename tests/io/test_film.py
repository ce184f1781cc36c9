"""Films hold the pictures and the sound they were given, and nothing is left of one that was not finished."""

import os
import subprocess
import sys
from pathlib import Path

import av
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from facemodel.animation.sound import Sound, stretch
from facemodel.errors import ProjectError
from facemodel.io.film import FILMS, filming
from facemodel.io.film.reel import Picture, Reel
from facemodel.solution import Cancelled

SIZE, RATE, FRAMES = (96, 64), 24.0, 36
VIDEOS = [suffix for suffix, film in FILMS.items() if film.sounds]
SKIN = (213, 167, 143)


def picture(number: int) -> Picture:
    """A ground of the colour of skin with a white bar that wanders to the right."""
    made = np.empty((SIZE[1], SIZE[0], 3), dtype=np.uint8)
    made[:] = SKIN
    made[:, 2 * number : 2 * number + 16] = 255
    return made


def tone(rate: int = 22_050, channels: int = 1) -> Sound:
    """A tone that sets in after half a second and lasts as long as the film."""
    time = np.arange(round(rate * FRAMES / RATE)) / rate
    wave = np.where(time >= 0.5, 0.5 * np.sin(2 * np.pi * 440 * time), 0.0).astype(np.float32)
    return Sound(np.repeat(wave[:, None], channels, axis=1), rate)


def filmed(path: Path, sound: Sound | None = None, rate: float = RATE) -> None:
    with filming(path, Reel(SIZE, rate, FRAMES, sound, "Ada")) as writer:
        for number in range(FRAMES):
            writer.add(picture(number))


def stopped(path: Path, after: int) -> None:
    """Stop filming after some other pictures."""
    with filming(path, Reel(SIZE, RATE, FRAMES, tone())) as writer:
        for number in range(after):
            writer.add(picture(number + 20))
        raise Cancelled


@pytest.mark.parametrize("suffix", VIDEOS)
def test_a_video_shows_every_picture_once_in_its_colours(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"face{suffix}"
    filmed(path)
    with av.open(str(path)) as opened:
        stream = opened.streams.video[0]
        assert (stream.width, stream.height, stream.average_rate) == (*SIZE, RATE)
        assert opened.metadata["title"] == "Ada"
        assert not opened.streams.audio
        seen = [frame.to_ndarray(format="rgb24").astype(int) for frame in opened.decode(video=0)]
    assert len(seen) == FRAMES
    for number, frame in enumerate(seen):
        assert np.abs(frame - picture(number)).mean() < 4
    assert np.abs(seen[0][:, 40:].mean(axis=(0, 1)) - SKIN).max() < 3


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize("suffix", VIDEOS)
def test_the_sound_is_heard_when_it_should_be(tmp_path: Path, suffix: str, channels: int) -> None:
    path = tmp_path / f"face{suffix}"
    filmed(path, tone(channels=channels))
    with av.open(str(path)) as opened:
        rate = opened.streams.audio[0].rate
        parts = [frame.to_ndarray() for frame in opened.decode(audio=0)]
    heard = np.concatenate(parts, axis=1)
    assert heard.shape[0] == channels
    assert heard.shape[1] / rate == pytest.approx(FRAMES / RATE, abs=0.05)
    loud = np.abs(heard[0]) > 0.1
    assert np.flatnonzero(loud)[0] / rate == pytest.approx(0.5, abs=0.03)


@pytest.mark.parametrize(
    ("rate", "exact"), [(29.97, "30000/1001"), (30_000 / 1001, "30000/1001"), (23.976, "24000/1001"), (12.5, "25/2")]
)
def test_rates_are_exact(tmp_path: Path, rate: float, exact: str) -> None:
    path = tmp_path / "face.mp4"
    filmed(path, rate=rate)
    with av.open(str(path)) as opened:
        assert str(opened.streams.video[0].average_rate) == exact


def test_pictures_are_numbered_from_one(tmp_path: Path) -> None:
    filmed(tmp_path / "face.png", tone())
    assert sorted(os.listdir(tmp_path)) == [f"face.{number:04}.png" for number in range(1, FRAMES + 1)]
    with Image.open(tmp_path / "face.0008.png") as opened:
        assert np.array_equal(np.asarray(opened), picture(7))


@pytest.mark.parametrize("suffix", FILMS)
@pytest.mark.parametrize("after", [0, 1, FRAMES - 1])
def test_a_cancelled_film_leaves_the_one_before_and_nothing_else(tmp_path: Path, suffix: str, after: int) -> None:
    path = tmp_path / f"face{suffix}"
    filmed(path)
    before = {each.name: each.read_bytes() for each in tmp_path.iterdir()}
    with pytest.raises(Cancelled):
        stopped(path, after)
    assert {each.name: each.read_bytes() for each in tmp_path.iterdir()} == before


@given(st.floats(-1, 1), st.floats(0.01, 1))
def test_a_stretch_of_sound_is_as_long_as_asked_for_and_silent_outside(start: float, duration: float) -> None:
    heard = stretch(Sound(np.ones((500, 1), np.float32), 1000), start, duration)
    assert len(heard.samples) == round(1000 * duration)
    time = np.arange(len(heard.samples)) + round(1000 * start)
    assert np.array_equal(heard.samples[:, 0] == 1, (time >= 0) & (time < 500))


def test_a_suffix_without_a_format_is_named_with_those_there_are(tmp_path: Path) -> None:
    with (
        pytest.raises(ProjectError, match=r"face\.avi.*end in \.mp4, \.webm or \.png"),
        filming(tmp_path / "face.avi", Reel(SIZE, RATE, 1)),
    ):
        pass
    assert os.listdir(tmp_path) == []


def test_videos_have_even_sides(tmp_path: Path) -> None:
    with (
        pytest.raises(ProjectError, match="even sides; choose 96x66"),
        filming(tmp_path / "face.mp4", Reel((95, 65), RATE, 1)),
    ):
        pass
    assert os.listdir(tmp_path) == []


def test_without_the_encoder_one_sentence_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(ProjectError, match=r"pip install av.*\.png") as caught:
        filmed(tmp_path / "face.mp4")
    assert len(str(caught.value).splitlines()) == 1
    assert os.listdir(tmp_path) == []
    filmed(tmp_path / "face.png")


LIMITED = """
import resource, sys
from pathlib import Path
from facemodel.animation.sound import Sound, stretch
from facemodel.errors import ProjectError
from tests.io.test_film import filmed, tone
resource.setrlimit(resource.RLIMIT_FSIZE, (150, 150))
for name in sys.argv[1:]:
    try:
        filmed(Path(name), tone())
    except ProjectError as error:
        print(error)
"""


@pytest.mark.skipif(os.name == "nt", reason="limits of POSIX systems")
def test_a_film_that_does_not_fit_leaves_the_previous_one(tmp_path: Path) -> None:
    paths = [tmp_path / f"face{suffix}" for suffix in FILMS]
    for path in paths:
        path.write_text("precious")
    run = subprocess.run(
        [sys.executable, "-c", LIMITED, *map(str, paths)], capture_output=True, text=True, check=True, cwd=Path.cwd()
    )
    assert run.stdout.count("choose another disk") == len(FILMS), run.stdout + run.stderr
    assert all(path.read_text() == "precious" for path in paths)
    assert len(os.listdir(tmp_path)) == len(FILMS)
