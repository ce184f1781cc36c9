"""Lids glide on the eyeball: a sum of fields takes the chord, the eye is round."""

import numpy as np
import pytest

from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.superposition import Superposition
from fem.types import FloatArray, IntArray

CLOSING = np.linspace(0.1, 1.0, 10)
SEEN = 0.05
"""Millimetres of eyeball through a lid that show as a bright rim."""


def lid_points(face: Face, basis: Basis, side: str) -> IntArray:
    """Return drawn points of the upper lid's middle, which closing carries down the front of the eye."""
    at = basis.display.points
    margin = face.skin.positions[face.landmarks[f"upper_lid_mid_{side}"]]
    return np.flatnonzero(np.linalg.norm(at - margin, axis=1) < 3.0)


def depths(face: Face, points: FloatArray, side: str) -> FloatArray:
    """Return how far points lie inside the eyeball, millimetres."""
    eye = next(eye for eye in face.eyes if eye.side == side)
    return eye.radius - np.linalg.norm(points - eye.centre, axis=1)


@pytest.mark.parametrize("side", ["L", "R"])
def test_a_closing_lid_does_not_cut_into_the_eyeball(face: Face, basis: Basis, side: str) -> None:
    gliding, straight = Superposition(face, basis), Superposition(face, basis, glide=False)
    lid = lid_points(face, basis, side)
    rest = max(depths(face, gliding.points[lid], side).max(), 0.0)
    cut = []
    for weight in CLOSING:
        for posed in (gliding, straight):
            posed.pose({f"43{side}": float(weight)})
        assert depths(face, gliding.points[lid], side).max() <= rest + 1e-3
        cut.append(depths(face, straight.points[lid], side).max())
    assert max(cut) > rest + SEEN, "without gliding it would"


def test_gliding_moves_nothing_but_lids(face: Face, basis: Basis) -> None:
    gliding, straight = Superposition(face, basis), Superposition(face, basis, glide=False)
    for posed in (gliding, straight):
        posed.pose({"43L": 1.0, "43R": 1.0, "12L": 0.6})
    moved = np.flatnonzero(np.abs(gliding.points - straight.points).max(axis=1) > 0)
    assert len(moved) > 0
    eyes = np.array([eye.centre for eye in face.eyes])
    away = np.linalg.norm(gliding.points[moved][:, None] - eyes, axis=2).min(axis=1)
    assert away.max() < 20.0
    assert np.linalg.norm(gliding.normals, axis=1) == pytest.approx(1.0, abs=1e-4)


def test_at_rest_and_back_at_rest_nothing_is_pushed(face: Face, basis: Basis) -> None:
    posed = Superposition(face, basis)
    posed.pose({"43L": 1.0})
    posed.pose({})
    assert np.array_equal(posed.points, basis.display.points)
    assert np.array_equal(posed.normals, basis.display.normals)


def test_what_was_pushed_does_not_pile_up(face: Face, basis: Basis) -> None:
    """The push is taken back before the next pose, so that opening the eye undoes closing it."""
    blinking, once = Superposition(face, basis), Superposition(face, basis)
    for weight in (*CLOSING, *CLOSING[::-1]):
        blinking.pose({"43L": float(weight), "12L": 0.5})
    once.pose({"43L": float(CLOSING[0]), "12L": 0.5})
    assert np.abs(blinking.points - once.points).max() < 1e-4
