"""Every command does what its help says; the faces and files are real, only the pictures are not drawn here."""

import dataclasses
import json
from collections.abc import Iterator, Set
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.cli import Screen, main
from app.cli.expression import asked_expression
from app.errors import NumberError
from app.film import Film
from facemodel.actions import Expression
from facemodel.animation.take import Take
from facemodel.cache import cached_solution
from facemodel.errors import UnknownNameError
from facemodel.faces import face_keys
from facemodel.io.export import EXPORTS
from facemodel.io.film import Picture
from facemodel.io.project_file import load_project, project_bytes, save_project
from facemodel.project import Project, Settings
from facemodel.projects import new_project
from facemodel.solve import Solution
from facemodel.superposition import Superposition
from tests.io.small_project import identical, small_project

COMMANDS = ("new", "solve", "info", "render", "export", "animate", "demo", "gallery", "edit")


class Paper:
    """Notes down what it is asked to draw."""

    display = True

    def __init__(self) -> None:
        self.asked: list[dict[str, Any]] = []

    def render(
        self,
        project: Project,
        solution: Solution,
        expression: Expression,
        path: Path,
        view: str,
        size: tuple[int, int],
        show: Set[str],
        linear: bool,
    ) -> None:
        asked = {"expression": dict(expression), "path": path, "view": view, "size": size, "show": show}
        self.asked.append(asked | {"linear": linear})

    def gallery(self, project: Project, solution: Solution, path: Path) -> None:
        self.asked.append({"fields": solution.basis.names, "path": path})

    def edit(self, path: Path | None, project: Project | None = None) -> int:
        self.asked.append({"edit": path if project is None else project})
        return 0

    def frames(self, take: Take, solution: Solution, film: Film) -> Iterator[Picture]:
        self.asked.append({"film": film, "fields": solution.basis.names, "times": take.sampled.times.tolist()})
        return iter(np.full((film.size[1], film.size[0], 3), frame, np.uint8) for frame in range(len(take)))

    @property
    def screen(self) -> Screen:
        return Screen(self.render, self.gallery, self.edit, self.frames, lambda: self.display)


@pytest.fixture
def paper() -> Paper:
    return Paper()


@pytest.fixture
def smile(tmp_path: Path) -> Path:
    path = tmp_path / "smile.risorius"
    save_project(small_project(), path)
    return path


@pytest.fixture
def empty_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "cache"
    monkeypatch.setenv("RISORIUS_CACHE", str(folder))
    return folder


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_explains_itself_with_examples(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, "--help"], Paper().screen) == 0
    text = capsys.readouterr().out
    assert text.startswith(f"usage: risorius {command}")
    assert f"examples:\n  risorius {command}" in text


def test_the_whole_explains_all_commands(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--help"], Paper().screen) == 0
    text = capsys.readouterr().out
    assert all(f"\n    {command} " in text for command in COMMANDS)


@pytest.mark.parametrize("key", face_keys())
def test_new_writes_a_project_on_the_face(tmp_path: Path, key: str, paper: Paper) -> None:
    out = tmp_path / "new.risorius"
    assert main(["new", str(out), "--face", key], paper.screen) == 0
    assert identical(load_project(out), new_project(key))


def test_new_takes_the_default_face_and_keeps_what_is_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], paper: Paper
) -> None:
    out = tmp_path / "new.risorius"
    out.write_text("precious")
    assert main(["new", str(out)], paper.screen) == 1
    assert "exists already" in capsys.readouterr().err
    assert out.read_text() == "precious"
    assert main(["new", str(out), "--replace"], paper.screen) == 0
    assert load_project(out).face.key == face_keys()[0]


def test_solve_keeps_the_solution_for_later(
    smile: Path, empty_cache: Path, capsys: pytest.CaptureFixture[str], paper: Paper
) -> None:
    assert main(["solve", str(smile)], paper.screen) == 0
    out, err = capsys.readouterr()
    assert out.startswith("Solved 4 fields with ")
    assert err.splitlines()[:2] == ["Assembling the skin", "Factorising the stiffness"]
    assert cached_solution(small_project()) is not None
    assert main(["solve", str(smile)], paper.screen) == 0
    out, err = capsys.readouterr()
    assert "solved already: 4 fields" in out
    assert err == ""


def test_info_tells_the_figures(
    smile: Path, empty_cache: Path, capsys: pytest.CaptureFixture[str], paper: Paper
) -> None:
    assert main(["info", str(smile), "--json"], paper.screen) == 0
    before = json.loads(capsys.readouterr().out)
    assert before["solved"] is False
    assert before["unknowns"] is None
    assert before["chart"]["flips"] == 0
    assert before["chart"]["worst_stretch"] >= before["chart"]["p95_stretch"] >= 1
    assert (before["face"]["vertices"], before["face"]["solved_triangles"]) == (25, 31)
    assert before["landmarks"]["pronasale"] == small_project().face.skin.positions[12].tolist()
    assert [unit["peak_mm"] for unit in before["units"]] == [None, None, None]
    assert before["expression"] == {"12L": 0.8, "26": 0.1}

    assert main(["solve", str(smile)], paper.screen) == 0
    capsys.readouterr()
    assert main(["info", str(smile), "--json"], paper.screen) == 0
    after = json.loads(capsys.readouterr().out)
    assert after["solved"] is True
    solution = cached_solution(small_project())
    assert solution is not None
    assert after["unknowns"] == solution.unknowns
    pose = Superposition(small_project().face, solution.basis)
    rest = pose.points.copy()
    for unit, expression in zip(after["units"], ({"12L": 1, "12R": 1}, {"18": 1}, {"26": 1}), strict=True):
        pose.pose(expression)
        assert unit["peak_mm"] == pytest.approx(np.linalg.norm(pose.points - rest, axis=1).max(), abs=1e-4)


def test_info_reads_well(smile: Path, capsys: pytest.CaptureFixture[str], paper: Paper) -> None:
    assert main(["info", str(smile)], paper.screen) == 0
    text = capsys.readouterr().out
    assert "0 flipped triangles" in text
    assert "in the 95th percentile" in text
    assert "lip corner puller" in text
    assert all(len(line) <= 100 for line in text.splitlines() if "file" not in line)


def test_render_hands_over_what_was_asked(smile: Path, tmp_path: Path, paper: Paper) -> None:
    out = tmp_path / "smile.png"
    words = ["--au", "18=0.5", "--emotion", "happiness=0.8", "--view", "left", "--size", "640x480"]
    assert main(["render", str(smile), str(out), *words, "--show", "skull, muscles"], paper.screen) == 0
    assert paper.asked == [
        {
            "expression": {"12L": 0.8, "12R": 0.8, "18": 0.5},
            "path": out,
            "view": "left",
            "size": (640, 480),
            "show": {"skull", "muscles"},
            "linear": False,
        }
    ]


def test_render_can_leave_it_at_the_pure_sum(smile: Path, tmp_path: Path, paper: Paper) -> None:
    assert main(["render", str(smile), str(tmp_path / "a.png"), "--linear"], paper.screen) == 0
    assert paper.asked[0]["linear"] is True


def test_eyes_and_head_are_asked_for_like_any_unit(tmp_path: Path, paper: Paper) -> None:
    """The units that turn them came with version 2; a project of version 1 gets them when it is opened."""
    old = Path(__file__).parents[1] / "io" / "schema-1.risorius"
    assert main(["render", str(old), str(tmp_path / "a.png"), "--au", "61=0.5", "--au", "head up=1"], paper.screen) == 0
    assert paper.asked[0]["expression"] == {"61": 0.5, "53": 1.0}


def test_render_without_weights_shows_what_was_saved(smile: Path, tmp_path: Path, paper: Paper) -> None:
    assert main(["render", str(smile), str(tmp_path / "a.png")], paper.screen) == 0
    assert paper.asked[0]["expression"] == {"12L": 0.8, "26": 0.1}
    assert paper.asked[0]["size"] == (1280, 960)


def test_gallery_hands_over_the_solution(smile: Path, tmp_path: Path, paper: Paper) -> None:
    assert main(["gallery", str(smile), str(tmp_path / "sheet.png")], paper.screen) == 0
    assert paper.asked == [{"fields": ("12L", "12R", "18", "26"), "path": tmp_path / "sheet.png"}]


def test_the_basis_sculpted_by_hand_can_be_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "ada.risorius"
    coarse = dataclasses.replace(new_project(), settings=Settings(element="hct9", density=1))
    save_project(coarse, path)
    origins: list[str] = []
    screen = Screen(
        lambda _project, solution, *_: origins.append(solution.basis.origin),
        lambda _project, solution, _path: origins.append(solution.basis.origin),
        lambda *_: 0,
        lambda *_: iter(()),
        lambda: False,
    )
    assert main(["gallery", str(path), str(tmp_path / "sheet.png"), "--basis", "sculpted"], screen) == 0
    assert main(["render", str(path), str(tmp_path / "face.png"), "--basis", "sculpted"], screen) == 0
    assert main(["render", str(path), str(tmp_path / "face.png")], screen) == 0
    assert origins == ["sculpted", "sculpted", "solved"]


def test_a_face_without_sculpted_units_says_so(
    smile: Path, tmp_path: Path, paper: Paper, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["gallery", str(smile), str(tmp_path / "sheet.png"), "--basis", "sculpted"], paper.screen) == 1
    assert "No sculpted units ship" in capsys.readouterr().err
    assert paper.asked == []


def test_edit_opens_what_is_named(smile: Path, paper: Paper) -> None:
    for words in ([], ["edit"], ["edit", str(smile)], [str(smile)]):
        assert main(words, paper.screen) == 0
    assert [asked["edit"] for asked in paper.asked] == [None, None, smile, smile]


@pytest.mark.parametrize("suffix", EXPORTS)
def test_export_writes_every_format(smile: Path, tmp_path: Path, suffix: str, paper: Paper) -> None:
    out = tmp_path / f"face{suffix.upper()}"
    assert main(["export", str(smile), str(out), "--emotion", "surprise=1"], paper.screen) == 0
    project = small_project().posed({"26": 0.7})
    solution = cached_solution(project)
    assert solution is not None
    reference = tmp_path / "reference"
    with open(reference, "wb") as stream:
        EXPORTS[suffix].write(project, solution, stream)
    assert out.read_bytes() == reference.read_bytes()


weights = st.floats(0, 2)


@given(weights, weights, weights)
def test_emotions_mix_by_the_larger_weight_and_single_units_override(joy: float, shock: float, pucker: float) -> None:
    project = dataclasses.replace(
        small_project(),
        emotions=(
            dataclasses.replace(small_project().emotions[0], weights={"12": 1.0, "26": 0.2}),
            small_project().emotions[1],
        ),
    )
    asked = asked_expression(project, [("happiness", joy), ("Surprise", shock)], [("18", pucker), ("12R", 0.25)])
    wanted = {
        "12L": joy,
        "12R": 0.25,
        "18": pucker,
        "26": max(0.2 * joy, 0.7 * shock),
    }
    assert {name: asked.get(name, 0.0) for name in wanted} == pytest.approx(wanted)
    assert set(asked) <= set(wanted)


@given(st.floats().filter(lambda weight: not 0 <= weight <= 2))
def test_weights_out_of_range_are_refused(weight: float) -> None:
    with pytest.raises(NumberError):
        asked_expression(small_project(), [], [("12", weight)])
    with pytest.raises(NumberError):
        asked_expression(small_project(), [("happiness", weight)], [])


def test_unknown_names_are_refused() -> None:
    with pytest.raises(UnknownNameError, match="no action unit “13”"):
        asked_expression(small_project(), [], [("13", 1.0)])
    with pytest.raises(UnknownNameError, match="no emotion “joy”"):
        asked_expression(small_project(), [("joy", 1.0)], [])


def test_nothing_that_is_only_read_is_changed(smile: Path, tmp_path: Path, paper: Paper) -> None:
    before = smile.read_bytes()
    for words in (["solve"], ["info"], ["render", str(tmp_path / "a.png")], ["export", str(tmp_path / "a.glb")]):
        assert main([words[0], str(smile), *words[1:]], paper.screen) == 0
    assert smile.read_bytes() == before == project_bytes(small_project())
