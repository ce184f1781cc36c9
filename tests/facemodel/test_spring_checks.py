"""Springs of no length and springs through bone are found and left out, and the face stays one that can be solved."""

from dataclasses import replace

import igl
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.errors import FaceError
from facemodel.face import Face, Skull
from facemodel.faces import face_keys, load_face
from facemodel.skull.spring_checks import THROUGH, spring_faults, whole_bone
from facemodel.solver import FaceSolver
from facemodel.staleness import stale_fields
from facemodel.system import face_tissue, solved_vertices
from facemodel.tissue import tissue_springs
from fem.types import FloatArray
from tests.app.conftest import small_face, small_project, tetrahedron


def shifted(face: Face, way: FloatArray) -> Face:
    """Return a face whose bones and feet are moved."""
    skull = face.skull
    bones = {name: getattr(skull, name).moved(getattr(skull, name).positions + way) for name in ("cranium", "mandible")}
    return replace(face, skull=replace(skull, anchors=skull.anchors + way, **bones))


def walled(height: float) -> Skull:
    """Return the small skull with a plate of bone across the springs of a 5 mm deep face, its feet 20 mm deep."""
    face = small_face()
    plate = tetrahedron((0, 0, 0))
    plate = plate.moved(plate.positions * [9, 9, 1] + [0, 0, height])
    return replace(face.skull, cranium=plate, anchors=face.skin.positions - [0, 0, 20.0])


@pytest.mark.parametrize("key", face_keys())
def test_no_spring_of_a_shipped_face_is_left_out(key: str) -> None:
    face = load_face(key)
    faults = spring_faults(face, solved_vertices(face))
    assert not faults.left_out.any()
    assert len(faults.at) == 0


def test_a_skin_vertex_on_its_foot_has_no_spring() -> None:
    face = small_face()
    feet = face.skull.anchors.copy()
    feet[40] = face.skin.positions[40]
    touching = replace(face, skull=replace(face.skull, anchors=feet))
    faults = spring_faults(touching, solved_vertices(touching))
    assert faults.no_length.sum() == 1
    assert faults.at.tolist() == [40]
    springs, _, _ = tissue_springs(touching, solved_vertices(touching))
    assert springs.stiffness[40] == 0.0
    assert (np.delete(springs.stiffness, 40) > 0).all()


def test_springs_through_a_plate_of_bone_are_those_that_cross_it() -> None:
    face = replace(small_face(), skull=walled(8.0))
    faults = spring_faults(face, solved_vertices(face))
    assert not faults.no_length.any()
    bone = whole_bone(face.skull.cranium, face.skull.mandible)
    starts = face.skin.positions[faults.vertices]
    for number in range(len(starts)):
        way = np.linspace(0, 1, 400)[:, None] * (faults.feet[number] - starts[number]) + starts[number]
        inside = np.asarray(igl.winding_number(bone.positions, bone.triangles, way)) > 0.5
        behind = np.linalg.norm(faults.feet[number] - way[inside.argmax()]) if inside.any() else 0.0
        if abs(behind - THROUGH) > 0.2:
            assert faults.through[number] == (behind > THROUGH)
    assert faults.through.any()
    assert not faults.through.all()


@settings(max_examples=8)
@given(st.floats(0, 25), st.floats(0, 2 * np.pi))
def test_the_tissue_of_a_badly_placed_skull_is_positive_semidefinite(far: float, turn: float) -> None:
    face = shifted(load_face("ada"), far * np.array([0.0, np.sin(turn), np.cos(turn)]))
    vertices = solved_vertices(face)
    blocks = face_tissue(face, vertices).blocks
    assert np.isfinite(blocks).all()
    assert np.linalg.eigvalsh(blocks).min() > -1e-12
    faults = spring_faults(face, vertices)
    alone = np.bincount(faults.vertices[~faults.left_out], minlength=len(face.skin.positions))[vertices] == 0
    assert np.abs(blocks[alone]).max(initial=0.0) == 0.0


def test_a_face_is_solved_without_them_and_if_it_is_loose_then_says_where() -> None:
    project = small_project()
    pierced = replace(project, face=replace(project.face, skull=walled(8.0)))
    solved = FaceSolver().solve(pierced)
    assert np.isfinite(solved.basis.fields).all()
    layers = replace(project.face.layers, supports=np.zeros(81, dtype=np.int64))
    around = tetrahedron((0, 0, 0))
    skull = replace(project.face.skull, cranium=around.moved(400 * around.positions))
    buried = replace(project.face, layers=layers, skull=skull)
    with pytest.raises(FaceError, match="nothing holds it there"):
        FaceSolver().solve(replace(project, face=buried))


def test_bone_that_is_put_before_the_feet_makes_the_fields_stale_and_a_living_solver_follows() -> None:
    project = small_project()
    deep = replace(project, face=replace(project.face, skull=walled(-60.0)))
    pierced = replace(project, face=replace(project.face, skull=replace(walled(8.0), anchors=deep.face.skull.anchors)))
    assert stale_fields(deep, pierced)
    beside = replace(project, face=replace(project.face, skull=walled(-61.0)))
    assert not stale_fields(deep, beside)
    living = FaceSolver()
    living.solve(deep)
    fresh = FaceSolver().solve(pierced)
    assert np.array_equal(living.solve(pierced).basis.fields, fresh.basis.fields)
