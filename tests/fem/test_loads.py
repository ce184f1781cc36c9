"""Consistent loads against integrals known in closed form."""

import numpy as np
import pytest
from numpy.polynomial import polynomial

from fem import (
    HCT9,
    HCT12,
    Assembler,
    Element,
    FemError,
    corner_load_operator,
    load_operator,
    load_points,
    point_loads,
)
from tests.fem.meshes import domed, irregular, plate
from tests.fem.polynomials import interpolant, of_degree

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)


@BOTH
def test_work_of_a_linear_load_on_a_polynomial(element: Element) -> None:
    assembler = Assembler(plate(4), element)
    field = of_degree(3 if element is HCT12 else 2)
    x, y = assembler.surface.chart.T
    work = interpolant(assembler, field) @ (load_operator(assembler) @ (1.0 + 2.0 * x - 3.0 * y))
    load = np.array([[1.0, -3.0], [2.0, 0.0]])
    size = len(field.coefficients)
    product = np.zeros((size + 1, size + 1))
    for (i, j), weight in np.ndenumerate(load):
        product[i : i + size, j : j + size] += weight * field.coefficients
    exact = polynomial.polyval2d(1.0, 1.0, polynomial.polyint(polynomial.polyint(product, axis=0), axis=1))
    assert work == pytest.approx(exact, rel=1e-12)


@BOTH
def test_total_force_is_pressure_times_true_area(element: Element) -> None:
    surface = domed(irregular())
    assembler = Assembler(surface, element)
    pressure = np.array([[1.0, -2.0, 0.5]])
    loads = load_operator(assembler) @ np.repeat(pressure, surface.n_vertices, axis=0)
    assert loads[assembler.dofs.value_dofs].sum(axis=0) == pytest.approx(surface.areas.sum() * pressure[0])


@BOTH
def test_all_three_ways_agree_on_a_linear_load(element: Element) -> None:
    surface = domed(irregular())
    assembler = Assembler(surface, element)
    at_vertices = surface.positions @ np.random.default_rng(0).standard_normal((3, 2)) + 1.0
    by_vertex = load_operator(assembler) @ at_vertices
    by_corner = corner_load_operator(assembler) @ at_vertices[surface.triangles].reshape(-1, 2)
    points = load_points(assembler)
    by_point = point_loads(assembler, points @ np.random.default_rng(0).standard_normal((3, 2)) + 1.0)
    assert by_corner == pytest.approx(by_vertex, abs=1e-13)
    assert by_point == pytest.approx(by_vertex, abs=1e-13)


def test_a_load_on_one_triangle_stays_on_its_degrees_of_freedom() -> None:
    surface = irregular()
    assembler = Assembler(surface, HCT12)
    corners = np.zeros((surface.n_triangles, 3))
    corners[5] = 1.0
    found = corner_load_operator(assembler) @ corners.ravel()
    assert set(np.flatnonzero(found)) == set(assembler.dofs.element_dofs[5])
    assert found[assembler.dofs.value_dofs].sum() == pytest.approx(surface.areas[5])


def test_point_loads_must_match_their_points() -> None:
    assembler = Assembler(plate(2), HCT9)
    with pytest.raises(FemError, match=r"\(8, 21\)"):
        point_loads(assembler, np.zeros((8, 20, 3)))
