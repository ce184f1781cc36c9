"""HCT-12 and HCT-9 by their definitions: nodality, derivatives, continuity, polynomials."""

import numpy as np
import pytest

from fem import HCT9, HCT12, Assembler, ChartedSurface, Element, shape_functions
from fem.types import FloatArray, IntArray
from tests.fem.meshes import chart_points, irregular, points_inside
from tests.fem.polynomials import interpolant, of_degree

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)
CORNERS = np.eye(3)
MIDDLES = 0.5 * (1.0 - np.eye(3))


@BOTH
def test_vertex_degrees_of_freedom_are_value_and_slopes(element: Element) -> None:
    surface = irregular()
    coefficients = element.coefficients(surface)
    everything = np.arange(surface.n_triangles)
    for corner in range(3):
        shapes = shape_functions(surface, coefficients, everything, np.tile(CORNERS[corner], (len(everything), 1)))
        found = np.concatenate([shapes.values[:, None], shapes.gradients], axis=1)
        expected = np.eye(found.shape[2])[3 * corner : 3 * corner + 3]
        assert found == pytest.approx(np.broadcast_to(expected, found.shape), abs=1e-11)


def _middle_slopes(surface: ChartedSurface, element: Element, edge: int) -> FloatArray:
    everything = np.arange(surface.n_triangles)
    middle = np.tile(MIDDLES[edge], (len(everything), 1))
    shapes = shape_functions(surface, element.coefficients(surface), everything, middle)
    normals = surface.edge_normals[surface.triangle_edges[:, edge]]
    return np.einsum("tdn,td->tn", shapes.gradients, normals)


def test_edge_degrees_of_freedom_are_normal_slopes() -> None:
    surface = irregular()
    for edge in range(3):
        found = _middle_slopes(surface, HCT12, edge)
        assert found == pytest.approx(np.broadcast_to(np.eye(12)[9 + edge], found.shape), abs=1e-11)


def test_reduced_normal_slope_is_the_mean_of_its_ends() -> None:
    surface = irregular()
    normals = surface.edge_normals[surface.triangle_edges]
    for edge in range(3):
        expected = np.zeros((surface.n_triangles, 9))
        for corner in ((edge + 1) % 3, (edge + 2) % 3):
            expected[:, 3 * corner + 1 : 3 * corner + 3] = 0.5 * normals[:, edge]
        assert _middle_slopes(surface, HCT9, edge) == pytest.approx(expected, abs=1e-11)


@BOTH
def test_values_of_the_corners_sum_to_one(element: Element) -> None:
    surface = irregular()
    shapes = shape_functions(surface, element.coefficients(surface), *points_inside(surface))
    assert shapes.values[:, [0, 3, 6]].sum(axis=1) == pytest.approx(1.0)


@BOTH
def test_derivatives_match_central_differences(element: Element) -> None:
    surface = irregular()
    coefficients = element.coefficients(surface)
    elements, barycentric = points_inside(surface)
    margins = np.sort(barycentric, axis=1)
    safe = (margins[:, 0] > 0.02) & (margins[:, 1] - margins[:, 0] > 0.02)
    elements, barycentric = elements[safe], barycentric[safe]
    assert len(elements) > 100
    shapes = shape_functions(surface, coefficients, elements, barycentric)
    step = 1e-5
    for axis in range(2):
        moved = [barycentric + sign * step * surface.chart_gradients[elements, :, axis] for sign in (1.0, -1.0)]
        ahead, behind = (shape_functions(surface, coefficients, elements, to) for to in moved)
        slope = (ahead.values - behind.values) / (2.0 * step)
        assert slope == pytest.approx(shapes.gradients[:, axis], abs=1e-5)
        curvature = (ahead.gradients - behind.gradients) / (2.0 * step)
        assert curvature[:, axis] == pytest.approx(shapes.hessians[:, axis], abs=1e-6)
        assert curvature[:, 1 - axis] == pytest.approx(shapes.hessians[:, 2], abs=1e-6)


def _random_field(assembler: Assembler) -> FloatArray:
    return np.random.default_rng(5).standard_normal(assembler.dofs.n_dofs)


def _field(
    assembler: Assembler,
    coefficients: FloatArray,
    elements: IntArray,
    barycentric: FloatArray,
    parts: IntArray | None = None,
) -> tuple[FloatArray, FloatArray]:
    shapes = shape_functions(assembler.surface, assembler.coefficients, elements, barycentric, parts)
    own = coefficients[assembler.dofs.element_dofs[elements]]
    return np.einsum("pn,pn->p", shapes.values, own), np.einsum("pdn,pn->pd", shapes.gradients, own)


@BOTH
def test_value_and_slope_are_continuous_across_every_edge(element: Element) -> None:
    surface = irregular()
    assembler = Assembler(surface, element)
    field = _random_field(assembler)
    users: list[list[tuple[int, int]]] = [[] for _ in surface.edges]
    for triangle, edges in enumerate(surface.triangle_edges):
        for edge, number in enumerate(edges):
            users[number].append((triangle, edge))
    shared = np.array([pair for pair in users if len(pair) == 2])
    assert len(shared) == len(surface.edges) - len(surface.boundary_edges)
    for share in (0.0, 0.13, 0.5, 0.71, 1.0):
        sides = []
        for side in range(2):
            triangles, edges = shared[:, side].T
            lower = surface.edges[surface.triangle_edges[triangles, edges], 0]
            barycentric = np.full((len(triangles), 3), 1.0 - share)
            barycentric[surface.triangles[triangles] == lower[:, None]] = share
            barycentric[np.arange(len(triangles)), edges] = 0.0
            sides.append(_field(assembler, field, triangles, barycentric))
        size = np.abs(field).max()
        assert np.abs(sides[0][0] - sides[1][0]).max() < 1e-10 * size
        assert np.abs(sides[0][1] - sides[1][1]).max() < 1e-10 * size * _steepness(assembler)


@BOTH
def test_value_and_slope_are_continuous_between_the_parts(element: Element) -> None:
    surface = irregular()
    assembler = Assembler(surface, element)
    field = _random_field(assembler)
    everything = np.arange(surface.n_triangles)
    for corner in range(3):
        for share in (0.0, 0.2, 0.6, 1.0):
            point = share * CORNERS[corner] + (1.0 - share) / 3.0
            barycentric = np.tile(point, (len(everything), 1))
            sides = [
                _field(assembler, field, everything, barycentric, np.full(len(everything), (corner + step) % 3))
                for step in (1, 2)
            ]
            assert np.abs(sides[0][0] - sides[1][0]).max() < 1e-10
            assert np.abs(sides[0][1] - sides[1][1]).max() < 1e-10 * _steepness(assembler)


def _steepness(assembler: Assembler) -> float:
    """Slopes of a field of size one reach the inverse of the smallest height of a triangle."""
    return float(np.linalg.norm(assembler.surface.chart_gradients, axis=2).max())


@pytest.mark.parametrize(("element", "degree"), [(HCT12, 3), (HCT9, 2)], ids=["HCT-12", "HCT-9"])
def test_polynomials_are_reproduced_with_their_derivatives(element: Element, degree: int) -> None:
    surface = irregular()
    assembler = Assembler(surface, element)
    field = of_degree(degree)
    elements, barycentric = points_inside(surface)
    points = chart_points(surface, elements, barycentric)
    shapes = shape_functions(surface, assembler.coefficients, elements, barycentric)
    own = interpolant(assembler, field)[assembler.dofs.element_dofs[elements]]
    assert np.einsum("pn,pn->p", shapes.values, own) == pytest.approx(field(points), rel=1e-10)
    for row, orders in enumerate([(1, 0), (0, 1)]):
        exact = field.derivative(*orders)(points)
        assert np.einsum("pn,pn->p", shapes.gradients[:, row], own) == pytest.approx(exact, abs=1e-10)
    for row, orders in enumerate([(2, 0), (0, 2), (1, 1)]):
        exact = field.derivative(*orders)(points)
        assert np.einsum("pn,pn->p", shapes.hessians[:, row], own) == pytest.approx(exact, abs=1e-9)


def test_the_reduced_element_does_not_hold_all_cubics() -> None:
    surface = irregular()
    assembler = Assembler(surface, HCT9)
    field = of_degree(3)
    elements, barycentric = points_inside(surface)
    shapes = shape_functions(surface, assembler.coefficients, elements, barycentric)
    own = interpolant(assembler, field)[assembler.dofs.element_dofs[elements]]
    error = np.einsum("pn,pn->p", shapes.values, own) - field(chart_points(surface, elements, barycentric))
    assert np.abs(error).max() > 1e-5


@BOTH
def test_second_derivatives_agree_at_the_barycentre_and_jump_beside_it(element: Element) -> None:
    # The split is smoother than asked for at its inner vertex (Farin's supersmoothness).
    surface = irregular()
    coefficients = element.coefficients(surface)
    everything = np.arange(surface.n_triangles)

    def jump(share: float) -> FloatArray:
        point = share * CORNERS[0] + (1.0 - share) / 3.0
        barycentric = np.tile(point, (len(everything), 1))
        parts = [np.full(len(everything), part) for part in (1, 2)]
        sides = [shape_functions(surface, coefficients, everything, barycentric, part).hessians for part in parts]
        return np.abs(sides[0] - sides[1]).max(axis=(1, 2)) / np.abs(sides[0]).max(axis=(1, 2))

    assert jump(0.0).max() < 1e-10
    assert jump(0.5).min() > 1e-3
