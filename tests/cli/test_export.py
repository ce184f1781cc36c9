"""``risorius export`` takes the animation along, as it is asked to."""

import os
from pathlib import Path

import pytest

from app.cli import Screen, main
from facemodel.io.export import EXPORTS, Asked
from facemodel.io.project_file import save_project
from tests.io.animated import PROJECT, SOLUTION
from tests.io.glb_reader import Glb


def unasked(*_: object) -> int:
    raise AssertionError("nothing is drawn")


NOTHING = Screen(unasked, unasked, unasked, unasked, unasked)


@pytest.fixture
def clip(tmp_path: Path) -> Path:
    path = tmp_path / "clip.risorius"
    save_project(PROJECT, path)
    return path


def exported(clip: Path, name: str, *words: str) -> Path:
    out = clip.with_name(name)
    assert main(["export", str(clip), str(out), *words], NOTHING) == 0
    return out


def test_a_model_plays_the_animation_and_says_how_well(clip: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = Glb(exported(clip, "a.glb", "--fps", "24", "--range", "0.5", "1").read_bytes())
    assert len(file.times) == 13
    said = capsys.readouterr().out
    assert "13 frames, within 0.0" in said
    assert said.rstrip().endswith("mm of the editor")


def test_the_animation_can_be_left_out(clip: Path) -> None:
    file = Glb(exported(clip, "a.glb", "--still").read_bytes())
    assert "animations" not in file.json
    assert file.meshes["skin"]["extras"]["targetNames"] == ["AU12", "AU12L", "AU12R", "AU18", "AU26", "posed"]


def test_few_shapes_can_be_asked_for(clip: Path) -> None:
    file = Glb(exported(clip, "a.glb", "--shapes", "clip", "--most", "2").read_bytes())
    assert len(file.meshes["skin"]["extras"]["targetNames"]) <= 2
    assert file.meshes["skin"]["extras"]["targetNames"][-1] == "shape 1"


def test_a_sequence_is_counted(clip: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exported(clip, "a.obj", "--sequence", "--range", "0f", "3f")
    assert "4 numbered files" in capsys.readouterr().out
    assert sorted(os.listdir(clip.parent)) == [f"a.000{n}.obj" for n in (1, 2, 3, 4)] + ["clip.risorius"]


def test_an_asked_expression_stands_under_the_animation(clip: Path) -> None:
    file = Glb(exported(clip, "a.glb", "--au", "18=0.5").read_bytes())
    assert "AU18" in file.meshes["skin"]["extras"]["targetNames"]


@pytest.mark.parametrize(
    ("out", "words", "status", "says"),
    [
        ("a.glb", ["--most", "0"], 2, "“0” is not a whole number above 0"),
        ("a.glb", ["--most", "1"], 1, "more than the 1 shapes that are allowed"),
        ("a.glb", ["--shapes", "all"], 2, "invalid choice"),
        ("a.glb", ["--range", "1", "0.5"], 1, "let the range end after its begin"),
        ("a.glb", ["--sequence"], 1, "one file of this format holds all frames"),
        ("a.obj", ["--sequence", "--still"], 1, "nothing moves in this project"),
    ],
)
def test_what_cannot_be_is_said_in_one_sentence(
    clip: Path, out: str, words: list[str], status: int, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["export", str(clip), str(clip.with_name(out)), *words], NOTHING) == status
    assert says in capsys.readouterr().err.splitlines()[-1]
    assert os.listdir(clip.parent) == ["clip.risorius"]


def test_the_command_writes_what_the_library_does(clip: Path, tmp_path: Path) -> None:
    out = exported(clip, "a.usdc", "--shapes", "clip")
    with open(tmp_path / "reference", "wb") as stream:
        EXPORTS[".usdc"].write(PROJECT, SOLUTION, stream, Asked(shaping="clip"))
    assert out.read_bytes() == (tmp_path / "reference").read_bytes()
