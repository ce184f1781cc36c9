"""Distances on the skin, against plane geometry and against an exact algorithm that shares nothing with them."""

import igl
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.painting.geodesic import Geodesics, SurfacePoint
from fem.types import FloatArray, IntArray
from tests.facemodel.skin import flat_skin
from tests.fem.meshes import irregular

SHARE = st.tuples(*[st.floats(0.0, 1.0)] * 3).map(np.array).filter(lambda b: b.sum() > 1e-3).map(lambda b: b / b.sum())
"""Barycentric coordinates, corners and edges among them."""


def distances(geodesics: Geodesics, point: SurfacePoint, radius: float) -> FloatArray:
    """Return the distance of every vertex, infinite beyond the radius."""
    found = geodesics.within(point, radius)
    result = np.full(len(geodesics.mesh.positions), np.inf)
    result[found.vertices] = found.distances
    return result


def exact(mesh: Mesh, point: SurfacePoint, radius: float) -> tuple[IntArray, FloatArray]:
    """Return vertices and their distances by the algorithm of Mitchell, Mount and Papadimitriou, as libigl has it.

    The point becomes a vertex; only triangles that a path of the radius can reach take part.
    """
    place = point.position(mesh)
    centre = mesh.positions[mesh.triangles].mean(axis=1)
    size = np.linalg.norm(mesh.positions[mesh.triangles] - centre[:, None], axis=2).max(axis=1)
    near = np.flatnonzero(np.linalg.norm(centre - place, axis=1) < radius + size)
    vertices, triangles = np.unique(mesh.triangles[near], return_inverse=True)
    triangles = triangles.reshape(-1, 3)
    own = int(np.flatnonzero(near == point.triangle)[0])
    (i, j, k), new = triangles[own], len(vertices)
    split = np.concatenate([np.delete(triangles, own, axis=0), [[i, j, new], [j, k, new], [k, i, new]]])
    nobody = np.empty(0, dtype=np.int64)
    positions = np.concatenate([mesh.positions[vertices], place[None]])
    found = igl.exact_geodesic(positions, split, np.array([new]), nobody, np.arange(new), nobody)
    return vertices, np.asarray(found)


@pytest.fixture(scope="module")
def on_face(face: Face) -> Geodesics:
    return Geodesics(face.skin)


@pytest.mark.parametrize("radius", [5.0, 10.0, 20.0, 40.0])
def test_distances_on_the_face_are_exact_to_two_percent(face: Face, on_face: Geodesics, radius: float) -> None:
    rng = np.random.default_rng(3)
    errors = []
    for triangle in rng.choice(np.flatnonzero(face.solved), 25):
        point = SurfacePoint(int(triangle), rng.dirichlet([1.0, 1.0, 1.0]))
        found = distances(on_face, point, 1.03 * radius)
        vertices, expected = exact(face.skin, point, 1.02 * radius)
        inside = (expected < 0.99 * radius) & (expected > 0)
        errors.append(found[vertices][inside] / expected[inside] - 1)
    error = np.concatenate(errors)
    assert error.min() > -1e-3, "no way is shorter than the shortest"
    assert np.percentile(error, 99) < 0.005
    assert error.max() < 0.02


@settings(max_examples=40)
@given(st.integers(0, 1799), SHARE)
def test_in_a_plane_they_are_those_of_plane_geometry(triangle: int, barycentric: FloatArray) -> None:
    point = SurfacePoint(triangle, barycentric)
    straight = np.linalg.norm(FLAT.mesh.positions - point.position(FLAT.mesh), axis=1)
    found = distances(FLAT, point, 15.0)
    inside = straight < 14.5
    assert np.all(found >= straight - 1e-3), "the point may be taken a little inside its triangle"
    assert np.all(found[inside] <= 1.02 * straight[inside] + 1e-3)
    near = straight < 5.0
    assert found[near] == pytest.approx(straight[near], abs=1e-3)
    assert np.all(np.isinf(found[straight > 15.001]))


FLAT = Geodesics(flat_skin())


def test_round_a_hole_the_way_leads_over_its_rim() -> None:
    """In the irregular square with an octagonal hole: straight to a corner of it, along its rim, and straight on."""
    surface = irregular(count=300)
    geodesics = Geodesics(Mesh(surface.positions, surface.triangles))
    distance = np.linalg.norm(surface.positions - [-0.8, 0.0, 0.0], axis=1)
    start = int(distance.argmin())
    triangle = int(np.flatnonzero((surface.triangles == start).any(axis=1))[0])
    point = SurfacePoint(triangle, (surface.triangles[triangle] == start).astype(float))
    found = distances(geodesics, point, 4.0)
    assert np.isfinite(found).all()
    _, expected = exact(geodesics.mesh, SurfacePoint(triangle, np.abs(point.barycentric - 1e-9)), 4.0)
    assert found == pytest.approx(expected, rel=0.02, abs=1e-3)
    behind = (surface.positions[:, 0] > 0.4) & (np.abs(surface.positions[:, 1]) < 0.1)
    straight = np.linalg.norm(surface.positions - surface.positions[start], axis=1)
    assert np.all(found[behind] > straight[behind] + 0.01)


def test_on_a_folded_sheet_they_are_those_of_the_sheet_laid_flat() -> None:
    flat = flat_skin(segments=20)
    x, y, _ = flat.positions.T
    fold = np.radians(70.0)
    folded = np.column_stack([np.where(x < 0, x, x * np.cos(fold)), y, np.where(x < 0, 0.0, x * np.sin(fold))])
    point = SurfacePoint(150, np.array([0.2, 0.3, 0.5]))
    bent, plain = Geodesics(flat.moved(folded)), Geodesics(flat)
    nearby = np.linalg.norm(flat.positions - point.position(flat), axis=1) < 8.0
    assert distances(bent, point, 10.0)[nearby] == pytest.approx(distances(plain, point, 10.0)[nearby], abs=1e-9)


def test_parts_that_do_not_touch_are_infinitely_far(face: Face, on_face: Geodesics) -> None:
    """Upper and lower lip lie on each other, but the way between them leads round the corner of the mouth."""
    upper, lower = (face.landmarks[f"{lip}_lip_mid"] for lip in ("upper", "lower"))
    gap = np.linalg.norm(face.skin.positions[upper] - face.skin.positions[lower])
    triangle = int(np.flatnonzero((face.skin.triangles == upper).any(axis=1))[0])
    point = SurfacePoint(triangle, (face.skin.triangles[triangle] == upper).astype(float))
    assert distances(on_face, point, 40.0)[lower] > max(10.0, 5 * gap)


def test_left_and_right_are_alike(face: Face, on_face: Geodesics) -> None:
    left = np.flatnonzero((face.skin.triangles == face.landmarks["cheek_L"]).any(axis=1))[0]
    corners = face.mirror[face.skin.triangles[left]]
    right = np.flatnonzero((np.sort(face.skin.triangles, axis=1) == np.sort(corners)).all(axis=1))[0]
    barycentric = np.array([0.5, 0.3, 0.2])
    place = [int(np.flatnonzero(corners == vertex)[0]) for vertex in face.skin.triangles[right]]
    one = distances(on_face, SurfacePoint(int(left), barycentric), 25.0)
    other = distances(on_face, SurfacePoint(int(right), barycentric[place]), 25.0)
    assert other[face.mirror] == pytest.approx(one, abs=1e-6)
