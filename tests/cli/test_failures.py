"""Whatever is wrong, the command line says it in one sentence on stderr and ends with a status that is not zero."""

import dataclasses
import os
from pathlib import Path
from typing import NoReturn

import numpy as np
import pytest

from app.cli import Screen, main
from facemodel.io.project_file import project_bytes, save_project
from tests.io.small_project import small_project


def not_drawn(*_: object) -> NoReturn:
    raise AssertionError("nothing may be drawn after a failure")


NOTHING = Screen(not_drawn, not_drawn, not_drawn, not_drawn, not_drawn)


@pytest.fixture
def smile(tmp_path: Path) -> Path:
    path = tmp_path / "smile.risorius"
    save_project(small_project(), path)
    return path


def sentence(words: list[str], status: int, capsys: pytest.CaptureFixture[str]) -> str:
    assert main(words, NOTHING) == status
    out, err = capsys.readouterr()
    assert out == ""
    *_, last = err.splitlines()
    assert last.startswith("risorius: ")
    assert last.endswith(".")
    assert "Traceback" not in err
    return last


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--au", "12=a lot"], "“a lot” in “12=a lot” is not a number"),
        (["--au", "12="], "is not a number"),
        (["--au", "12"], "such as 12=0.8"),
        (["--au", "=1"], "such as 12=0.8"),
        (["--emotion", "happiness"], "such as 12=0.8"),
        (["--size", "big"], "such as 1280x960"),
        (["--size", "0x0"], "choose 16 to 8192 pixels"),
        (["--size", "-5x10"], "--size"),
        (["--size", "99999x99999"], "choose 16 to 8192 pixels"),
        (["--size", "1280"], "such as 1280x960"),
        (["--view", "behind"], "three-quarter"),
        (["--show", "skull,brain"], "nothing called “brain”"),
    ],
)
def test_options_that_make_no_sense(
    smile: Path, tmp_path: Path, words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    said = sentence(["render", str(smile), str(tmp_path / "a.png"), *words], 2, capsys)
    assert says in said
    assert "risorius render --help" in said


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--au", "13=1"], "no action unit “13”"),
        (["--au", "18L=1"], "has no left and right"),
        (["--emotion", "joy=1"], "no emotion “joy”; choose one of happiness, surprise"),
        (["--au", "12=nan"], "weight nan of action unit 12"),
        (["--au", "12=inf"], "weight inf of action unit 12"),
        (["--au", "12=-1"], "weight -1 of action unit 12"),
        (["--emotion", "happiness=nan"], "strength nan of happiness"),
        (["--emotion", "happiness=1e999"], "strength inf of happiness"),
    ],
)
@pytest.mark.parametrize("command", ["render", "export"])
def test_weights_that_cannot_be(
    smile: Path, tmp_path: Path, command: str, words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / {"render": "a.png", "export": "a.glb"}[command]
    assert says in sentence([command, str(smile), str(out), *words], 1, capsys)
    assert not out.exists()


def test_commands_and_faces_that_are_not_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "invalid choice" in sentence(["smile"], 2, capsys)
    assert "--speed" in sentence(["info", "a.risorius", "--speed"], 2, capsys)
    assert "PROJECT" in sentence(["solve"], 2, capsys)
    said = sentence(["new", str(tmp_path / "a.risorius"), "--face", "eve"], 1, capsys)
    assert "no face “eve”; choose one of ada" in said
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("command", ["solve", "info", "render", "export", "gallery"])
@pytest.mark.parametrize(
    ("data", "says"),
    [
        (None, "no such file"),
        (b"", "not a Risorius file"),
        (b"PK\x03\x04 half", "not a Risorius file"),
        (project_bytes(small_project())[:-100], "cut short"),
        (project_bytes(small_project()).replace(b"PK\x01\x02", b"PK\x01\x03"), "not a Risorius file"),
    ],
)
def test_projects_that_cannot_be_opened(
    tmp_path: Path, command: str, data: bytes | None, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "broken.risorius"
    if data is not None:
        path.write_bytes(data)
    out = {"render": ["a.png"], "export": ["a.obj"], "gallery": ["a.png"]}.get(command, [])
    said = sentence([command, str(path), *(str(tmp_path / name) for name in out)], 1, capsys)
    assert f"“{path}” cannot be opened" in said
    assert says in said


@pytest.mark.parametrize(
    ("command", "out", "says"),
    [
        ("render", "none/a.png", "there is no folder"),
        ("render", "a.tiff", "end in .png"),
        ("render", "", "end in .png"),
        ("gallery", "none/a.png", "there is no folder"),
        ("gallery", "sheet", "end in .png"),
        ("animate", "none/a.mp4", "there is no folder"),
        ("animate", "a.avi", "animations are exported to .mp4, .webm, .png, "),
        ("export", "none/a.glb", "there is no folder"),
        ("export", "a.fbx", "end in .glb, .usdc, .usda, .npz, .obj or .ply"),
        ("export", "smile.risorius/a.glb", "there is no folder"),
        ("new", "none/a.risorius", "there is no folder"),
        ("new", "", "is a folder"),
    ],
)
def test_targets_that_cannot_be_written_are_found_before_the_work(
    smile: Path, tmp_path: Path, command: str, out: str, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    project = [] if command == "new" else [str(smile)]
    assert main([command, *project, str(tmp_path / out)], NOTHING) == 1
    said = capsys.readouterr().err
    assert says in said
    assert len(said.splitlines()) == 1
    assert os.listdir(tmp_path) == ["smile.risorius"]


def test_a_face_that_nothing_holds(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project = small_project()
    layers = dataclasses.replace(
        project.face.layers,
        stiffness=np.zeros_like(project.face.layers.stiffness),
        supports=np.zeros_like(project.face.layers.supports),
    )
    face = dataclasses.replace(project.face, layers=layers, solved=np.ones_like(project.face.solved))
    path = tmp_path / "loose.risorius"
    save_project(dataclasses.replace(project, face=face), path)
    said = sentence(["solve", str(path)], 1, capsys)
    assert "loose around skin vertex" in said
    assert "support" in said


def test_a_face_whose_chart_is_folded(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project = small_project()
    chart = project.face.chart.copy()
    chart[12] += 60.0
    path = tmp_path / "folded.risorius"
    save_project(dataclasses.replace(project, face=dataclasses.replace(project.face, chart=chart)), path)
    said = sentence(["solve", str(path)], 1, capsys)
    assert "Sheet (made up)" in said
    assert "flipped" in said


def test_a_cache_that_cannot_be_written(
    smile: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("RISORIUS_CACHE", str(smile))
    said = sentence(["solve", str(smile)], 1, capsys)
    assert "RISORIUS_CACHE" in said
    assert main(["export", str(smile), str(tmp_path / "a.obj")], NOTHING) == 0


def test_an_interrupt_ends_with_130(smile: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def interrupted(*_: object) -> NoReturn:
        raise KeyboardInterrupt

    screen = Screen(interrupted, not_drawn, not_drawn, not_drawn, not_drawn)
    assert main(["render", str(smile), str(tmp_path / "a.png")], screen) == 130
    assert capsys.readouterr().err.splitlines()[-1] == "risorius: stopped"
