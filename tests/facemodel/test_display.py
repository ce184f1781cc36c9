"""The drawn surface: the element's own smooth surface, through the skin's vertices, without a kink."""

import numpy as np
import pytest

from facemodel.basis import Basis
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.sampling import display_surface
from facemodel.solve import FaceSystem
from fem import edge_topology, sample_operators
from fem.types import FloatArray, IntArray
from tests.facemodel.places import points_of_vertices


def test_points_pass_through_the_vertices_of_the_skin(face: Face, display: DisplaySurface) -> None:
    on_vertices = points_of_vertices(face, display)
    assert on_vertices.min() >= 0
    assert np.array_equal(display.points[on_vertices], face.skin.positions.astype(np.float32))


@pytest.mark.parametrize("density", [1, 2, 4])
def test_a_density_has_its_count_of_points_and_triangles(face: Face, assembled: FaceSystem, density: int) -> None:
    found = display_surface(face, assembled.head, density)
    skin = face.skin
    inside = (density - 1) * (density - 2) // 2
    assert len(found.points) == len(skin.positions) + len(skin.edges) * (density - 1) + len(skin.triangles) * inside
    assert len(found.triangles) == len(skin.triangles) * density**2
    assert np.array_equal(np.unique(found.triangles), np.arange(len(found.points)))
    assert len(found.slopes[0]) == found.moving


def test_the_moving_points_come_first_and_lie_on_solved_elements(face: Face, display: DisplaySurface) -> None:
    assert face.solved[display.elements[: display.moving]].all()
    assert not face.solved[display.elements[display.moving :]].any()
    assert display.barycentric.sum(axis=1) == pytest.approx(1.0)


def test_triangles_keep_their_outside(face: Face, display: DisplaySurface) -> None:
    drawn = Mesh(display.points.astype(np.float64), display.triangles)
    fine = drawn.triangle_normals / np.linalg.norm(drawn.triangle_normals, axis=1, keepdims=True)
    analytic = display.normals[display.triangles].mean(axis=1)
    assert np.percentile(np.einsum("ij,ij->i", fine, analytic), 0.5) > 0.5


def test_a_finer_sampling_approaches_the_analytic_normals(face: Face, assembled: FaceSystem) -> None:
    errors = []
    for density in (1, 2, 6):
        display = display_surface(face, assembled.head, density)
        normals = Mesh(display.points.astype(np.float64), display.triangles).normals
        inner = np.setdiff1d(np.arange(len(display.points)), np.concatenate(loops_of(display)))
        cosine = np.einsum("ij,ij->i", normals[inner], display.normals[inner])
        errors.append(np.degrees(np.arccos(np.clip(cosine, -1, 1))).mean())
    assert errors[0] > 1.5 * errors[1]
    assert errors[1] > 2.0 * errors[2]
    assert errors[2] < 2.0


def loops_of(display: DisplaySurface) -> tuple[IntArray, ...]:
    return Mesh(display.points.astype(np.float64), display.triangles).boundary_loops


def evaluated(assembled: FaceSystem, elements: IntArray, barycentric: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return positions (n, 3) and slopes (n, 2, 3) of the smooth surface."""
    sample = sample_operators(assembled.head.assembler, elements, barycentric)
    coefficients = assembled.head.coefficients
    return sample.value @ coefficients, np.stack([sample.d_u @ coefficients, sample.d_v @ coefficients], axis=1)


def test_slopes_are_the_derivatives_of_the_points(face: Face, assembled: FaceSystem) -> None:
    rng = np.random.default_rng(5)
    elements = rng.choice(len(face.skin.triangles), 400)
    barycentric = rng.dirichlet([4.0, 4.0, 4.0], 400)
    aside = rng.standard_normal((400, 3)) * 1e-5
    aside -= aside.mean(axis=1, keepdims=True)
    _, slopes = evaluated(assembled, elements, barycentric)
    ahead, _ = evaluated(assembled, elements, barycentric + aside)
    behind, _ = evaluated(assembled, elements, barycentric - aside)
    step = np.einsum("nk,nkc->nc", 2 * aside, face.chart[face.skin.triangles[elements]])
    assert ahead - behind == pytest.approx(np.einsum("nc,ncx->nx", step, slopes), abs=1e-9)


def test_both_sides_of_every_edge_have_the_same_point_and_normal(face: Face, assembled: FaceSystem) -> None:
    triangles = face.skin.triangles
    edges, triangle_edges = edge_topology(triangles)
    sides: list[list[tuple[int, int]]] = [[] for _ in edges]
    for element, own in enumerate(triangle_edges):
        for corner, edge in enumerate(own):
            sides[edge].append((element, corner))
    inner = [pair for pair in sides if len(pair) == 2]
    along = np.random.default_rng(3).uniform(0.05, 0.95, len(inner))
    points, normals = [], []
    for side in (0, 1):
        element, corner = np.array([pair[side] for pair in inner]).T
        first = triangles[element, (corner + 1) % 3] < triangles[element, (corner + 2) % 3]
        share = np.where(first, along, 1 - along)
        barycentric = np.zeros((len(inner), 3))
        rows = np.arange(len(inner))
        barycentric[rows, (corner + 1) % 3], barycentric[rows, (corner + 2) % 3] = share, 1 - share
        point, slopes = evaluated(assembled, element, barycentric)
        normal = np.cross(slopes[:, 0], slopes[:, 1])
        points.append(point)
        normals.append(normal / np.linalg.norm(normal, axis=1, keepdims=True))
    assert points[0] == pytest.approx(points[1], abs=1e-9)
    assert normals[0] == pytest.approx(normals[1], abs=1e-7)


def test_normals_are_units_and_match_the_slopes(display: DisplaySurface) -> None:
    assert np.linalg.norm(display.normals, axis=1) == pytest.approx(1.0, abs=1e-5)
    d_u, d_v = display.slopes[:3].T.astype(np.float64), display.slopes[3:].T.astype(np.float64)
    normal = np.cross(d_u, d_v)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    assert np.abs(normal - display.normals[: display.moving]).max() < 1e-3


def points_on_rim(face: Face, display: DisplaySurface) -> IntArray:
    """Return the moving points on the seam between the solved face and the held rest."""
    seam = np.intersect1d(face.skin.triangles[face.solved], face.skin.triangles[~face.solved])
    corners = face.skin.triangles[display.elements[: display.moving]]
    weight_on_seam = (display.barycentric[: display.moving] * np.isin(corners, seam)).sum(axis=1)
    _, triangle_edges = edge_topology(face.skin.triangles)
    held_edges = np.unique(triangle_edges[~face.solved])
    on_edge = display.barycentric[: display.moving] < 1e-9
    of_point = triangle_edges[display.elements[: display.moving]]
    return np.flatnonzero((weight_on_seam > 1 - 1e-9) & (on_edge & np.isin(of_point, held_edges)).any(axis=1))


def test_the_face_joins_the_held_rest_without_step_or_kink(face: Face, basis: Basis) -> None:
    """Every field vanishes along the rim with its slopes, so that points and normals stay where they are."""
    rim = points_on_rim(face, basis.display)
    assert len(rim) > 50
    slopes = basis.slopes.reshape(len(basis.names), 6, -1)
    for row, name in enumerate(basis.names):
        field, scale = basis.moving_field(name), basis.peak(name)
        assert np.abs(field[rim]).max() < 1e-6 * scale
        assert np.abs(slopes[row][:, rim]).max() < 1e-5 * np.abs(slopes[row]).max()
