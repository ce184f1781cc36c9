"""Rates of convergence, fitted over three meshes, and the clamped plate."""

import numpy as np
import pytest

from fem import (
    HCT9,
    HCT12,
    Assembler,
    ChartedSurface,
    Element,
    Material,
    Support,
    SurfaceSystem,
    element_tensors,
    load_operator,
    load_points,
    point_loads,
    shape_functions,
    uniform_material,
)
from fem.types import FloatArray
from tests.fem.meshes import boundary_supports, plate

ANGLE = 0.4
STRETCHING = np.array([3.0, 0.5])
BENDING = np.array([2.0, 0.3, 0.8])
WAVES = np.array([[2.0, 1.5], [-1.0, 3.0]])
PHASES = np.array([0.3, 1.1])
AXES = np.array([[np.cos(ANGLE), np.sin(ANGLE)], [-np.sin(ANGLE), np.cos(ANGLE)]])


def waves(points: FloatArray, derivative: int) -> FloatArray:
    """Derivative of sin(k . x + phase) by its argument, for both waves in the last axis."""
    return np.asarray(np.sin(points @ WAVES.T + PHASES + 0.5 * np.pi * derivative))


def manufactured_load(points: FloatArray) -> FloatArray:
    """Load that balances w = sum of sin(k . x + phase).

    The variation of the energy gives f = -(a1 D1^2 + a2 D2^2) w + (b11 D1^4 + b22 D2^4 + 2 b12 D1^2 D2^2) w with D1, D2
    the derivatives along and across the material direction; on a wave each D turns into i (k . axis).
    """
    squares = (WAVES @ AXES.T) ** 2
    symbol = squares @ STRETCHING + squares**2 @ BENDING[:2] + 2.0 * BENDING[2] * squares[:, 0] * squares[:, 1]
    return waves(points, 0) @ symbol


def exact_dofs(assembler: Assembler) -> FloatArray:
    surface = assembler.surface
    slopes = waves(surface.chart, 1) @ WAVES
    corners = np.column_stack([waves(surface.chart, 0).sum(axis=1), slopes]).ravel()
    if not assembler.element.dofs_per_edge:
        return corners
    middle = surface.chart[surface.edges].mean(axis=1)
    across = ((waves(middle, 1) @ WAVES) * surface.edge_normals).sum(axis=1)
    return np.concatenate([corners, across])


def energy_error(assembler: Assembler, coefficients: FloatArray) -> float:
    """Energy norm of the error, integrated to degree 9 with the chart's own derivatives."""
    surface = assembler.surface
    quadrature = assembler.quadrature(9)
    points = quadrature.positions[..., :2].reshape(-1, 2)
    per_triangle = len(quadrature.weights)
    elements = np.repeat(np.arange(surface.n_triangles), per_triangle)
    barycentric = np.tile(quadrature.barycentric, (surface.n_triangles, 1))
    shapes = shape_functions(surface, assembler.coefficients, elements, barycentric)
    own = coefficients[assembler.dofs.element_dofs[elements]]
    slope = np.einsum("pdn,pn->pd", shapes.gradients, own) - waves(points, 1) @ WAVES
    found = np.einsum("pdn,pn->pd", shapes.hessians, own)
    exact = waves(points, 2) @ np.column_stack([WAVES**2, WAVES[:, 0] * WAVES[:, 1]])
    xx, yy, xy = (found - exact).T
    hessian = np.stack([np.stack([xx, xy], axis=-1), np.stack([xy, yy], axis=-1)], axis=-2)
    turned = AXES @ hessian @ AXES.T
    density = (slope @ AXES.T) ** 2 @ STRETCHING + BENDING[0] * turned[:, 0, 0] ** 2
    density += BENDING[1] * turned[:, 1, 1] ** 2 + 2.0 * BENDING[2] * turned[:, 0, 1] ** 2
    weights = (surface.areas[:, None] * quadrature.weights).ravel()
    return float(np.sqrt(weights @ density))


def solved_waves(surface: ChartedSurface, element: Element) -> tuple[Assembler, FloatArray]:
    assembler = Assembler(surface, element)
    count = surface.n_vertices
    material = Material(
        np.tile([*AXES[0], 0.0], (count, 1)), np.tile(STRETCHING, (count, 1)), np.tile(BENDING, (count, 1))
    )
    stiffness = assembler.assemble(element_tensors(surface, material)).matrix
    system = SurfaceSystem(assembler.dofs, stiffness, boundary_supports(surface, Support.CLAMPED))
    forces = manufactured_load(load_points(assembler)[..., :2])[..., None]
    loads = np.repeat(point_loads(assembler, forces), 3, axis=1)
    held = np.repeat(exact_dofs(assembler)[:, None], 3, axis=1)
    return assembler, system.solve(loads, held_values=held)[:, 0]


def fitted_rate(segments: list[int], errors: list[float]) -> float:
    return float(-np.polyfit(np.log(segments), np.log(errors), 1)[0])


@pytest.mark.parametrize(("element", "rate"), [(HCT12, 2.0), (HCT9, 1.0)], ids=["HCT-12", "HCT-9"])
def test_energy_error_falls_at_the_rate_of_the_element(element: Element, rate: float) -> None:
    segments = [6, 12, 24]
    errors = [energy_error(*solved_waves(plate(n), element)) for n in segments]
    assert fitted_rate(segments, errors) == pytest.approx(rate, abs=0.2)


def plate_centre(segments: int, element: Element) -> float:
    surface = plate(segments)
    assembler = Assembler(surface, element)
    material = uniform_material(surface.n_vertices, stretching=0.0, bending=1.0)
    stiffness = assembler.assemble(element_tensors(surface, material)).matrix
    system = SurfaceSystem(assembler.dofs, stiffness, boundary_supports(surface, Support.CLAMPED))
    found = system.solve(load_operator(assembler) @ np.ones((surface.n_vertices, 3)))
    centre = np.flatnonzero(np.all(surface.chart == 0.5, axis=1))[0]
    assert found[3 * centre] == pytest.approx(np.repeat(found[3 * centre, 0], 3))
    return float(found[3 * centre, 0])


# Centre of the clamped unit square under unit load with D = 1 (Timoshenko and Woinowsky-Krieger, section 44, to the
# digits of Taylor and Govindjee 2004).
CLAMPED_CENTRE = 0.00126531908


@pytest.mark.parametrize(
    ("element", "bound", "rate"), [(HCT12, 0.0003, 4.0), (HCT9, 0.013, 2.0)], ids=["HCT-12", "HCT-9"]
)
def test_clamped_plate(element: Element, bound: float, rate: float) -> None:
    segments = [8, 16, 32]
    errors = [abs(plate_centre(n, element) / CLAMPED_CENTRE - 1.0) for n in segments]
    assert errors[1] < bound
    assert fitted_rate(segments, errors) == pytest.approx(rate, abs=0.3)
