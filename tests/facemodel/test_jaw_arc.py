"""The skin goes along the jaw's arc at every angle, opens wide, and folds nowhere."""

import numpy as np
import pytest

from benchmarks.opening import folded, incisors_apart
from facemodel.basis import Basis
from facemodel.comparison import Comparison, compared, in_full
from facemodel.face import Face
from facemodel.project import Project
from facemodel.superposition import Superposition

NEAR = 0.5
"""Millimetres from a full solution at any angle."""
WIDE = 40.0
"""Millimetres between the incisors of a mouth that is opened all the way."""
CARRIED = 0.1
"""Share of the bone's way by which skin of the chin may lag or lead: a scanned face keeps within 0.06."""


def against_full(project: Project, basis: Basis, weights: dict[str, float]) -> Comparison:
    return compared(project, weights, basis, in_full(project, weights), contact=False)


@pytest.mark.parametrize("weights", [{"27": 0.5}, {"26": 0.8, "27": 0.6, "12L": 0.7}])
def test_at_any_angle_the_skin_is_where_a_full_solution_has_it(
    project: Project, basis: Basis, weights: dict[str, float]
) -> None:
    assert against_full(project, basis, weights).largest < NEAR


def test_the_linear_sum_would_miss_the_arc(face: Face, basis: Basis) -> None:
    along, straight = Superposition(face, basis, contact=False), Superposition(face, basis, linear=True)
    for posed in (along, straight):
        posed.pose({"27": 0.5})
    assert np.linalg.norm(along.points - straight.points, axis=1).max() > NEAR


def test_a_jaw_that_is_opened_all_the_way_has_40_mm_between_the_incisors_and_no_fold(face: Face, basis: Basis) -> None:
    posed = Superposition(face, basis)
    assert folded(posed) == 0
    posed.pose({"27": 1.0})
    assert incisors_apart(face, posed) > WIDE
    assert folded(posed) == 0


@pytest.mark.parametrize("landmark", ["chin_lip_fold", "pogonion", "menton"])
def test_the_skin_of_the_chin_goes_with_the_bone_instead_of_being_squeezed_under_the_lip(
    face: Face, basis: Basis, landmark: str
) -> None:
    posed = Superposition(face, basis)
    posed.pose({"27": 1.0})
    place = face.skin.positions[face.landmarks[landmark]]
    at = np.linalg.norm(basis.display.points - place, axis=1).argmin()
    way, bone = posed.points[at] - place, posed.jaw[:3, :3] @ place + posed.jaw[:3, 3] - place
    assert 1 - CARRIED < way @ bone / (bone @ bone) < 1 + CARRIED
