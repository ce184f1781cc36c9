"""risorius calibrate: the figures of measured expressions, printed and written; what is wrong is said in a sentence."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.cli import main
from facemodel.calibration.compare import vertex_fields
from facemodel.io.project_file import save_project
from facemodel.project import Settings
from facemodel.projects import new_project
from facemodel.solve import solve_project
from tests.cli.test_commands import Paper
from tests.facemodel.calibration.heads import arrays, write
from tests.io.small_project import small_project

SET_A = Path(__file__).resolve().parents[3] / "shared" / "data" / "scanned-expressions" / "ict_face_set_a.npz"
"""Test data that never ships; without it the test that reads it says so and is skipped."""


@pytest.fixture(scope="module")
def dayo(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a file of the old man, moved by his own muscles as our solver moves him, lying on his side."""
    project = replace(new_project("dayo"), settings=Settings("hct9", 1))
    fields = vertex_fields(project.face, solve_project(project).basis)
    measured = {
        "mouthSmileLeft": fields["12L"],
        "browDown_R": fields["4R"],
        "mouthPucker": fields["18L"] + fields["18R"],
    }
    measured |= {"tongueOut": np.zeros_like(fields["12L"]), "grumpyFace": fields["17"]}
    contents = arrays(project.face, list(measured), np.array(list(measured.values())))
    return write(tmp_path_factory.mktemp("measured") / "dayo.npz", contents)


def test_an_atlas_carried_to_another_head_moves_it_as_its_own_does(
    dayo: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "report.json"
    assert main(["calibrate", str(dayo), "--report-only", "-o", str(out)], Paper().screen) == 0
    report = json.loads(out.read_text(encoding="utf-8"))
    rows = {row["name"]: row for row in report["expressions"]}
    assert list(rows) == ["mouthSmileLeft", "browDown_R", "mouthPucker"]
    assert rows["mouthSmileLeft"]["fields"] == {"12L": 1}
    assert rows["mouthPucker"]["fields"] == {"18L": 1, "18R": 1}
    for row in rows.values():
        assert 0.9 < row["cosine"] <= 1.0
        assert row["explained"] == pytest.approx(row["cosine"] ** 2, abs=1e-6)
        assert 0.5 < row["factor"] < 2.0
        assert row["direction"] < 20.0
        assert 0.0 < row["rms"] < row["largest"] < row["measured"]
    assert report["mean_cosine"] == pytest.approx(np.mean([row["cosine"] for row in rows.values()]))
    assert set(report["left_out"]) == {"tongueOut", "grumpyFace"}
    said = capsys.readouterr().out
    assert f"{report['mean_cosine']:.3f}" in said
    assert "grumpyFace is no name of an ARKit face unit" in said


@pytest.mark.skipif(not SET_A.exists(), reason=f"the measured set is not at {SET_A}")
def test_the_shipped_anatomy_meets_the_measured_set(tmp_path: Path) -> None:
    out = tmp_path / "report.json"
    assert main(["calibrate", str(SET_A), "--report-only", "-o", str(out)], Paper().screen) == 0
    report = json.loads(out.read_text(encoding="utf-8"))
    assert len(report["expressions"]) == 12
    assert report["mean_cosine"] > 0.85
    assert report["worst_cosine"] > 0.75


def test_a_project_on_the_default_head_is_compared_with_what_an_artist_sculpted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "default.risorius"
    save_project(replace(new_project(), settings=Settings("hct9", 1)), path)
    assert main(["calibrate", str(path)], Paper().screen) == 0
    said = capsys.readouterr().out
    assert "mouthSmileLeft (AU 12L)" in said
    assert "eyeLookDownLeft turns the eyeball" in said
    assert "mean" in said


def test_what_cannot_be_compared_is_refused_in_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bad = tmp_path / "bad.npz"
    np.savez(bad, neutral=np.zeros((3, 3)))
    own = tmp_path / "own.risorius"
    save_project(small_project(), own)
    for asked, says in (
        ([str(tmp_path / "none.npz")], "cannot be read"),
        ([str(bad)], "has no array “triangles”"),
        ([str(own)], "No sculpted units ship"),
        ([str(bad), "-o", str(tmp_path / "nowhere" / "report.json")], "nowhere"),
    ):
        assert main(["calibrate", *asked], Paper().screen) == 1
        error = capsys.readouterr().err
        assert says in error
        assert error.count("\n") <= 2
