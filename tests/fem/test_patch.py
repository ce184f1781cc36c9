"""Patch tests: polynomials of the element come out of a solve with held boundary, whatever the mesh and tensors."""

import numpy as np
import pytest

from fem import (
    HCT9,
    HCT12,
    Assembler,
    Element,
    Material,
    Support,
    SurfaceSystem,
    element_tensors,
    load_operator,
    sample_operators,
)
from fem.types import FloatArray
from tests.fem.meshes import boundary_supports, irregular, points_inside
from tests.fem.polynomials import Polynomial, interpolant, of_degree

ANGLE = 0.6
STRETCHING = (2.0, 0.3)
BENDING = (1.5, 0.2, 0.7)


def constant_material(count: int) -> Material:
    direction = np.array([np.cos(ANGLE), np.sin(ANGLE), 0.0])
    return Material(np.tile(direction, (count, 1)), np.tile(STRETCHING, (count, 1)), np.tile(BENDING, (count, 1)))


def balancing_load(field: Polynomial, points: FloatArray) -> FloatArray:
    """Load under which a cubic is in equilibrium: -(a1 w_11 + a2 w_22); its fourth derivatives vanish."""
    c, s = np.cos(ANGLE), np.sin(ANGLE)
    xx, yy, xy = (field.derivative(*orders)(points) for orders in ((2, 0), (0, 2), (1, 1)))
    along = c * c * xx + s * s * yy + 2.0 * c * s * xy
    across = s * s * xx + c * c * yy - 2.0 * c * s * xy
    return -(STRETCHING[0] * along + STRETCHING[1] * across)


@pytest.mark.parametrize(("element", "degree"), [(HCT12, 3), (HCT9, 2)], ids=["HCT-12", "HCT-9"])
def test_polynomials_solve_the_plate(element: Element, degree: int) -> None:
    surface = irregular()
    assembler = Assembler(surface, element)
    fields = [of_degree(degree, seed) for seed in range(3)]
    stiffness = assembler.assemble(element_tensors(surface, constant_material(surface.n_vertices))).matrix
    system = SurfaceSystem(assembler.dofs, stiffness, boundary_supports(surface, Support.CLAMPED))
    exact = np.stack([interpolant(assembler, field) for field in fields], axis=1)
    load = np.stack([balancing_load(field, surface.chart) for field in fields], axis=1)
    found = system.solve(load_operator(assembler) @ load, held_values=exact)
    assert system.n_unknowns > 100
    assert np.abs(found - exact).max() < 1e-10 * np.abs(exact).max()
    points = sample_operators(assembler, *points_inside(surface))
    assert np.abs(points.value @ (found - exact)).max() < 1e-10 * np.abs(exact).max()
