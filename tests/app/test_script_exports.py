"""Scripts export what is played in every format, and are told in a sentence what cannot be."""

import os
from pathlib import Path

import pytest

from app.document import Document
from app.scripting.console import run_script
from facemodel.project import Project
from facemodel.solution import Solution
from tests.io.animated import PROJECT, SOLUTION
from tests.io.glb_reader import Glb


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RISORIUS_CACHE", str(tmp_path_factory.mktemp("cache")))


@pytest.fixture
def document() -> Document:
    return solved_document(PROJECT, SOLUTION)


def solved_document(project: Project, solution: Solution) -> Document:
    made = Document(project)
    made.accept(solution, project)
    return made


def run(document: Document, text: str) -> str:
    outcome = run_script(text, document)
    assert outcome.error == ""
    return outcome.output


def test_a_script_writes_models_and_weights(document: Document, tmp_path: Path) -> None:
    model, weights = tmp_path / "face.glb", tmp_path / "face.csv"
    said = run(
        document,
        f"print(export_animation({str(model)!r}, shaping='clip', most=2, span=(0.0, 0.5)))\n"
        f"print(export_animation({str(weights)!r}, kind='live-link', rate=30.0))\n",
    )
    assert "2 shapes, 7 frames" in said
    assert "at 30 a second, 61 channels" in said
    assert len(Glb(model.read_bytes()).times) == 7
    assert weights.read_text().startswith("Timecode,")
    assert document.history.done == ()


def test_what_the_script_has_just_keyed_is_exported(document: Document, tmp_path: Path) -> None:
    out = tmp_path / "face.csv"
    run(document, f"key('26', 0.0, 0.25)\nexport_animation({str(out)!r})")
    heading, first, *_ = out.read_text().splitlines()
    assert dict(zip(heading.split(","), first.split(","), strict=True))["26"] == "0.25"


@pytest.mark.parametrize(
    ("call", "says"),
    [
        ("'face.glb', colour='red'", "There is no setting “colour”; choose one of"),
        ("'face.mp4', view='behind'", "There is no view “behind”; choose one of front"),
        ("'face.csv', kind='maya'", "There is no kind “maya”; choose one of .mp4"),
        ("'face.avi'", "animations are exported to .mp4"),
        ("'none/face.glb'", "there is no folder"),
        ("'face.glb', rate=1000.0", "choose 12 to 120"),
    ],
)
def test_what_cannot_be_exported_is_said(
    document: Document, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: str, says: str
) -> None:
    monkeypatch.chdir(tmp_path)
    assert says in run_script(f"export_animation({call})", document).error
    assert os.listdir(tmp_path) == []


def test_fields_of_another_face_are_never_taken(document: Document, tmp_path: Path) -> None:
    name = PROJECT.muscles[0].key
    text = f"muscle({name!r}).delete()\nexport_animation({str(tmp_path / 'face.glb')!r})"
    assert "has to be solved anew first" in run_script(text, document).error
    assert os.listdir(tmp_path) == []
