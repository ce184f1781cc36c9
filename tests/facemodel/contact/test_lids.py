"""Lids lie on the eyeball, close it all along, and follow where it looks."""

import numpy as np
import pytest

from benchmarks.touching import in_eyeball, seen_of_eyeball
from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.face import Eye, Face
from facemodel.kinematics import rig_of
from facemodel.openings import lids_of
from facemodel.project import Project
from facemodel.superposition import Superposition
from tests.facemodel.places import points_of_vertices

CLOSING = np.linspace(0.1, 1.0, 10)
SHUT = 0.3
"""Millimetres of eyeball between lids that are nowhere seen as a gap."""
UNSEEN = 0.05
"""Millimetres that nobody sees; lips that touch at rest give way by as much when the lids pull at all of the skin."""
ROUNDING = 1e-3
BLINKS = (
    {"43": 1.0},
    {"43": 0.9},
    {"43": 1.0, "7": 1.0, "6": 1.0},
    {"43": 1.0, "4": 1.0, "9": 1.0},
    {"43": 1.0, "12": 1.0, "6": 0.7},
)


@pytest.fixture
def posed(project: Project, basis: Basis) -> Superposition:
    return Superposition(project.face, basis, rig_of(project.units))


@pytest.fixture(params=["L", "R"])
def eye(request: pytest.FixtureRequest, face: Face) -> Eye:
    return next(eye for eye in face.eyes if eye.side == request.param)


def on(eye: Eye, weights: Expression) -> dict[str, float]:
    return {f"{number}{eye.side}": weight for number, weight in weights.items()}


@pytest.mark.parametrize("blink", BLINKS)
def test_a_blink_leaves_no_gap_along_the_eyeball(posed: Superposition, eye: Eye, blink: Expression) -> None:
    assert seen_of_eyeball(eye, posed) > 5, "an open eye is seen"
    posed.pose(on(eye, blink))
    assert seen_of_eyeball(eye, posed) < SHUT


def test_no_lid_is_in_the_ball_however_far_it_is_closed(face: Face, basis: Basis, eye: Eye) -> None:
    kept, straight = Superposition(face, basis), Superposition(face, basis, linear=True)
    rest = max(in_eyeball(eye, kept), 0.0)
    cut = []
    for weight in CLOSING:
        for each in (kept, straight):
            each.pose(on(eye, {"43": float(weight), "7": 1.0, "9": 0.5}))
        assert in_eyeball(eye, kept) <= rest + ROUNDING
        cut.append(in_eyeball(eye, straight))
    assert max(cut) > rest + 10 * ROUNDING, "the linear sum takes the chord"


def test_contact_at_the_eyes_moves_nothing_but_what_is_near_them(face: Face, basis: Basis) -> None:
    kept, straight = Superposition(face, basis), Superposition(face, basis, linear=True)
    for each in (kept, straight):
        each.pose({"43L": 1.0, "43R": 1.0, "1L": 0.6})
    moved = np.flatnonzero(np.abs(kept.points - straight.points).max(axis=1) > UNSEEN)
    assert len(moved) > 0
    eyes = np.array([each.centre for each in face.eyes])
    away = np.linalg.norm(kept.points[moved][:, None] - eyes, axis=2).min(axis=1)
    assert away.max() < max(each.radius for each in face.eyes) + 15.0
    assert np.linalg.norm(kept.normals, axis=1) == pytest.approx(1.0, abs=1e-4)


@pytest.mark.parametrize(("number", "way"), [("63", 1.0), ("64", -1.0)])
def test_lids_go_a_little_with_eyes_that_look_up_or_down(
    face: Face, basis: Basis, posed: Superposition, number: str, way: float
) -> None:
    posed.pose({number: 1.0})
    drawn = points_of_vertices(face, basis.display)
    for eye in face.eyes:
        slit = lids_of(face, eye)
        assert slit is not None
        for edge, least, most in ((slit.upper, 1.0, 8.0), (slit.lower, 0.3, 4.0)):
            middle = drawn[edge[len(edge) // 2]]
            rise = way * float(posed.points[middle, 1] - basis.display.points[middle, 1])
            assert least < rise < most
        assert in_eyeball(eye, posed) < ROUNDING, "and stay on the ball"


def test_at_rest_and_back_at_rest_nothing_is_moved(face: Face, basis: Basis) -> None:
    posed = Superposition(face, basis)
    posed.pose({"43L": 1.0})
    posed.pose({})
    assert np.array_equal(posed.points, basis.display.points)
    assert np.array_equal(posed.normals, basis.display.normals)


def test_what_was_moved_does_not_pile_up(face: Face, basis: Basis) -> None:
    """It is taken back before the next pose, so that opening the eye undoes closing it."""
    blinking, once = Superposition(face, basis), Superposition(face, basis)
    for weight in (*CLOSING, *CLOSING[::-1]):
        blinking.pose({"43L": float(weight), "12L": 0.5})
    once.pose({"43L": float(CLOSING[0]), "12L": 0.5})
    assert np.abs(blinking.points - once.points).max() < 1e-4
