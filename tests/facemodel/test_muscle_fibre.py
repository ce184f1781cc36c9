"""The linear fibre against the formulas of Koch, Gross and Bosshard 1998 at points computed by hand."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from facemodel.mesh import Mesh
from facemodel.muscles.fibre import fan, fibre_forces, lateral, longitudinal
from tests.facemodel.skin import at, domed_skin, fibre_muscle, flat_skin, sizes

STRAP = [([-12.0, 0.0, 0.0], [12.0, 0.0, 0.0])]


@pytest.mark.parametrize(
    ("epsilon", "kappa", "weight"),
    [
        (0.0, 1.0, 0.0),
        # sin(pi/4) + (sin(pi/2) + 1)/8 = 0.70711 + 0.25
        (0.5, 1.0, 0.9571067811865476),
        # sin(pi/8) + (sin(0) + 1)/8 = 0.38268 + 0.125
        (0.25, 1.0, 0.5076834323650898),
        (1.0, 1.0, 1.0),
        # eps^2 = 0.25 as above
        (0.5, 2.0, 0.5076834323650898),
        (1.0, 4.0, 1.0),
        # past the attachment the profile stays at its value there
        (1.7, 1.0, 1.0),
    ],
)
def test_the_profile_along_the_fibre(epsilon: float, kappa: float, weight: float) -> None:
    assert longitudinal(np.array([epsilon]), kappa) == pytest.approx([weight])


@pytest.mark.parametrize(
    ("gamma", "weight"),
    # (cos(pi 0.5^1.8) + 1)/2 with 0.5^1.8 = 0.287175
    [(0.0, 1.0), (0.5, 0.80995), (1.0, 0.0), (1.01, 0.0), (3.0, 0.0)],
)
def test_the_profile_across_the_fibre(gamma: float, weight: float) -> None:
    assert lateral(np.array([gamma])) == pytest.approx([weight], abs=1e-5)


def test_a_larger_exponent_pulls_nearer_to_the_attachment() -> None:
    along = np.linspace(0.0, 1.0, 501)
    centres = [
        (along * weight).sum() / weight.sum() for weight in (longitudinal(along, kappa) for kappa in (1.0, 2.0, 4.0))
    ]
    assert centres[0] < centres[1] < centres[2]


@given(st.floats(-1.0, 3.0), st.floats(0.5, 6.0))
def test_the_profile_never_pushes(epsilon: float, kappa: float) -> None:
    assert longitudinal(np.array([epsilon]), kappa)[0] >= 0.0


@given(st.floats(0.0, 2.0), st.floats(0.0, 2.0))
def test_influence_falls_monotonically_across(low: float, high: float) -> None:
    low, high = sorted((low, high))
    assert lateral(np.array([low]))[0] >= lateral(np.array([high]))[0]


def test_force_at_points_computed_by_hand() -> None:
    skin = flat_skin()
    forces = fibre_forces(fibre_muscle(STRAP, strength=0.02), skin)
    # On the fibre, half way: T1(0.5) = 0.95711, towards the origin.
    assert forces[at(skin, 0, 0, 0)] == pytest.approx([-0.02 * 0.9571067811865476, 0, 0])
    # Three quarters along, half the width off: eps = 0.75, gamma = 0.5.
    t1 = np.sin(np.pi / 2 * 0.75) + (np.sin(2 * np.pi * 0.75 - np.pi / 2) + 1) / 8
    assert forces[at(skin, 6, 4, 0)] == pytest.approx([-0.02 * t1 * (np.cos(np.pi * 0.5**1.8) + 1) / 2, 0, 0])
    # At the attachment the whole strength.
    assert forces[at(skin, 12, 0, 0)] == pytest.approx([-0.02, 0, 0])


def test_no_force_behind_the_origin_beyond_the_width_or_far_past_the_attachment() -> None:
    skin = flat_skin()
    forces = sizes(fibre_forces(fibre_muscle(STRAP), skin))
    x, y, _ = skin.positions.T
    outside = (x < -12) | (np.abs(y) >= 8) | (x >= 12 + 8)
    assert np.array_equal(forces[outside], np.zeros(outside.sum()))
    inside = (x > -12) & (np.abs(y) < 7.9) & (x < 12 + 7.9)
    assert forces[inside].min() > 0.0


@given(st.integers(0, 10**6))
def test_force_turns_with_the_head(seed: int) -> None:
    rng = np.random.default_rng(seed)
    turn, shift = Rotation.random(random_state=rng.integers(2**31)).as_matrix(), rng.uniform(-50, 50, 3)
    skin = domed_skin(segments=10)
    origin, attachment = rng.uniform(-25, 25, (2, 3)) * [1, 1, 0.2]
    muscle = fibre_muscle([(list(origin), list(attachment))], width=12.0)
    moved = fibre_muscle([(list(turn @ origin + shift), list(turn @ attachment + shift))], width=12.0)
    expected = fibre_forces(muscle, skin) @ turn.T
    found = fibre_forces(moved, Mesh(skin.positions @ turn.T + shift, skin.triangles))
    assert found == pytest.approx(expected, abs=1e-9)


def test_a_fan_passes_through_its_central_fibres_in_order() -> None:
    muscle = fibre_muscle([([0, 0, 0], [10, 0, 0]), ([0, 4, 0], [10, 6, 0]), ([0, 8, 2], [10, 12, 0])])
    origins, attachments = fan(muscle.fibres, 5)
    assert origins == pytest.approx(np.array([[0, 0, 0], [0, 2, 0], [0, 4, 0], [0, 6, 1], [0, 8, 2]]))
    assert attachments == pytest.approx(np.array([[10, 0, 0], [10, 3, 0], [10, 6, 0], [10, 9, 0], [10, 12, 0]]))


def test_a_single_fibre_is_not_multiplied() -> None:
    origins, _ = fan(fibre_muscle(STRAP).fibres, 50)
    assert len(origins) == 1


@pytest.mark.parametrize("count", [25, 100, 400])
def test_the_number_of_generated_fibres_changes_the_grain_and_not_the_strength(count: int) -> None:
    skin = flat_skin()
    spine = [([-12.0, -6.0, 0.0], [12.0, -8.0, 0.0]), ([-12.0, 6.0, 0.0], [12.0, 8.0, 0.0])]
    whole = fibre_forces(fibre_muscle(spine, count=50), skin)
    other = fibre_forces(fibre_muscle(spine, count=count), skin)
    assert other.sum(axis=0) == pytest.approx(whole.sum(axis=0), rel=0.01, abs=0.01)
    assert np.abs(other - whole).max() < 0.05 * np.abs(whole).max()


def test_strength_scales() -> None:
    skin = domed_skin()
    once = fibre_forces(fibre_muscle(STRAP), skin)
    assert fibre_forces(fibre_muscle(STRAP, strength=2.5), skin) == pytest.approx(2.5 * once)


def test_a_fibre_without_length_has_no_force() -> None:
    forces = fibre_forces(fibre_muscle([([3.0, 1, 0], [3.0, 1, 0])]), flat_skin())
    assert np.array_equal(forces, np.zeros_like(forces))


def test_forces_point_along_the_fibres() -> None:
    skin = domed_skin()
    origin, attachment = np.array([-10.0, 5, 4]), np.array([12.0, -3, 0])
    forces = fibre_forces(fibre_muscle([(list(origin), list(attachment))]), skin)
    pull = (origin - attachment) / np.linalg.norm(origin - attachment)
    assert np.cross(forces, pull) == pytest.approx(0.0, abs=1e-12)
    assert (forces @ pull).min() >= 0.0
    assert (forces @ pull).max() > 0.5
