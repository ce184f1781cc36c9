"""The look of a face is read off its shape: warm where blood is near, dark where light does not reach, even-sided."""

from collections.abc import Callable

import numpy as np
import pytest

from facemodel.dental_arch import is_strip
from facemodel.face import Face
from facemodel.faces import face_keys, load_face
from facemodel.mesh import Mesh
from tests.app.conftest import small_face
from ui.viewport.brows import strokes
from ui.viewport.complexion import PALETTES, complexion, has_features, lip_share, openings, rings
from ui.viewport.look import look_of
from ui.viewport.occlusion import openness
from ui.viewport.teeth import row_of_teeth


@pytest.fixture(scope="module", params=face_keys())
def face(request: pytest.FixtureRequest) -> Face:
    return load_face(request.param)


@pytest.fixture(scope="module")
def at(face: Face) -> Callable[[str], int]:
    return lambda name: face.landmarks[name]


def test_lips_end_at_the_landmarks_of_the_vermilion(face: Face, at: Callable[[str], int]) -> None:
    share = lip_share(face)
    assert share[[at("upper_lip_incisor"), at("lower_lip_incisor")]].min() > 0.95
    assert share[[at("subnasale"), at("chin_lip_fold"), at("pogonion"), at("nasolabial_L")]].max() == 0
    assert np.allclose(share, share[face.mirror], atol=1e-6)


def test_lips_cheeks_and_nose_are_redder_than_the_forehead(face: Face, at: Callable[[str], int]) -> None:
    colours = complexion(face).colours
    red = colours[:, 0] / colours[:, 1:].mean(axis=1)
    forehead = red[at("frontal_eminence_L")]
    for name in ("lower_lip_incisor", "cheek_L", "cheek_R", "nose_tip"):
        assert red[at(name)] > forehead
    assert red[at("lower_lip_incisor")] > red[at("cheek_L")]


def test_colours_are_even_sided(face: Face) -> None:
    look = look_of(face)
    assert np.allclose(look.colours, look.colours[face.mirror], atol=1e-6)
    assert np.abs(look.open - look.open[face.mirror]).max() < 0.2
    assert np.abs(look.open - look.open[face.mirror]).mean() < 0.01


def test_the_forehead_lies_open_and_hollows_are_dark(face: Face, at: Callable[[str], int]) -> None:
    open_ = openness(face.skin, face.skin)
    assert open_[at("supraglabella")] > 0.95
    assert open_[at("subnasale")] < open_[at("upper_vermilion")]
    assert open_[at("chin_lip_fold")] < open_[at("pogonion")]
    wing, tip = face.skin.positions[at("ala_L")], face.skin.positions[at("nose_tip")]
    between = np.linalg.norm(face.skin.positions - (0.6 * wing + 0.4 * tip), axis=1) < 10
    assert look_of(face).open[between].min() < 0.1


def test_people_have_their_own_colours() -> None:
    assert set(PALETTES) == set(face_keys())
    tones = [look_of(load_face(key)).colours.mean(axis=0) for key in face_keys()]
    assert min(np.abs(a - b).max() for k, a in enumerate(tones) for b in tones[:k]) > 0.005


def test_brows_lie_over_the_eyes_and_are_mirror_images(face: Face) -> None:
    detail = look_of(face).detail
    assert detail is not None
    height, width = detail.image.shape[:2]
    cover = {}
    for side in "LR":
        hairs = strokes(face, side)
        assert len(hairs.points) == len(hairs.weight)
        vertex = face.landmarks[f"brow_mid_{side}"]
        x, y = (detail.coordinates[vertex] * [width, height]).astype(int)
        cover[side] = detail.image[y - 12 : y + 13, x - 12 : x + 13, 0].mean()
        assert cover[side] > 60
    assert cover["L"] == pytest.approx(cover["R"], rel=0.35)
    for name in ("glabella", "cheek_L", "frontal_eminence_L", "eye_inner_L"):
        x, y = (detail.coordinates[face.landmarks[name]] * [width, height]).astype(int)
        assert detail.image[y, x, 0] == 0


def test_the_detail_is_neutral_where_it_goes_on_over_the_rest_of_the_head(face: Face) -> None:
    detail = look_of(face).detail
    assert detail is not None
    edge = np.concatenate([detail.image[0], detail.image[-1], detail.image[:, 0], detail.image[:, -1]])
    assert (edge == [0, 128, 128, 0]).all()


def test_rings_count_edges_from_a_loop(face: Face) -> None:
    mouth = openings(face)[0]
    ring = rings(face.skin, mouth, 5)
    assert set(np.flatnonzero(ring == 0)) == set(mouth)
    a, b = face.skin.edges.T
    assert np.abs(ring[a] - ring[b]).max() == 1
    assert ring.max() == 5


def test_a_hemisphere_shades_half_of_the_sky_from_a_point_beside_a_wall() -> None:
    floor = Mesh(np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, -1]]), np.array([[0, 1, 2]]))
    wall = Mesh(np.array([[-1e4, 0, 0.1], [1e4, 0, 0.1], [0, 1e4, 0.1]]), np.array([[0, 1, 2]]))
    free = openness(floor, floor.moved(floor.positions - np.array([0, 5, 0])))
    beside = openness(floor, wall, rays=4000)
    assert free == pytest.approx([1.0, 1.0, 1.0])
    assert beside[0] == pytest.approx(0.5, abs=0.03)


def test_a_face_without_landmarks_has_one_colour_and_no_detail() -> None:
    bare = small_face()
    assert not has_features(bare)
    look = look_of(bare)
    assert look.detail is None
    assert np.ptp(look.colours, axis=0).max() == 0


def test_a_row_of_teeth_is_light_in_front_and_ends_in_the_dark_alike_on_both_sides(face: Face) -> None:
    for part in face.parts:
        if part.kind != "teeth":
            continue
        surface = row_of_teeth(part)
        light, points = surface.colours[:, 3].astype(int), surface.points
        behind = points[:, 2].max() - points[:, 2]
        assert light.max() > 240
        assert behind[light > 200].max() < 16.0
        assert light[behind > 25.0].max() < 30
        right, left = (np.sort(light[points[:, 0] * side > 0.5]) for side in (-1.0, 1.0))
        assert len(right) == len(left)
        assert np.abs(right - left).max() <= 2


def test_a_strip_becomes_fourteen_teeth_in_its_place(face: Face) -> None:
    for part in face.parts:
        if part.kind != "teeth":
            continue
        assert is_strip(part)
        surface = row_of_teeth(part)
        assert surface.colours is not None
        low, high = part.mesh.positions.min(axis=0) - 3.0, part.mesh.positions.max(axis=0) + 3.0
        assert ((surface.points > low) & (surface.points < high)).all()
        front = surface.colours[:, :3].sum(axis=1)[surface.points[:, 2] > np.quantile(surface.points[:, 2], 0.8)]
        assert front.max() > 1.8 * front.min()
