"""Head and eyes turn the way their channels say; a point of the face that is pulled comes where the hand is."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.pulling import pulled
from facemodel.cache import solve_cached
from facemodel.face import Face
from facemodel.kinematics import STILL, Rigid, Stance, neck_joint, rig_of, stance_of
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solution import Solution
from facemodel.superposition import Superposition

LEFT, UP, FORWARD = np.eye(3)


@pytest.fixture(scope="module")
def project() -> Project:
    return new_project()


@pytest.fixture(scope="module")
def face(project: Project) -> Face:
    return project.face


@pytest.fixture(scope="module")
def solution(project: Project) -> Solution:
    return solve_cached(project)


def turned(face: Face, rigid: Rigid) -> Stance:
    return stance_of(face, STILL.posture(face, {}, rigid), np.eye(4))


def test_yaw_is_to_the_left_pitch_up_and_roll_to_the_left_shoulder(face: Face) -> None:
    assert turned(face, {"head.yaw": 30.0}).head[:3, :3] @ FORWARD @ LEFT == pytest.approx(0.5)
    assert turned(face, {"head.pitch": 30.0}).head[:3, :3] @ FORWARD @ UP == pytest.approx(0.5)
    assert turned(face, {"head.roll": 30.0}).head[:3, :3] @ UP @ LEFT == pytest.approx(0.5)


@given(st.floats(-80, 80), st.floats(-60, 60), st.floats(-50, 50))
def test_a_turn_is_a_rotation(yaw: float, pitch: float, roll: float) -> None:
    found = turned(new_project().face, {"head.yaw": yaw, "head.pitch": pitch, "head.roll": roll}).head[:3, :3]
    assert found @ found.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(found) == pytest.approx(1.0)


def test_a_head_turns_about_its_neck_and_shifts(face: Face) -> None:
    motion = turned(face, {"head.yaw": 25.0, "head.pitch": -10.0, "head.x": 3.0, "head.z": -2.0}).head
    pivot = neck_joint(face)
    assert motion[:3, :3] @ pivot + motion[:3, 3] == pytest.approx(np.add(pivot, [3.0, 0.0, -2.0]))
    assert np.array_equal(turned(face, {}).head, np.eye(4))
    nose = face.skin.positions[face.landmarks["nose_tip"]]
    nod = turned(face, {"head.pitch": -15.0}).head
    assert (nod[:3, :3] @ nose + nod[:3, 3])[1] < nose[1] - 15


def test_an_eye_turns_about_its_centre(face: Face) -> None:
    eyes = turned(face, {"eyeL.yaw": 20.0, "eyeR.pitch": 10.0}).eyes
    for eye, motion in zip(face.eyes, eyes, strict=True):
        assert motion[:3, :3] @ eye.centre + motion[:3, 3] == pytest.approx(eye.centre)
        looks = motion[:3, :3] @ FORWARD
        assert (looks[0] > 0.3, looks[1] > 0.1) == ((True, False) if eye.side == "L" else (False, True))


def test_sliders_and_channels_turn_eyes_and_head_together(project: Project, face: Face) -> None:
    rig = rig_of(project.units)
    both = stance_of(face, rig.posture(face, {"61": 0.5, "53": 1.0}, {"eyeL.yaw": 5.0, "head.pitch": -10.0}), np.eye(4))
    alone = turned(face, {"eyeL.yaw": 22.5, "eyeR.yaw": 17.5, "head.pitch": 20.0})
    for one, other in zip((both.head, *both.eyes), (alone.head, *alone.eyes), strict=True):
        assert one == pytest.approx(other, abs=1e-9)


def test_lids_follow_an_eye_that_a_channel_turns(project: Project, solution: Solution) -> None:
    still, turning = (Superposition(project.face, solution.basis) for _ in range(2))
    turning.turned = {"eyeL.pitch": -30.0}
    turning.pose({})
    moved = np.flatnonzero(np.linalg.norm(turning.points - still.points, axis=1) > 1.0)
    assert len(moved) > 0
    assert (still.points[moved, 0] > 0).all(), "the other eye looks ahead"


def corner(project: Project, solution: Solution) -> int:
    at = project.face.skin.positions[project.face.landmarks["mouth_corner_L"]]
    return int(np.argmin(((solution.basis.display.points - at) ** 2).sum(axis=1)))


def test_a_mouth_corner_that_is_pulled_up_smiles(project: Project, solution: Solution) -> None:
    point = corner(project, solution)
    basis = solution.basis
    target = basis.display.points[point] + 0.8 * basis.moving_field("12L")[point]
    weights = pulled(basis, point, target, {"43L": 0.5}, project.units)
    moved = sum(weight * basis.moving_field(name)[point] for name, weight in weights.items())
    assert np.linalg.norm(basis.display.points[point] + moved - target) < 0.5
    assert weights["12L"] == max(weight for name, weight in weights.items() if name != "43L")
    assert weights["43L"] == pytest.approx(0.5, abs=0.1)


def test_only_fields_that_may_move_are_moved(project: Project, solution: Solution) -> None:
    point = corner(project, solution)
    target = solution.basis.display.points[point] + [0.0, 5.0, 0.0]
    weights = pulled(solution.basis, point, target, {}, project.units, among={"12L"})
    assert weights.keys() == {"12L"}
    assert pulled(solution.basis, point, target, {"17": 0.3}, project.units, among=()) == {"17": 0.3}
    held = len(solution.basis.display.points) - 1
    assert pulled(solution.basis, held, target, {"17": 0.3}, project.units) == {"17": 0.3}


def test_weights_stay_within_the_limits_of_their_units(project: Project, solution: Solution) -> None:
    point = corner(project, solution)
    far = solution.basis.display.points[point] + [200.0, 200.0, 0.0]
    weights = pulled(solution.basis, point, far, {}, project.units)
    assert max(weights.values()) <= 2.0
    assert min(weights.values()) >= 0.0
