"""The hand-made basis beside the solved one: another origin, the same sliders and the same directions."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import facemodel.sculpted
from facemodel.basis import Basis
from facemodel.errors import FaceError, ProjectError
from facemodel.face import Face
from facemodel.project import Project
from facemodel.sculpted import SculptedUnits, read_sculpted, sculpted_for_units, sculpted_solution
from facemodel.solve import Solution
from facemodel.superposition import Superposition
from fem.types import FloatArray
from tests.facemodel.places import vertex_fields


@pytest.fixture(scope="module")
def sculpted(face: Face) -> SculptedUnits:
    return read_sculpted(face)


@pytest.fixture(scope="module")
def hand_made(project: Project, solution: Solution) -> Basis:
    return sculpted_solution(project, solution).basis


@pytest.fixture(scope="module")
def both(face: Face, basis: Basis, hand_made: Basis) -> tuple[dict[str, FloatArray], dict[str, FloatArray]]:
    """Displacements of the skin's vertices, solved and sculpted."""
    return vertex_fields(face, basis), vertex_fields(face, hand_made)


def test_fifty_two_units_ship_on_the_vertices_of_the_default_face(face: Face, sculpted: SculptedUnits) -> None:
    assert len(sculpted.names) == len(set(sculpted.names)) == 52
    assert sculpted.fields.shape == (52, len(face.skin.positions), 3)
    assert np.isfinite(sculpted.fields).all()
    assert "CC0" in sculpted.provenance


def test_every_unit_but_the_turning_of_eyes_and_the_tongue_moves_the_skin(sculpted: SculptedUnits) -> None:
    peaks = dict(zip(sculpted.names, np.linalg.norm(sculpted.fields, axis=2).max(axis=1), strict=True))
    still = {name for name, peak in peaks.items() if peak < 0.3}
    assert still <= {name for name in sculpted.names if name.startswith(("eyeLook", "tongue"))}
    assert peaks["jawOpen"] > 15.0


def test_left_units_are_on_the_left(face: Face, sculpted: SculptedUnits) -> None:
    x = face.skin.positions[:, 0]
    for name, field in zip(sculpted.names, sculpted.fields, strict=True):
        energy = (field.astype(np.float64) ** 2).sum(axis=1)
        goes_left = name in {"jawLeft", "mouthLeft"}
        if name.endswith("Left") and energy.sum() > 1.0 and not goes_left:
            assert energy[x > 0].sum() > 0.7 * energy.sum(), name


def test_a_face_of_another_key_has_none(face: Face) -> None:
    with pytest.raises(FaceError, match="No sculpted units ship for"):
        read_sculpted(replace(face, key="somebody"))


def test_another_mesh_is_not_given_the_wrong_units(face: Face) -> None:
    other = replace(face, skin=replace(face.skin, positions=face.skin.positions[:-1]))
    with pytest.raises(FaceError, match="belong to another mesh"):
        read_sculpted(other)


def test_damaged_units_say_so(face: Face, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = tmp_path / "ada.npz"
    broken.write_bytes(b"PK\x03\x04 and no more")
    monkeypatch.setattr(facemodel.sculpted, "resource", lambda *_parts: broken)
    with pytest.raises(ProjectError, match="are damaged; reinstall"):
        read_sculpted(face)


def test_both_bases_answer_to_the_same_sliders(basis: Basis, hand_made: Basis) -> None:
    assert hand_made.origin == "sculpted"
    assert set(hand_made.names) <= set(basis.names)
    assert set(basis.names) - set(hand_made.names) == {"8", "13L", "13R", "19", "38L", "38R", "39"}, "no such"
    assert hand_made.display is basis.display


@pytest.mark.parametrize(
    ("field", "landmark"),
    [
        ("12L", "mouth_corner_L"),
        ("12R", "mouth_corner_R"),
        ("1L", "brow_inner_L"),
        ("2L", "brow_outer_L"),
        ("2R", "brow_outer_R"),
        ("4L", "brow_inner_L"),
        ("15L", "mouth_corner_L"),
        ("20L", "mouth_corner_L"),
        ("34L", "upper_second_molar_L"),
        ("43L", "upper_lid_mid_L"),
        ("45R", "upper_lid_mid_R"),
        ("30L", "menton"),
        ("26", "menton"),
        ("27", "menton"),
    ],
)
def test_the_artist_and_the_solver_move_the_same_place_the_same_way(
    face: Face, both: tuple[dict[str, FloatArray], dict[str, FloatArray]], field: str, landmark: str
) -> None:
    solved, sculpted = (moves[field][face.landmarks[landmark]] for moves in both)
    cosine = solved @ sculpted / np.linalg.norm(solved) / np.linalg.norm(sculpted)
    assert cosine > 0.5


def test_sculpted_fields_pass_through_what_was_sculpted(
    face: Face, project: Project, sculpted: SculptedUnits, both: tuple[dict[str, FloatArray], dict[str, FloatArray]]
) -> None:
    names, fields = sculpted_for_units(face, sculpted, project.units)
    free = np.setdiff1d(face.skin.triangles[face.solved], face.skin.triangles[~face.solved])
    for name, field in zip(names, fields, strict=True):
        assert both[1][name][free] == pytest.approx(field[free], abs=1e-4)


def test_a_unit_without_sides_is_split_into_halves_that_make_the_whole(
    face: Face, project: Project, sculpted: SculptedUnits
) -> None:
    names, fields = sculpted_for_units(face, sculpted, project.units)
    whole = sculpted.fields[sculpted.names.index("browInnerUp")]
    halves = [fields[names.index(name)] for name in ("1L", "1R")]
    assert halves[0] + halves[1] == pytest.approx(whole, abs=1e-5)
    assert np.abs(halves[0][face.landmarks["brow_outer_R"]]).max() == 0.0


def test_the_hand_made_jaw_carries_the_teeth(face: Face, hand_made: Basis) -> None:
    posed = Superposition(face, hand_made)
    rest = posed.parts["teeth-lower"].copy()
    posed.pose({"27": 1.0})
    assert (posed.parts["teeth-lower"] - rest)[:, 1].mean() < -5.0
    posed.pose({"12L": 1.0})
    assert posed.parts["teeth-lower"] == pytest.approx(rest, abs=1e-3)
