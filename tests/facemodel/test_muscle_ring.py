"""Sphincters and the levator of the lid."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from facemodel.muscles import Muscle, Sphincter
from facemodel.muscles.cosine import cosine_ring_displacements
from facemodel.muscles.lid import lid_forces
from facemodel.muscles.mouth import mouth_forces
from facemodel.muscles.sphincter import sphincter_forces
from fem.types import FloatArray
from tests.facemodel.skin import at, domed_skin, flat_skin, ring_muscle, sizes

LONG, SHORT = np.array([16.0, 0, 0]), np.array([0, 10.0, 0])
CENTRE = np.zeros(3)


def ring(**changes: object) -> Sphincter:
    return Sphincter(CENTRE, LONG, SHORT, **changes)  # type: ignore[arg-type]


def test_a_ring_pulls_with_its_whole_strength_where_it_lies_towards_its_middle() -> None:
    skin = flat_skin()
    forces = sphincter_forces(ring_muscle(ring(), strength=0.3), skin)
    assert forces[at(skin, 16, 0, 0)] == pytest.approx([-0.3, 0, 0])
    assert forces[at(skin, 0, -10, 0)] == pytest.approx([0, 0.3, 0])


def test_it_fades_over_its_width_to_both_sides_and_is_nothing_beyond() -> None:
    skin = flat_skin()
    size = sizes(sphincter_forces(ring_muscle(ring(), width=6.0), skin))
    half = (np.cos(np.pi * (4 / 6) ** 1.8) + 1) / 2
    assert size[at(skin, 20, 0, 0)] == pytest.approx(half)
    assert size[at(skin, 12, 0, 0)] == pytest.approx(half)
    assert size[at(skin, 0, 14, 0)] == pytest.approx(half)
    far = (np.abs(skin.positions[:, 0]) >= 22) | (np.abs(skin.positions[:, 1]) >= 16)
    assert np.array_equal(size[far], np.zeros(far.sum()))
    assert size[at(skin, 0, 2, 0)] == 0.0, "the inside is free"


def test_it_is_symmetric_about_both_axes() -> None:
    skin = flat_skin()
    forces = sphincter_forces(ring_muscle(ring(focus=0.4, forward=0.3)), skin)
    across = [at(skin, -x, y, z) for x, y, z in skin.positions]
    upside = [at(skin, x, -y, z) for x, y, z in skin.positions]
    assert forces[across] == pytest.approx(forces * [-1, 1, 1], abs=1e-12)
    assert forces[upside] == pytest.approx(forces * [1, -1, 1], abs=1e-12)


def test_a_whole_focus_closes_on_a_line() -> None:
    skin = flat_skin()
    forces = sphincter_forces(ring_muscle(ring(focus=1.0)), skin)
    inside = np.abs(skin.positions[:, 0]) < 15.9
    assert forces[inside, 0] == pytest.approx(0.0, abs=1e-12)
    assert np.all(forces[:, 1] * skin.positions[:, 1] <= 0.0)


@given(st.floats(0.0, 6.3), st.floats(0.0, 1.0), st.floats(-1.0, 1.0))
def test_two_half_rings_make_the_whole(turn: float, focus: float, forward: float) -> None:
    skin = domed_skin()
    sector = np.array([np.cos(turn), np.sin(turn), 0.0])
    whole = sphincter_forces(ring_muscle(ring(focus=focus, forward=forward)), skin)
    halves = [
        sphincter_forces(ring_muscle(ring(focus=focus, forward=forward, sector=sign * sector)), skin)
        for sign in (1, -1)
    ]
    assert halves[0] + halves[1] == pytest.approx(whole, abs=1e-12)


def test_a_half_ring_leaves_the_other_side_alone() -> None:
    skin = flat_skin()
    size = sizes(sphincter_forces(ring_muscle(ring(sector=np.array([1.0, 0, 0]))), skin))
    assert np.array_equal(size[skin.positions[:, 0] <= -6], np.zeros((skin.positions[:, 0] <= -6).sum()))
    assert size[at(skin, 16, 0, 0)] == pytest.approx(1.0)


def test_pursing_pushes_along_the_outward_normal_of_the_ring() -> None:
    skin = flat_skin()
    forces = sphincter_forces(ring_muscle(ring(inward=0.0, forward=1.0)), skin)
    assert forces[:, :2] == pytest.approx(0.0, abs=1e-12)
    assert forces[at(skin, 16, 0, 0), 2] == pytest.approx(1.0)


def test_a_ring_reaches_its_own_skin_and_not_the_back_of_the_head() -> None:
    skin = flat_skin()
    behind = skin.moved(skin.positions - [0, 0, 40.0])
    assert sizes(sphincter_forces(ring_muscle(ring()), behind)).max() == 0.0


def eyelid(inward: float = 1.0) -> Sphincter:
    """Return the ring of a lid about an eyeball whose middle lies 12 mm behind the skin."""
    return Sphincter(np.array([0, 0, -12.0]), LONG, SHORT, inward=inward)


def test_a_lid_is_pushed_along_the_eyeball() -> None:
    skin = domed_skin()
    lid = eyelid()
    forces = lid_forces(ring_muscle(lid, "lid"), skin)
    from_axis = (skin.positions - lid.centre) * [0, 1, 1]
    assert np.einsum("ij,ij->i", forces, from_axis) == pytest.approx(0.0, abs=1e-12)
    assert forces[:, 0] == pytest.approx(0.0, abs=1e-12)
    assert sizes(forces).max() == pytest.approx(1.0, abs=0.01)


def test_a_lid_closes_downwards_and_opens_upwards() -> None:
    skin = flat_skin()
    margin = at(skin, 0, 0, 0)
    closing = lid_forces(ring_muscle(eyelid(), "lid", strength=0.4), skin)
    opening = lid_forces(ring_muscle(eyelid(-1.0), "lid", strength=0.4), skin)
    upper = at(skin, 0, 2, 0)
    assert closing[upper, 1] < -0.2
    assert opening == pytest.approx(-closing)
    assert abs(closing[margin, 1]) <= 0.4


def test_a_lid_fades_to_the_corners_to_the_fold_and_spares_the_other_lid() -> None:
    skin = flat_skin()
    size = sizes(lid_forces(ring_muscle(eyelid(), "lid"), skin))
    x, y, _ = skin.positions.T
    still = (np.abs(x) >= 16) | (y >= 10) | (y < 0)
    assert np.array_equal(size[still], np.zeros(still.sum()))
    assert size[at(skin, 0, 2, 0)] > size[at(skin, 8, 2, 0)] > size[at(skin, 14, 2, 0)] > 0.0
    assert size[at(skin, 0, 2, 0)] > size[at(skin, 0, 6, 0)] > size[at(skin, 0, 8, 0)] > 0.0


@pytest.mark.parametrize("model", [sphincter_forces, lid_forces, mouth_forces, cosine_ring_displacements])
def test_a_ring_that_is_missing_is_named(model: Callable[[Muscle, Mesh], FloatArray]) -> None:
    with pytest.raises(FaceError, match=r"Muscle “ring_L” is a .* without a ring; give it"):
        model(ring_muscle(None), flat_skin())
