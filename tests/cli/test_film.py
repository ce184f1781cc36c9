"""``risorius animate`` films what it is asked to film; the frames are drawn by somebody else here."""

import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import av
import numpy as np
import pytest
from scipy.io import wavfile

from app.cli import Screen, main
from app.film import Film
from facemodel.animation.clip import Animation, Audio
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.take import Take
from facemodel.animation.track import Track
from facemodel.io.film.reel import Picture
from facemodel.io.project_file import save_project
from facemodel.solution import Cancelled, Solution
from tests.io.small_project import small_project

SMILE = Animation((Track("12L", curve_of([Key(0, 0.0), Key(1, 1.0)])),), end=1.0, rate=24.0)


class Camera:
    """Notes down what it is asked to film and gives grey pictures."""

    def __init__(self, ends_after: int = 10_000) -> None:
        self.film = Film()
        self.take: Take | None = None
        self._ends_after = ends_after

    def frames(self, take: Take, _solution: Solution, film: Film) -> Iterator[Picture]:
        self.film, self.take = film, take
        for frame in range(len(take)):
            if frame == self._ends_after:
                raise Cancelled
            yield np.full((film.size[1], film.size[0], 3), frame, np.uint8)

    @property
    def screen(self) -> Screen:
        return Screen(unasked, unasked, unasked, self.frames, unasked)


def unasked(*_: object) -> int:
    raise AssertionError("only a film was asked for")


def project_file(folder: Path, animation: Animation = SMILE) -> str:
    path = folder / "smile.risorius"
    save_project(replace(small_project(), animation=animation), path)
    return str(path)


def animate(folder: Path, *words: str, animation: Animation = SMILE, out: str = "smile.mp4") -> Camera:
    camera = Camera()
    assert main(["animate", project_file(folder, animation), str(folder / out), *words], camera.screen) == 0
    return camera


def test_a_film_shows_what_the_animation_plays_at_its_rate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    camera = animate(tmp_path)
    assert camera.take is not None
    assert camera.film == Film()
    assert camera.take.sampled.times == pytest.approx(np.arange(24) / 24)
    out, err = capsys.readouterr()
    assert out.endswith("smile.mp4: 24 frames, 1.00 s\n")
    assert err.splitlines()[-2:] == ["Filming", "Finishing the film"]
    with av.open(str(tmp_path / "smile.mp4")) as opened:
        assert opened.streams.video[0].frames == 24
        assert (opened.streams.video[0].width, opened.streams.video[0].height) == (1280, 720)


def test_sliders_that_are_not_animated_keep_their_weights(tmp_path: Path) -> None:
    take = animate(tmp_path, "--size", "32x32").take
    assert take is not None
    assert small_project().expression == {"12L": 0.8, "26": 0.1}
    assert take.expression(0) == {"12L": 0.0, "26": 0.1}
    assert take.expression(12)["12L"] == pytest.approx(0.5)


def test_every_option_is_handed_over(tmp_path: Path) -> None:
    camera = animate(
        tmp_path,
        *("--size", "64x48", "--fps", "60", "--range", "12f", "00:00:00:54", "--view", "three-quarter", "--close"),
        *("--turntable", "--antialias", "finest", "--no-audio", "--backdrop", "light"),
        out="smile.webm",
    )
    assert camera.film == Film(
        (64, 48), 60.0, (0.2, 0.9), "three-quarter", True, 1.0, "finest", audible=False, theme="light"
    )
    assert camera.take is not None
    assert len(camera.take) == 42


def test_its_sound_counts_from_the_folder_of_the_project(tmp_path: Path) -> None:
    wavfile.write(tmp_path / "line.wav", 8000, np.full(4000, 0.5, np.float32))
    spoken = replace(SMILE, audio=Audio("line.wav", start=0.25))
    animate(tmp_path, "--size", "32x32", animation=spoken)
    with av.open(str(tmp_path / "smile.mp4")) as opened:
        heard = np.concatenate([frame.to_ndarray() for frame in opened.decode(audio=0)], axis=1)
        loud = np.flatnonzero(np.abs(heard[0]) > 0.25) / opened.streams.audio[0].rate
    assert loud[0] == pytest.approx(0.25, abs=0.03)
    assert loud[-1] == pytest.approx(0.75, abs=0.03)
    for words, animation in ((["--no-audio"], spoken), ([], replace(spoken, audio=Audio("no.wav", muted=True)))):
        animate(tmp_path, "--size", "32x32", *words, animation=animation)
        with av.open(str(tmp_path / "smile.mp4")) as opened:
            assert not opened.streams.audio


def test_an_interrupted_film_leaves_the_one_before(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    animate(tmp_path, "--size", "32x32")
    before = (tmp_path / "smile.mp4").read_bytes()
    words = ["animate", project_file(tmp_path), str(tmp_path / "smile.mp4"), "--size", "64x64"]
    assert main(words, Camera(ends_after=7).screen) == 130
    assert capsys.readouterr().err.splitlines()[-1] == "risorius: stopped"
    assert (tmp_path / "smile.mp4").read_bytes() == before
    assert sorted(os.listdir(tmp_path)) == ["smile.mp4", "smile.risorius"]


@pytest.mark.parametrize(
    ("words", "status", "says"),
    [
        (["--range", "soon", "2"], 1, "“soon” is no time; write seconds such as 2.5"),
        (["--range", "2", "1"], 1, "from 2 s to 1 s has no frame"),
        (["--range", "0", "999999"], 1, "too many frames from 0 s to 999999 s"),
        (["--range", "1"], 2, "expected 2 arguments"),
        (["--fps", "1000"], 1, "choose 12 to 120 of them"),
        (["--fps", "fast"], 2, "is not a number of frames per second"),
        (["--size", "33x32"], 1, "even sides; choose 34x32"),
        (["--view", "behind"], 2, "three-quarter"),
    ],
)
def test_what_cannot_be_filmed_is_said_in_one_sentence(
    tmp_path: Path, words: list[str], status: int, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ["animate", project_file(tmp_path), str(tmp_path / "smile.mp4"), *words]
    assert main(asked, Camera().screen) == status
    last = capsys.readouterr().err.splitlines()[-1]
    assert last.startswith("risorius: ")
    assert says in last
    assert os.listdir(tmp_path) == ["smile.risorius"]


def test_a_face_that_does_not_move_is_no_film_but_a_turntable(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["animate", project_file(tmp_path, Animation()), str(tmp_path / "still.mp4"), "--size", "32x32"]
    assert main(words, Camera().screen) == 1
    assert "it has no keys, events or speech" in capsys.readouterr().err
    assert main([*words, "--turntable", "2"], Camera().screen) == 0


def test_a_sound_that_is_gone_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spoken = replace(SMILE, audio=Audio("gone.wav"))
    words = ["animate", project_file(tmp_path, spoken), str(tmp_path / "smile.mp4")]
    assert main(words, Camera().screen) == 1
    assert "gone.wav” cannot be opened: there is no such file" in capsys.readouterr().err
    assert os.listdir(tmp_path) == ["smile.risorius"]


@pytest.mark.parametrize(
    ("out", "words", "says", "files"),
    [
        ("smile.glb", (), "25 frames, within", ["smile.glb"]),
        ("smile.usdc", ("--shapes", "clip", "--most", "2"), "2 shapes, 25 frames", ["smile.usdc"]),
        ("smile.obj", ("--range", "0", "2f"), "3 numbered files", [f"smile.000{n}.obj" for n in (1, 2, 3)]),
        ("smile.ply", ("--range", "0", "0"), "1 numbered file\n", ["smile.0001.ply"]),
        ("smile.csv", (), "25 frames at 24 a second, every animated channel", ["smile.csv"]),
    ],
)
def test_an_animation_is_written_in_every_other_format_too(
    tmp_path: Path, out: str, words: tuple[str, ...], says: str, files: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    animate(tmp_path, *words, out=out)
    assert says in capsys.readouterr().out
    assert sorted(os.listdir(tmp_path)) == sorted([*files, "smile.risorius"])


def test_what_needs_no_displacement_is_not_solved_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    animate(tmp_path, out="smile.csv")
    assert capsys.readouterr().err == ""
