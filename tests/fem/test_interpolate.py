"""The smooth surface through given vertices."""

import numpy as np
import pytest

from fem import (
    HCT9,
    HCT12,
    Assembler,
    ChartedSurface,
    Element,
    FemError,
    element_tensors,
    interpolate_smoothly,
    sample_operators,
    smooth_assembler,
    subdivide,
    uniform_material,
)
from tests.fem.meshes import domed, irregular, plate

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)


@BOTH
def test_values_are_met_and_a_plane_stays_one(element: Element) -> None:
    surface = irregular()
    assembler = Assembler(surface, element)
    plane = surface.chart @ np.array([[1.0, -2.0], [0.5, 3.0]]) + [0.3, 1.0]
    found = interpolate_smoothly(assembler, plane)
    assert np.array_equal(found[assembler.dofs.value_dofs], plane)
    assert found[assembler.dofs.value_dofs + 1] == pytest.approx(np.tile([1.0, -2.0], (len(plane), 1)), abs=1e-10)
    assert found[assembler.dofs.value_dofs + 2] == pytest.approx(np.tile([0.5, 3.0], (len(plane), 1)), abs=1e-10)


@BOTH
def test_no_other_slopes_bend_less(element: Element) -> None:
    surface = domed(irregular())
    assembler = Assembler(surface, element)
    found = interpolate_smoothly(assembler, surface.positions)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 0.0, 1.0))
    matrix = assembler.assemble(tensors).matrix
    force = matrix @ found
    force[assembler.dofs.value_dofs] = 0.0
    assert np.abs(force).max() < 1e-9 * np.abs(matrix).max()


def sphere_patch(segments: int) -> ChartedSurface:
    chart = plate(segments).chart - 0.5
    height = np.sqrt(1.0 - (chart**2).sum(axis=1))
    return ChartedSurface(np.column_stack([chart, height]), plate(segments).triangles, chart)


@BOTH
def test_normals_approach_those_of_a_sphere(element: Element) -> None:
    errors = []
    for segments in (4, 8, 16):
        surface = sphere_patch(segments)
        assembler = smooth_assembler(surface, element)
        fine = subdivide(surface.triangles, 3)
        operators = sample_operators(assembler, fine.elements, fine.barycentric)
        smooth = assembler.smooth_positions
        assert smooth is not None
        points = operators.value @ smooth
        normals = np.cross(operators.d_u @ smooth, operators.d_v @ smooth)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        inside = np.abs(points[:, :2]).max(axis=1) < 0.3
        assert np.linalg.norm(points[inside], axis=1) == pytest.approx(1.0, abs=0.02 / segments)
        errors.append(np.abs(normals - points)[inside].max())
    assert errors[2] < errors[1] < errors[0]
    assert errors[2] < 0.003


def test_stretching_calms_the_overshoot_beside_a_step() -> None:
    surface = plate(12)
    assembler = Assembler(surface, HCT12)
    step = (surface.chart[:, :1] > 0.5).astype(np.float64)
    fine = subdivide(surface.triangles, 4)
    value = sample_operators(assembler, fine.elements, fine.barycentric).value
    overshoot = [(value @ interpolate_smoothly(assembler, step, weight)).max() - 1.0 for weight in (0.0, 1e4)]
    assert overshoot[0] > 0.1
    assert overshoot[1] < 0.8 * overshoot[0]


def test_values_that_do_not_fit_are_refused() -> None:
    assembler = Assembler(plate(2), HCT9)
    with pytest.raises(FemError, match=r"\(9, k\) finite values"):
        interpolate_smoothly(assembler, np.zeros((8, 3)))
    with pytest.raises(FemError, match="finite"):
        interpolate_smoothly(assembler, np.full((9, 3), np.nan))
    with pytest.raises(FemError, match=r"must be \(27, 3\) coefficients"):
        assembler.on_smooth_surface(np.zeros((9, 3)))
