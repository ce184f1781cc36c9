"""What each action unit does to the default face: how far, where, and in which direction."""

import numpy as np
import pytest

from facemodel.actions import skin_units
from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.facs import action_units
from facemodel.project import Project
from fem.types import FloatArray
from tests.facemodel.places import vertex_fields

UNITS = {unit.number: unit for unit in skin_units(action_units())}
FIELDS = [name for unit in UNITS.values() for name in unit.fields]
LEFT = [f"{unit.number}L" for unit in UNITS.values() if unit.paired]
OF_MUSCLES = [name for unit in UNITS.values() if unit.jaw is None for name in unit.fields]
MIDLINE = [str(unit.number) for unit in UNITS.values() if not unit.paired]

Moves = dict[str, FloatArray]


@pytest.fixture(scope="module")
def moves(face: Face, basis: Basis) -> Moves:
    """Displacement of every skin vertex by every field; paired units also as a whole, under their number."""
    fields = vertex_fields(face, basis)
    whole = {f"{number}": fields[f"{number}L"] + fields[f"{number}R"] for number, u in UNITS.items() if u.paired}
    return fields | whole


def moved(face: Face, moves: Moves, field: str, landmark: str) -> tuple[float, float, float]:
    """Return how far a landmark moves to the subject's left, up and forward."""
    left, up, forward = moves[field][face.landmarks[landmark]]
    return float(left), float(up), float(forward)


def test_every_unit_is_solved(basis: Basis) -> None:
    assert list(basis.names) == FIELDS
    assert np.isfinite(basis.fields).all()
    assert np.isfinite(basis.slopes).all()
    assert basis.origin == "solved"


@pytest.mark.parametrize("name", FIELDS)
def test_full_activation_moves_the_skin_as_far_as_measured(project: Project, basis: Basis, name: str) -> None:
    unit = next(unit for unit in project.units if name in unit.fields)
    assert basis.peak(name) == pytest.approx(unit.amplitude, rel=0.15)


def test_a_smile_draws_the_corner_of_the_mouth_up_and_out(face: Face, moves: Moves) -> None:
    out, up, _ = moved(face, moves, "12L", "mouth_corner_L")
    assert out > 4.0
    assert up > 4.0
    assert moved(face, moves, "12R", "mouth_corner_R")[0] < -4.0
    assert moves["12L"][face.landmarks["mouth_corner_R"]] == pytest.approx(0.0, abs=2.0)


def test_frontalis_raises_the_brow_it_belongs_to(face: Face, moves: Moves) -> None:
    inner = [moved(face, moves, f"{unit}L", "brow_inner_L")[1] for unit in (1, 2)]
    outer = [moved(face, moves, f"{unit}L", "brow_outer_L")[1] for unit in (1, 2)]
    assert inner[0] > 4.0
    assert outer[1] > 4.0
    assert inner[0] > 1.5 * outer[0]
    assert outer[1] > 1.5 * inner[1]


def test_a_frown_draws_the_brows_down_and_together(face: Face, moves: Moves) -> None:
    inward, up, _ = moved(face, moves, "4", "brow_inner_L")
    assert inward < -0.8
    assert up < -3.0
    assert moved(face, moves, "4", "brow_inner_R")[0] > 0.8


def gap_of_lids(face: Face, moves: Moves, field: str, weight: float = 1.0) -> float:
    upper, lower = (face.landmarks[f"{lid}_lid_mid_L"] for lid in ("upper", "lower"))
    posed = face.skin.positions + weight * moves[field]
    return float(posed[upper, 1] - posed[lower, 1])


def test_closing_brings_the_lids_together(face: Face, moves: Moves) -> None:
    rest = gap_of_lids(face, moves, "43", 0.0)
    assert rest > 5.0
    assert abs(gap_of_lids(face, moves, "43")) < 0.3 * rest
    assert gap_of_lids(face, moves, "43", 0.5) == pytest.approx(rest / 2, rel=0.3)
    upper, lower = (abs(moved(face, moves, "43L", f"{lid}_lid_mid_L")[1]) for lid in ("upper", "lower"))
    assert upper > 5 * lower, "the upper lid does the closing"


def test_the_lids_open_for_surprise_and_narrow_when_tightened(face: Face, moves: Moves) -> None:
    rest = gap_of_lids(face, moves, "5", 0.0)
    assert gap_of_lids(face, moves, "5") > rest + 1.5
    assert gap_of_lids(face, moves, "7") < rest - 1.5
    assert gap_of_lids(face, moves, "6") < rest - 0.5


def test_the_cheek_raiser_raises_the_cheek(face: Face, moves: Moves) -> None:
    assert moved(face, moves, "6L", "cheek_L")[1] > 2.0
    assert moved(face, moves, "6L", "lower_lid_mid_L")[1] > 0.5


@pytest.mark.parametrize(
    ("field", "landmark", "axis", "least"),
    [
        ("9L", "ala_L", 1, 4.0),
        ("10", "upper_lip_mid", 1, 2.0),
        ("10L", "cupid_bow_L", 1, 2.0),
        ("11L", "nasolabial_L", 1, 2.0),
        ("14L", "mouth_corner_L", 0, 2.0),
        ("14L", "mouth_corner_L", 2, -2.0),
        ("15L", "mouth_corner_L", 1, -3.0),
        ("16", "lower_lip_mid", 1, -2.0),
        ("17", "chin", 1, 2.0),
        ("17", "lower_lip_mid", 1, 4.0),
        ("18", "mouth_corner_L", 0, -4.0),
        ("18", "mouth_corner_L", 2, 2.0),
        ("20L", "mouth_corner_L", 0, 3.0),
        ("20L", "mouth_corner_L", 2, -2.0),
        ("23", "mouth_corner_L", 0, -1.0),
        ("24", "upper_lip_mid", 1, -1.5),
        ("24", "lower_lip_mid", 1, 1.5),
        ("25", "lower_lip_mid", 1, -2.0),
    ],
)
def test_units_move_their_place_their_way(
    face: Face, moves: Moves, field: str, landmark: str, axis: int, least: float
) -> None:
    way = moved(face, moves, field, landmark)[axis]
    assert way * np.sign(least) > abs(least)


@pytest.mark.parametrize("field", ["25", "26", "27"])
def test_lips_part(face: Face, moves: Moves, field: str) -> None:
    assert moved(face, moves, field, "upper_lip_mid")[1] - moved(face, moves, field, "lower_lip_mid")[1] > 2.0


@pytest.mark.parametrize(("field", "least"), [("26", 8.0), ("27", 15.0)])
def test_the_jaw_lowers_the_chin_and_leaves_the_upper_face(face: Face, moves: Moves, field: str, least: float) -> None:
    left, up, forward = moved(face, moves, field, "menton")
    assert abs(left) < 0.1
    assert up < -least
    assert forward < 0.0, "a hinge before the ear swings the chin back"
    high = face.skin.positions[:, 1] > face.skin.positions[face.landmarks["nasion"], 1]
    assert np.abs(moves[field][high]).max() < 0.1 * UNITS[int(field)].amplitude


def test_the_larger_opening_is_the_larger(moves: Moves) -> None:
    assert np.linalg.norm(moves["27"]) > 1.5 * np.linalg.norm(moves["26"])


# Attached near the midline, these pull at a lip that both sides share.
SHARED_LIP = {"10L": 0.7, "16L": 0.6, "15L": 0.9, "11L": 0.85, "18L": 0.85, "1L": 0.85, "4L": 0.85}


@pytest.mark.parametrize("field", sorted(set(LEFT) & set(OF_MUSCLES)))
def test_the_left_alone_hardly_moves_the_right(face: Face, moves: Moves, field: str) -> None:
    energy = face.skin.vertex_areas * (moves[field] ** 2).sum(axis=1)
    left = energy[face.skin.positions[:, 0] > 0].sum() / energy.sum()
    assert left > SHARED_LIP.get(field, 0.95)


@pytest.mark.parametrize("field", LEFT)
def test_left_and_right_mirror_each_other(face: Face, moves: Moves, field: str) -> None:
    reflected = moves[field.replace("L", "R")][face.mirror] * [-1, 1, 1]
    assert np.abs(reflected - moves[field]).max() < 0.01 * np.abs(moves[field]).max()


@pytest.mark.parametrize("field", MIDLINE)
def test_units_of_the_midline_are_symmetric(face: Face, moves: Moves, field: str) -> None:
    reflected = moves[field][face.mirror] * [-1, 1, 1]
    assert np.abs(reflected - moves[field]).max() < 0.01 * np.abs(moves[field]).max()


@pytest.mark.parametrize("field", FIELDS)
def test_crown_ears_and_neck_stay(face: Face, moves: Moves, field: str) -> None:
    peak = np.linalg.norm(moves[field], axis=1).max()
    held = np.setdiff1d(np.arange(len(face.mirror)), face.skin.triangles[face.solved])
    assert np.array_equal(moves[field][held], np.zeros((len(held), 3)))
    crown = face.skin.positions[:, 1] > face.skin.positions[:, 1].max() - 15
    assert np.linalg.norm(moves[field][crown], axis=1).max() < 0.03 * peak
    ears = [face.landmarks["tragus_L"], face.landmarks["tragus_R"]]
    assert np.linalg.norm(moves[field][ears], axis=1).max() < 0.1 * peak


@pytest.mark.parametrize("field", [name for name in OF_MUSCLES if name not in ("34L", "34R")])
def test_skin_slides_over_the_bone(basis: Basis, field: str) -> None:
    """On scanned faces 70 to 95 % of the motion is along the surface; lids and lips most leave it, breath lifts it."""
    moving = basis.moving_field(field).astype(np.float64)
    normals = basis.display.normals[: basis.display.moving]
    lifted = np.abs(np.einsum("ij,ij->i", moving, normals))
    whole = np.linalg.norm(moving, axis=1)
    along = np.sqrt(np.maximum(whole**2 - lifted**2, 0.0)).sum() / whole.sum()
    assert 0.7 < along < 0.97
