"""Tissue of another thickness than the bone is deep: the spring of the same stuff, softer where it is thicker."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from facemodel.face import Face
from facemodel.io.archive import unpack
from facemodel.io.project_file import PROJECT_MEMBER, load_project, project_bytes, save_project
from facemodel.painting.brush import Brush
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.layers import LAYER
from facemodel.painting.stroke import Stroke
from facemodel.painting.surface import PaintSurface
from facemodel.project import Project
from facemodel.solver import FaceSolver
from facemodel.staleness import stale_fields
from facemodel.tissue import bone_depth, tissue_springs, tissue_stiffness
from tests.app.conftest import small_project
from tests.facemodel.test_painting_layers import DOME, FACE

THICKNESS = LAYER["thickness"]
MIDDLE = SurfacePoint(len(DOME.triangles) // 2, np.full(3, 1 / 3))


def thick(face: Face, thickness: float | np.ndarray) -> Face:
    count = len(face.skin.positions)
    return replace(face, layers=replace(face.layers, thickness=np.broadcast_to(thickness, count).astype(np.float64)))


def test_twice_the_depth_is_half_the_spring_and_the_depth_itself_is_the_same_spring() -> None:
    face, depth = thick(FACE, 0.0), bone_depth(FACE)
    vertices = np.arange(len(depth))
    plain = tissue_springs(face, vertices)[0].blocks(len(depth))
    for times in (0.5, 1.0, 2.0, 3.0):
        blocks = tissue_springs(thick(face, times * depth), vertices)[0].blocks(len(depth))
        assert blocks == pytest.approx(plain / times, rel=1e-12)
    assert np.array_equal(tissue_stiffness(face), face.layers.stiffness)


def test_where_nobody_painted_it_is_as_thick_as_the_bone_is_deep_wherever_the_bone_goes() -> None:
    face = thick(FACE, 0.0)
    assert THICKNESS.values(face) == pytest.approx(8.0)
    deeper = replace(face, skull=replace(face.skull, anchors=face.skull.anchors - [0, 0, 4.0]))
    assert THICKNESS.values(deeper) == pytest.approx(12.0)
    assert THICKNESS.values(thick(deeper, 5.0)) == pytest.approx(5.0)


def test_a_soft_stroke_leads_from_the_depth_and_back_to_it() -> None:
    face, surface = thick(FACE, 0.0), PaintSurface(DOME)
    stroke = Stroke(surface, face, THICKNESS, Brush(15.0, 1.0, 0.2, "set", 16.0))
    stroke.extend(MIDDLE)
    done = replace(face, layers=stroke.delta().done(face.layers))
    values = THICKNESS.values(done)
    assert values.min() == pytest.approx(8.0)
    assert values.max() == pytest.approx(16.0)
    assert ((values > 9.0) & (values < 15.0)).any()
    erasing = Stroke(surface, done, THICKNESS, Brush(40.0, 1.0, 1.0, "erase"))
    erasing.extend(MIDDLE)
    assert not erasing.delta().done(done.layers).thickness.any()
    back = THICKNESS.delta(done, np.arange(len(values)), THICKNESS.unpainted(done))
    assert not back.done(done.layers).thickness.any(), "what is as thick as the bone is deep goes with the bone"


def test_thicker_tissue_gives_way_farther_and_makes_the_fields_stale() -> None:
    project = small_project()
    soft = replace(project, face=thick(project.face, 4 * bone_depth(project.face)))
    assert stale_fields(project, soft) >= {"12L", "12R"}
    solver = FaceSolver()
    before, after = (np.abs(solver.solve(each).basis.fields).max() for each in (project, soft))
    assert after > 1.2 * before


def test_a_file_has_it_only_where_it_was_painted_and_files_without_it_open(tmp_path: Path) -> None:
    project: Project = small_project()
    member = "face/layers/thickness"
    assert member not in unpack(project_bytes(project), PROJECT_MEMBER).arrays
    painted = replace(project, face=thick(project.face, np.linspace(0, 20, len(project.face.skin.positions))))
    for each in (project, painted):
        save_project(each, tmp_path / "face.risorius")
        found = load_project(tmp_path / "face.risorius").face.layers.thickness
        assert np.array_equal(found, each.face.layers.thickness)
    assert member in unpack(project_bytes(painted), PROJECT_MEMBER).arrays
