"""The models of Choe, Lee and Ko 2001 and of Hung and Huang 1995 at points computed by hand."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.face import Face
from facemodel.jaw.motion import jaw_motion
from facemodel.muscles import Cosine, Muscle, Profile, Profiles, Sphincter
from facemodel.muscles.cosine import cosine_displacements, cosine_ring_displacements, radius
from facemodel.muscles.jaw import jaw_force
from facemodel.muscles.mouth import PROFILES, mouth_forces
from facemodel.muscles.quadrilateral import nearest_on_line, quadrilateral_forces
from fem.types import FloatArray
from tests.facemodel.skin import at, domed_skin, fibre_muscle, flat_skin, ring_muscle, sizes

# Origin p1 p2 on the line x = -20, insertion p3 p4 on x = 10, both from y = -6 to y = 6.
SHEET = [([-20.0, -6.0, 0.0], [10.0, -6.0, 0.0]), ([-20.0, 6.0, 0.0], [10.0, 6.0, 0.0])]
RING = Sphincter(np.zeros(3), np.array([16.0, 0, 0]), np.array([0, 10.0, 0]))
HALF_MASK = np.array([1.0, 0.0, 0.0])


def sheet(**changes: float) -> Muscle:
    return replace(fibre_muscle(SHEET, width=8.0, strength=0.5), **changes)  # type: ignore[arg-type]


def test_a_quadrilateral_pulls_from_its_insertion_towards_its_origin() -> None:
    skin = flat_skin()
    forces = quadrilateral_forces(sheet(), skin)
    # On the insertion r = 0: the whole force, straight to the nearest point of the origin.
    assert forces[at(skin, 10, 4, 0)] == pytest.approx([-0.5, 0, 0])
    # Four of eight millimetres beside it: half the force.
    assert forces[at(skin, 14, 0, 0)] == pytest.approx([-0.25, 0, 0])
    assert forces[at(skin, 6, -2, 0)] == pytest.approx([-0.25, 0, 0])
    # Beyond the corner p3 the distance is to the corner, and the pull goes to the corner p2.
    place, corner, origin = np.array([10.0, 10, 0]), np.array([10.0, 6, 0]), np.array([-20.0, 6, 0])
    share = 1 - np.linalg.norm(place - corner) / 8
    pull = (origin - place) / np.linalg.norm(origin - place)
    assert forces[at(skin, *place)] == pytest.approx(0.5 * share * pull)


def test_only_the_insertion_area_is_pulled() -> None:
    skin = flat_skin()
    size = sizes(quadrilateral_forces(sheet(), skin))
    insertion = np.array([[10.0, -6, 0], [10.0, 6, 0]])
    away = sizes(skin.positions - nearest_on_line(skin.positions, insertion))
    assert np.array_equal(size > 0, away < 8.0)
    assert size == pytest.approx(0.5 * np.maximum(1 - away / 8, 0))


@given(st.floats(2.0, 30.0), st.floats(2.0, 30.0))
def test_a_larger_radius_never_pulls_less(first: float, second: float) -> None:
    skin = flat_skin(segments=12)
    small, large = (sizes(quadrilateral_forces(sheet(width=r), skin)) for r in sorted((first, second)))
    assert (large - small).min() >= -1e-12


def test_a_single_fibre_is_a_sheet_without_width() -> None:
    skin = flat_skin()
    forces = quadrilateral_forces(fibre_muscle([([0.0, 20, 0], [0.0, -10, 0])], width=8.0), skin)
    assert forces[at(skin, 0, -10, 0)] == pytest.approx([0, 1, 0])
    assert forces[at(skin, 0, -6, 0)] == pytest.approx([0, 0.5, 0])
    assert sizes(forces)[sizes(skin.positions - [0, -10, 0]) >= 8].max() == 0.0


def test_a_vertex_on_the_origin_is_not_pulled_anywhere() -> None:
    skin = flat_skin()
    forces = quadrilateral_forces(fibre_muscle([([0.0, 0, 0], [4.0, 0, 0])], width=8.0), skin)
    assert np.array_equal(forces[at(skin, 0, 0, 0)], np.zeros(3))


def test_the_profiles_pass_through_their_knots_without_overshoot_and_end() -> None:
    profile = Profile((0.0, 0.5, 1.0, 1.7), (0.0, 0.4, 1.0, 0.0))
    assert profile(np.array([0.0, 0.5, 1.0, 1.7, 3.0])) == pytest.approx([0, 0.4, 1, 0, 0])
    fine = profile(np.linspace(0, 2, 500))
    assert fine.min() >= 0.0
    assert fine.max() <= 1.0 + 1e-12
    rising = profile(np.linspace(0, 1, 100))
    assert np.all(np.diff(rising) >= 0)


def mouth(ring: Sphincter = RING, **changes: object) -> Muscle:
    return replace(ring_muscle(ring, "mouth", strength=0.5), **changes)  # type: ignore[arg-type]


def test_the_mouth_pulls_to_its_centre_with_sigma_and_purses_with_tau() -> None:
    skin = flat_skin()
    forces = mouth_forces(mouth(), skin)
    # s = 1 at the tips of both half axes, whatever their length.
    assert forces[at(skin, 16, 0, 0)] == pytest.approx([-0.5 * 1.0, 0, 0.5 * 0.9])
    assert forces[at(skin, 0, 10, 0)] == pytest.approx([0, -0.5 * 1.0, 0.5 * 0.9])
    # s = 1/2, towards the centre and not along a normal of the ellipse.
    place = np.array([4.0, 4.0, 0.0])
    s = np.hypot(4 / 16, 4 / 10)
    inward = 0.5 * PROFILES.sigma(np.array([s]))[0] * -place / np.linalg.norm(place)
    purse = 0.5 * PROFILES.tau(np.array([s]))[0]
    assert forces[at(skin, *place)] == pytest.approx([inward[0], inward[1], purse])


def test_the_mouth_ends_at_the_last_knot_and_has_no_side_in_its_middle() -> None:
    skin = flat_skin()
    forces = mouth_forces(mouth(), skin)
    s = np.hypot(skin.positions[:, 0] / 16, skin.positions[:, 1] / 10)
    assert sizes(forces)[s >= 1.7].max() == 0.0
    assert forces[at(skin, 0, 0, 0)] == pytest.approx([0, 0, 0.5 * 0.5])


def test_an_edited_profile_presses_lips_instead_of_pursing_them() -> None:
    skin = flat_skin()
    pressing = Profiles(Profile((0.0, 1.0, 2.0), (0.0, 0.5, 0.0)), Profile((0.0, 1.5), (-0.4, 0.0)))
    forces = mouth_forces(mouth(profiles=pressing), skin)
    assert forces[at(skin, 16, 0, 0), 0] == pytest.approx(-0.25)
    assert forces[at(skin, 16, 0, 0), 2] < 0.0
    assert forces[at(skin, 0, 0, 0), 2] == pytest.approx(-0.2)


def test_two_half_mouths_make_the_whole_and_each_is_the_others_mirror_image() -> None:
    skin = flat_skin()
    halves = [mouth_forces(mouth(replace(RING, sector=sign * HALF_MASK)), skin) for sign in (1, -1)]
    assert halves[0] + halves[1] == pytest.approx(mouth_forces(mouth(), skin), abs=1e-12)
    across = [at(skin, -x, y, z) for x, y, z in skin.positions]
    assert halves[1] == pytest.approx(halves[0][across] * [-1, 1, 1], abs=1e-12)


def jaw_muscle(strength: float = 1.0) -> Muscle:
    return Muscle("jaw", "M", "Opening", "chin", "jaw", (), None, 10.0, 1.0, strength, 1)


def test_the_jaw_force_is_square_to_axis_and_arm_and_grows_with_the_arm(face: Face) -> None:
    forces = jaw_force(jaw_muscle(0.3), face)
    right, left = face.skull.jaw.axis
    axis = (left - right) / np.linalg.norm(left - right)
    arm = face.skin.positions - right
    arm = arm - (arm @ axis)[:, None] * axis
    assert np.einsum("ij,ij->i", forces, arm) == pytest.approx(0.0, abs=1e-9)
    assert forces @ axis == pytest.approx(0.0, abs=1e-12)
    teeth = face.skull.jaw.teeth - right
    reach = np.linalg.norm(teeth - (teeth @ axis) * axis)
    assert sizes(forces) == pytest.approx(0.3 * face.skull.jawbone * sizes(arm) / reach)


def test_the_jaw_force_is_the_beginning_of_the_jaws_turn(face: Face) -> None:
    small = 1e-4
    motion = jaw_motion(face.skull.jaw, small, 0.0)
    moved = face.skin.positions @ motion[:3, :3].T + motion[:3, 3] - face.skin.positions
    forces = jaw_force(jaw_muscle(), face)
    jawed = face.skull.jawbone > 0.9
    cosine = np.einsum("ij,ij->i", forces[jawed], moved[jawed]) / sizes(forces[jawed]) / sizes(moved[jawed])
    assert cosine.min() > 1 - 1e-6
    assert forces[face.landmarks["chin"], 1] < 0.0
    assert np.array_equal(forces[face.landmarks["glabella"]], np.zeros(3))


def pseudo(**changes: object) -> Muscle:
    single = fibre_muscle([([0.0, 20, 4], [0.0, -8, 0])], width=12.0)
    values: dict[str, object] = {"model": "cosine", "cosine": Cosine(np.full(3, 12.0), 0.25, np.zeros(3))}
    return replace(single, **(values | changes))  # type: ignore[arg-type]


def test_a_linear_pseudo_muscle_moves_all_vertices_parallel_by_a_cosine() -> None:
    skin = flat_skin()
    moved = cosine_displacements(pseudo(), skin)
    way = 0.25 * np.array([0.0, 28, 4])
    assert moved[at(skin, 0, -8, 0)] == pytest.approx(way)
    # Half the radius away: (1 + cos(pi/2)) / 2 = 1/2; a third: 3/4.
    assert moved[at(skin, 6, -8, 0)] == pytest.approx(way / 2)
    assert moved[at(skin, 0, -12, 0)] == pytest.approx(way * 3 / 4)
    assert sizes(moved)[sizes(skin.positions - [0, -8, 0]) >= 12].max() == 0.0


def test_past_the_radius_the_cosine_does_not_rise_again_in_a_larger_box() -> None:
    skin = flat_skin()
    wide = pseudo(cosine=Cosine(np.full(3, 40.0), 0.25, np.zeros(3)))
    assert cosine_displacements(wide, skin) == pytest.approx(cosine_displacements(pseudo(), skin))


def test_the_bounding_box_cuts_what_lies_outside_it() -> None:
    skin = flat_skin()
    narrow = pseudo(cosine=Cosine(np.array([4.0, 12, 12]), 0.25, np.zeros(3)))
    moved, whole = cosine_displacements(narrow, skin), cosine_displacements(pseudo(), skin)
    inside = np.abs(skin.positions[:, 0]) <= 4.0
    assert np.array_equal(moved[inside], whole[inside])
    assert sizes(moved)[~inside].max() == 0.0


@given(st.floats(0.0, 1.0))
def test_a_share_of_one_takes_the_attachment_to_the_origin(share: float) -> None:
    skin = flat_skin(segments=30)
    moved = cosine_displacements(pseudo(cosine=Cosine(np.full(3, 12.0), share, np.zeros(3))), skin)
    assert moved[at(skin, 0, -8, 0)] == pytest.approx(share * np.array([0, 28, 4]), abs=1e-12)


@given(st.floats(4.0, 40.0))
def test_by_default_the_skin_does_not_fold_over_itself(width: float) -> None:
    skin = flat_skin(segments=60)
    moved = skin.positions + cosine_displacements(pseudo(width=width, cosine=None), skin)
    assert skin.moved(moved).triangle_normals[:, 2].min() > 0.0
    far = cosine_displacements(pseudo(width=width, cosine=Cosine(np.full(3, width), 1.0, np.zeros(3))), skin)
    assert skin.moved(skin.positions + far).triangle_normals[:, 2].min() < 0.0, "all the way it would"


def ring_pseudo(factors: tuple[float, float, float]) -> Muscle:
    return replace(
        ring_muscle(RING, "cosine_ring", width=4.0), cosine=Cosine(np.full(3, 40.0), 0.25, np.array(factors))
    )


def test_a_pseudo_sphincter_contracts_with_a_positive_k_and_expands_with_a_negative_one() -> None:
    skin = flat_skin()
    muscle = ring_pseudo((0.4, -0.2, 0.0))
    assert radius(muscle) == 20.0
    moved = cosine_ring_displacements(muscle, skin)
    # Half the radius: weight 1/2, times the distance of 10 and K.
    assert moved[at(skin, 10, 0, 0)] == pytest.approx([-0.5 * 0.4 * 10, 0, 0])
    assert moved[at(skin, 0, 10, 0)] == pytest.approx([0, 0.5 * 0.2 * 10, 0])
    assert moved[at(skin, -10, 0, 0)] == pytest.approx([0.5 * 0.4 * 10, 0, 0])
    assert np.array_equal(moved[at(skin, 0, 0, 0)], np.zeros(3))
    assert sizes(moved)[sizes(skin.positions) >= 20].max() == 0.0


@given(st.floats(0.0, 6.2))
def test_the_axes_of_k_are_those_of_the_ring(turn: float) -> None:
    along, up = np.array([np.cos(turn), np.sin(turn), 0]), np.array([-np.sin(turn), np.cos(turn), 0])
    turned = replace(ring_pseudo((0.5, 0.1, 0.0)), ring=replace(RING, long_axis=16 * along, short_axis=10 * up))
    skin = domed_skin(segments=8)
    moved = cosine_ring_displacements(turned, skin)
    weight = (1 + np.cos(np.pi * np.minimum(sizes(skin.positions) / 20, 1))) / 2
    assert moved @ along == pytest.approx(-0.5 * weight * (skin.positions @ along), abs=1e-12)
    assert moved @ up == pytest.approx(-0.1 * weight * (skin.positions @ up), abs=1e-12)


def peak(weights: FloatArray) -> float:
    return float(np.abs(weights).max())


def test_strength_scales_forces_and_leaves_displacements_alone() -> None:
    skin = domed_skin()
    assert quadrilateral_forces(sheet(strength=1.5), skin) == pytest.approx(3 * quadrilateral_forces(sheet(), skin))
    assert mouth_forces(mouth(strength=1.5), skin) == pytest.approx(3 * mouth_forces(mouth(), skin))
    assert np.array_equal(cosine_displacements(pseudo(strength=9.0), skin), cosine_displacements(pseudo(), skin))
    assert peak(cosine_displacements(pseudo(), skin)) > 0.0
