"""Sampling a field: operators, the regular subdivision, and its smoothness."""

import numpy as np
import pytest

from fem import HCT9, HCT12, Assembler, Element, FemError, sample_operators, subdivide
from tests.fem.meshes import chart_points, domed, irregular, plate, points_inside
from tests.fem.polynomials import interpolant, of_degree

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)


@BOTH
def test_operators_read_value_and_slopes_of_a_polynomial(element: Element) -> None:
    assembler = Assembler(domed(irregular()), element)
    field = of_degree(3 if element is HCT12 else 2)
    elements, barycentric = points_inside(assembler.surface)
    points = chart_points(assembler.surface, elements, barycentric)
    operators = sample_operators(assembler, elements, barycentric)
    dofs = interpolant(assembler, field)
    assert operators.value @ dofs == pytest.approx(field(points), rel=1e-10)
    assert operators.d_u @ dofs == pytest.approx(field.derivative(1, 0)(points), abs=1e-10)
    assert operators.d_v @ dofs == pytest.approx(field.derivative(0, 1)(points), abs=1e-10)


@pytest.mark.parametrize("segments", [1, 2, 3, 5])
def test_subdivision_is_a_consistent_mesh(segments: int) -> None:
    surface = irregular()
    fine = subdivide(surface.triangles, segments)
    n_points = (
        surface.n_vertices
        + len(surface.edges) * (segments - 1)
        + surface.n_triangles * (segments - 1) * (segments - 2) // 2
    )
    assert len(fine.elements) == len(fine.barycentric) == n_points
    assert len(fine.triangles) == surface.n_triangles * segments**2
    assert set(fine.triangles.ravel()) == set(range(n_points))
    points = chart_points(surface, fine.elements, fine.barycentric)
    assert np.array_equal(points[: surface.n_vertices], surface.chart)
    corners = points[fine.triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    areas = 0.5 * (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    assert areas == pytest.approx(np.repeat(surface.chart_areas / segments**2, segments**2))


def test_subdivided_triangles_share_their_points() -> None:
    surface = irregular()
    fine = subdivide(surface.triangles, 4)
    pairs = np.sort(fine.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, users = np.unique(pairs, axis=0, return_counts=True)
    assert users.max() == 2
    assert (users == 1).sum() == 4 * len(surface.boundary_edges)


@BOTH
def test_a_shared_point_reads_the_same_from_either_triangle(element: Element) -> None:
    surface = irregular()
    assembler = Assembler(surface, element)
    segments = 3
    fine = subdivide(surface.triangles, segments)
    field = np.random.default_rng(0).standard_normal(assembler.dofs.n_dofs)
    own = sample_operators(assembler, fine.elements, fine.barycentric)
    # Read every fine corner again from the triangle it was cut from.
    elements = np.repeat(np.arange(surface.n_triangles), 3 * segments**2)
    points = fine.triangles.ravel()
    target = chart_points(surface, fine.elements, fine.barycentric)[points]
    start = surface.chart[surface.triangles[elements]]
    gradients = surface.chart_gradients[elements]
    barycentric = np.einsum("pkc,pkc->pk", gradients, target[:, None] - np.roll(start, -1, axis=1))
    again = sample_operators(assembler, elements, barycentric)
    for first, second in ((own.value, again.value), (own.d_u, again.d_u), (own.d_v, again.d_v)):
        scale = np.abs(first @ field).max()
        assert np.abs((first @ field)[points] - second @ field).max() < 1e-9 * scale


def test_no_segments_are_refused() -> None:
    with pytest.raises(FemError, match="0 segments"):
        subdivide(plate(1).triangles, 0)
