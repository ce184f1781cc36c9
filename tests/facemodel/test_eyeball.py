"""An eyeball is a sphere with a clear cap, an iris in it and a black hole in the middle."""

import numpy as np
import pytest

from facemodel.eyeball import CORNEA_CURVATURE, IRIS_RADIUS, PUPIL_RADIUS, EyeballMesh, Region, cornea_cap, eyeball
from facemodel.face import Eye
from fem.types import FloatArray

CENTRE = np.array([30.0, 17.0, 24.0])


@pytest.fixture(scope="module")
def eye() -> Eye:
    return Eye("L", CENTRE, 13.0)


@pytest.fixture(scope="module")
def made(eye: Eye) -> EyeballMesh:
    return eyeball(eye)


def vertices(made: EyeballMesh, *regions: Region) -> np.ndarray:
    return np.unique(made.mesh.triangles[np.isin(made.regions, regions)])


def brightness(made: EyeballMesh, chosen: np.ndarray) -> FloatArray:
    return made.colours[chosen, :3].mean(axis=1)


def from_axis(made: EyeballMesh, chosen: np.ndarray) -> FloatArray:
    return np.linalg.norm((made.mesh.positions[chosen] - CENTRE)[:, :2], axis=1)


def test_the_white_lies_on_the_sphere(made: EyeballMesh, eye: Eye) -> None:
    white = made.mesh.positions[vertices(made, Region.SCLERA)]
    assert np.allclose(np.linalg.norm(white - eye.centre, axis=1), eye.radius)


def test_the_cornea_is_a_cap_that_bulges_over_the_sphere(made: EyeballMesh, eye: Eye) -> None:
    cap = made.mesh.positions[vertices(made, Region.CORNEA)]
    middle, radius = cornea_cap(eye)
    assert radius == CORNEA_CURVATURE
    assert np.allclose(np.linalg.norm(cap - middle, axis=1), radius, atol=0.05)
    bulge = cap[:, 2].max() - (eye.centre[2] + eye.radius)
    assert 0.5 < bulge < 2.5


def test_the_cornea_covers_the_iris_without_touching_it(made: EyeballMesh, eye: Eye) -> None:
    iris = made.mesh.positions[vertices(made, Region.IRIS)]
    middle, radius = cornea_cap(eye)
    depth = radius - np.linalg.norm(iris - middle, axis=1)
    assert depth.min() > 0.05
    assert np.linalg.norm((iris - eye.centre)[:, :2], axis=1).max() == pytest.approx(IRIS_RADIUS)


def test_iris_and_white_meet_without_a_gap(made: EyeballMesh) -> None:
    iris = made.mesh.positions[vertices(made, Region.IRIS)]
    white = made.mesh.positions[vertices(made, Region.SCLERA)]
    edge = iris[np.linalg.norm((iris - CENTRE)[:, :2], axis=1) > IRIS_RADIUS - 1e-6]
    gaps = np.linalg.norm(edge[:, None] - white[None], axis=2).min(axis=1)
    assert gaps.max() < 1e-6


def test_only_the_cornea_is_clear(made: EyeballMesh) -> None:
    clear = made.colours[:, 3] < 1
    assert set(np.flatnonzero(clear)) == set(vertices(made, Region.CORNEA))


def test_pupil_is_black_white_is_white_and_a_dark_ring_rims_the_iris(made: EyeballMesh) -> None:
    iris = vertices(made, Region.IRIS)
    share = (from_axis(made, iris) - PUPIL_RADIUS) / (IRIS_RADIUS - PUPIL_RADIUS)
    light = brightness(made, iris)
    body, ring = light[(share > 0.3) & (share < 0.7)].mean(), light[share > 0.95].mean()
    white = vertices(made, Region.SCLERA)
    front = white[(made.mesh.positions[white, 2] > CENTRE[2]) & (from_axis(made, white) > IRIS_RADIUS + 1.5)]
    assert brightness(made, vertices(made, Region.PUPIL)).max() < 0.05
    assert ring < 0.6 * body
    assert brightness(made, front).mean() > 1.5 * body


def test_the_white_is_warmer_towards_the_corners(made: EyeballMesh) -> None:
    white = vertices(made, Region.SCLERA)
    place = (made.mesh.positions[white] - CENTRE) / 13.0
    warmth = made.colours[white, 0] - made.colours[white, 2]
    beside = warmth[(np.abs(place[:, 0]) > 0.9) & (place[:, 2] > 0)].mean()
    above = warmth[(np.abs(place[:, 1]) > 0.9) & (place[:, 2] > 0)].mean()
    assert beside > above + 0.03


def test_fibres_vary_round_the_iris_and_not_across_the_pupil(made: EyeballMesh) -> None:
    iris = vertices(made, Region.IRIS)
    share = (from_axis(made, iris) - PUPIL_RADIUS) / (IRIS_RADIUS - PUPIL_RADIUS)
    around = brightness(made, iris)[np.abs(share - 0.5) < 0.03]
    assert around.std() > 0.03
    assert brightness(made, vertices(made, Region.PUPIL)).std() == pytest.approx(0.0, abs=1e-12)


def test_triangles_and_normals_face_outwards(made: EyeballMesh) -> None:
    towards = made.mesh.positions[made.mesh.triangles].mean(axis=1) - CENTRE
    assert (np.einsum("ij,ij->i", made.mesh.triangle_normals, towards) > 0).all()
    assert np.allclose(np.linalg.norm(made.normals, axis=1), 1.0)
    facing = np.einsum("ij,ij->i", made.normals[made.mesh.triangles[:, 0]], made.mesh.triangle_normals)
    assert (facing > 0).all()


def test_the_right_eye_is_the_mirror_image_of_the_left_one(made: EyeballMesh, eye: Eye) -> None:
    other = eyeball(Eye("R", eye.centre * [-1, 1, 1], eye.radius))
    assert np.allclose(other.mesh.positions * [-1, 1, 1], made.mesh.positions)
    assert np.array_equal(other.colours, made.colours)
    assert (np.einsum("ij,ij->i", other.mesh.triangle_normals, other.normals[other.mesh.triangles[:, 0]]) > 0).all()


def test_parts_number_their_own_vertices(made: EyeballMesh) -> None:
    for mesh, index in (made.opaque, made.cornea):
        assert np.array_equal(mesh.positions, made.mesh.positions[index])
    assert len(made.opaque[0].triangles) + len(made.cornea[0].triangles) == len(made.regions)


def test_an_eye_smaller_than_its_cornea_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"eye R .* radius of 5 mm"):
        eyeball(Eye("R", CENTRE, 5.0))
