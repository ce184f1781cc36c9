"""MPEG-4 parameters tell how far the feature points of the very face move, in its own units, and are read back."""

import re
from pathlib import Path

import numpy as np
import pytest

from facemodel.animation.evaluation import Sampled
from facemodel.animation.feature_points import face_units, feature_points, point_motions
from facemodel.animation.mapping import default_mapping, mapped
from facemodel.cache import solve_cached
from facemodel.io.weights import read_capture
from facemodel.io.weights.fap import FAPS
from facemodel.io.weights.writing import Animated, export_weights
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solution import Solution


@pytest.fixture(scope="module")
def project() -> Project:
    return new_project()


@pytest.fixture(scope="module")
def solution(project: Project) -> Solution:
    return solve_cached(project)


def clip(**weights: float) -> Sampled:
    names = tuple(name.lstrip("u").replace("_", ".") for name in weights)
    ramp = np.outer([0.0, 0.5, 1.0], list(weights.values()))
    return Sampled(25.0, np.arange(3) / 25, names, ramp)


def test_every_feature_point_lies_on_the_face(project: Project) -> None:
    known = {name for name, unit in FAPS if unit not in ("AU", "")}
    assert feature_points().keys() <= known
    for point in feature_points().values():
        assert set(point.landmarks) <= project.face.landmarks.keys()
        assert np.linalg.norm(point.direction) == pytest.approx(1.0)


def test_units_of_a_face_are_its_own_distances(project: Project) -> None:
    units = {name: 1024 * value for name, value in face_units(project.face).items()}
    assert 50 < units["ES"] < 75
    assert 30 < units["ENS"] < 60
    assert 8 < units["MNS"] < 30
    assert 35 < units["MW"] < 60
    assert 5 < units["IRISD"] < 14


def test_a_smile_raises_and_widens_the_corners_and_comes_back(
    project: Project, solution: Solution, tmp_path: Path
) -> None:
    path = tmp_path / "smile.fap"
    moved = clip(u12L=1.0, u12R=1.0, head_yaw=20.0)
    export_weights(Animated(moved, project.units, project.face, solution.basis, "a smile"), path, "fap")
    lines = path.read_text().splitlines()
    assert lines[0] == "2.1 a_smile 25 3"
    assert all(re.fullmatch(r"[01]( [01]){67}", mask) for mask in lines[1::2])
    capture = read_capture(path)
    last = dict(zip(capture.channels, capture.values[-1].tolist(), strict=True))
    assert last["raise_l_cornerlip"] > 300
    assert last["stretch_l_cornerlip"] > 100
    assert last["head_yaw"] == pytest.approx(np.radians(20.0) * 1e5, abs=1)
    expected = point_motions(project.face, solution.basis, ("12L", "12R"))["raise_l_cornerlip"].sum()
    assert last["raise_l_cornerlip"] * face_units(project.face)["MNS"] == pytest.approx(expected, abs=0.02)
    found = {t.channel: t.captured.values[-1] for t in mapped(capture, default_mapping("fap"), project.units).tracks}  # type: ignore[union-attr]
    assert found["12L"] == pytest.approx(1.0, abs=0.25)
    assert found["head.yaw"] == pytest.approx(20.0, abs=0.01)


def test_an_open_jaw_comes_back_as_an_open_jaw(project: Project, solution: Solution, tmp_path: Path) -> None:
    path = tmp_path / "jaw.fap"
    export_weights(Animated(clip(u26=1.0), project.units, project.face, solution.basis), path, "fap")
    capture = read_capture(path)
    found = {t.channel: t.captured.values[-1] for t in mapped(capture, default_mapping("fap"), project.units).tracks}  # type: ignore[union-attr]
    assert found["26"] == pytest.approx(1.0, abs=0.1)
    assert found.get("12L", 0.0) < 0.25
