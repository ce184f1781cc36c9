"""What the benchmarks stand on: an honest verdict, times taken in turns, and a refined face that is still one."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from benchmarks.figure import Figure, compared, interleaved
from benchmarks.report import table, write
from benchmarks.shapes import default_face, drawn, random_basis, refined
from facemodel.chart import chart_figures
from facemodel.face import Face
from facemodel.superposition import Superposition


@pytest.fixture(scope="module")
def fine() -> Face:
    return refined(default_face(), 5000)


def test_a_ratio_over_its_limit_is_a_miss_and_none_is_no_verdict() -> None:
    assert Figure("a", 1.0, "s", "b", 1.3, 1.3).verdict == "pass"
    assert Figure("a", 1.0, "s", "b", 1.31, 1.3).verdict == "MISS"
    assert Figure("a", 1.0, "s", "b", 1.31).verdict == Figure("a").verdict == ""


def test_a_ratio_is_the_median_of_pairs_and_not_the_ratio_of_medians() -> None:
    busy = np.array([1.0, 1.0, 30.0])
    figure = compared("a", busy, "b", busy / 2, 1.5)
    assert figure.ratio == 2.0
    assert (figure.value, figure.unit) == (1.0, "s")


def test_steps_are_taken_in_turns_after_one_that_does_not_count() -> None:
    order: list[str] = []
    taken = interleaved({"a": lambda: order.append("a"), "b": lambda: order.append("b")}, 3)
    assert order == ["a", "b"] * 4
    assert {name: seconds.shape for name, seconds in taken.items()} == {"a": (3,), "b": (3,)}


def test_the_table_is_for_people_and_the_file_for_programs(tmp_path: Path) -> None:
    figures = [Figure("a remark"), Figure("sum", 12.345, "ms", "copy", 1.2345, 1.3)]
    assert table(figures).splitlines()[2].split() == ["sum", "12.3", "ms", "copy", "1.23", "1.3", "pass"]
    path = tmp_path / "results" / "latest.json"
    write(path, {"cores": 2}, {"superposition": figures}, {"start": "there is no display"})
    found = json.loads(path.read_text())
    assert found["figures"]["superposition"][1] == {
        "what": "sum",
        "value": 12.345,
        "unit": "ms",
        "against": "copy",
        "ratio": 1.2345,
        "limit": 1.3,
        "verdict": "pass",
    }
    assert found["unmeasured"] == {"start": "there is no display"}


def test_a_refined_face_has_the_vertices_asked_for_and_no_cracks(fine: Face) -> None:
    coarse = default_face()
    assert len(fine.skin.positions) == 5000
    assert len(fine.skin.boundary_loops) == len(coarse.skin.boundary_loops)
    counts = [len(face.skin.positions) - len(face.skin.edges) + len(face.skin.triangles) for face in (coarse, fine)]
    assert counts[0] == counts[1]
    assert np.abs(fine.skin.positions[: len(coarse.skin.positions)] - coarse.skin.positions).max() < 1e-9


def test_a_refined_face_has_the_same_chart_and_solved_part(fine: Face) -> None:
    coarse = default_face()
    areas = []
    for face in (coarse, fine):
        assert chart_figures(face.skin, face.chart).flips == 0
        u, v = np.swapaxes(face.chart[face.skin.triangles[face.solved]], 0, 2)
        areas.append(((u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0])).sum() / 2)
    assert areas[1] == pytest.approx(areas[0])


def test_an_unknown_benchmark_is_answered_with_those_there_are(repository: Path) -> None:
    command = [sys.executable, "-m", "benchmarks", "everything"]
    done = subprocess.run(command, cwd=repository, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert (
        "superposition, frames, solving, growth, start, authoring, animation, timeline, contact, tissue, exports"
        in done.stderr
    )


def test_fields_without_meaning_can_be_posed_like_those_of_a_face() -> None:
    basis = random_basis(drawn(1))
    posed = Superposition(default_face(), basis)
    posed.pose(dict.fromkeys(basis.names, 0.2))
    assert np.isfinite(posed.points).all()
    assert np.abs(posed.points - basis.display.points).max() > 0
