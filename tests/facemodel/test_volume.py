"""Tissue that keeps its volume where that is painted, and skin that slides as far as is painted."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.tissue import MOST_CHANGE, divergence, volume_change
from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.io.archive import unpack
from facemodel.io.project_file import PROJECT_MEMBER, load_project, project_bytes, save_project
from facemodel.painting.layers import LAYER
from facemodel.project import Project
from facemodel.solve import face_system
from facemodel.solver import FaceSolver
from facemodel.staleness import stale_fields
from facemodel.tissue import SLIDING, tissue_springs
from fem.types import FloatArray
from tests.app.conftest import small_project
from tests.facemodel.test_painting_layers import DOME, FACE

FIRM = 0.2
"""N/mm^3, fifty times the tissue's stiffness: volume is all but kept."""


def painted(face: Face, **layers: float | FloatArray) -> Face:
    count = len(face.skin.positions)
    full = {name: np.broadcast_to(values, count).astype(np.float64) for name, values in layers.items()}
    return replace(face, layers=replace(face.layers, **full))


@pytest.mark.parametrize("sliding", [3.0, 12.0, 40.0])
def test_tissue_is_as_many_times_softer_along_the_surface_as_is_painted(sliding: float) -> None:
    vertices = np.arange(len(FACE.skin.positions))
    once, twice = (
        np.linalg.eigvalsh(tissue_springs(painted(FACE, sliding=s), vertices)[0].blocks(len(vertices)))
        for s in (sliding, 2 * sliding)
    )
    inside = once[:, 0] > 1e-6 * once[:, 2]
    assert inside.sum() > 0.8 * len(vertices)
    assert np.median(twice[inside, 0] / once[inside, 0]) == pytest.approx(0.5, rel=0.01)


def test_the_divergence_of_a_growing_field_is_its_growth() -> None:
    field = DOME.positions @ np.diag([0.03, 0.05, 0.0])
    flat = DOME.moved(DOME.positions * [1.0, 1.0, 0.0])
    assert divergence(flat, field) == pytest.approx(0.08)
    assert divergence(DOME, np.tile([1.0, 2.0, 3.0], (len(DOME.positions), 1))) == pytest.approx(0.0, abs=1e-12)


def test_an_opening_jaw_moves_the_skin_as_if_its_tissue_kept_no_volume(project: Project) -> None:
    opening = replace(project, units=tuple(unit for unit in project.units if unit.number == 27))
    firm, loose = (replace(opening, face=painted(project.face, volume=kept)) for kept in (0.012, 0.0))
    one, other = (face_system(each) for each in (firm, loose))
    moved, without = one.system.solve(one.loads), other.system.solve(other.loads)
    assert np.linalg.norm(moved - without) < 1e-6 * np.linalg.norm(without)


def test_painting_either_makes_the_fields_stale_and_solves_them_otherwise() -> None:
    project = small_project()
    for layer, value in (("sliding", 40.0), ("volume", FIRM)):
        other = replace(project, face=painted(project.face, **{layer: value}))
        assert stale_fields(project, other) >= {"12L", "12R"}
        solver = FaceSolver()
        before, after = (solver.solve(each).basis.fields for each in (project, other))
        assert np.abs(after - before).max() > 0.02 * np.abs(before).max()


def test_the_living_solver_and_the_solve_from_scratch_agree_where_volume_is_kept() -> None:
    project = small_project()
    firm = replace(project, face=painted(project.face, volume=FIRM))
    assembled = face_system(firm)
    whole = assembled.system.solve(assembled.loads)
    solver = FaceSolver()
    solver.solve(project)
    basis = solver.solve(firm).basis
    moved = assembled.region.assembler.dofs.value_dofs
    assert np.abs(whole[moved]).max() > 0.0
    again = FaceSolver().solve(firm).basis
    assert np.array_equal(basis.fields, again.fields), "what was solved before leaves no trace"


def test_a_file_has_them_only_where_they_were_painted_and_files_without_them_open(tmp_path: Path) -> None:
    project = small_project()
    assert (
        not {"face/layers/sliding", "face/layers/volume"} & unpack(project_bytes(project), PROJECT_MEMBER).arrays.keys()
    )
    ramp = np.linspace(1.0, 30.0, len(project.face.skin.positions))
    other = replace(project, face=painted(project.face, sliding=ramp, volume=ramp / 100))
    for each in (project, other):
        save_project(each, tmp_path / "face.risorius")
        found = load_project(tmp_path / "face.risorius").face.layers
        assert np.array_equal(found.sliding, each.face.layers.sliding)
        assert np.array_equal(found.volume, each.face.layers.volume)
    assert np.array_equal(project.face.layers.sliding, np.full(len(ramp), SLIDING))


def test_both_are_painted_like_any_layer() -> None:
    for key in ("sliding", "volume"):
        layer = LAYER[key]
        delta = layer.delta(FACE, np.arange(3), np.array([layer.low - 1, layer.default, layer.high + 1]))
        values = layer.values(replace(FACE, layers=delta.done(FACE.layers)))
        assert values[:3] == pytest.approx([layer.low, layer.default, layer.high])


@pytest.mark.parametrize("number", [12, 18])
def test_cheeks_and_lips_keep_their_volume_when_they_are_pulled_and_pursed(
    face: Face, basis: Basis, number: int
) -> None:
    assert abs(volume_change(face, basis, number)) < MOST_CHANGE
