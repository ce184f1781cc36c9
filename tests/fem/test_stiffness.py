"""The scalar stiffness matrix: symmetry, definiteness, independence of frame, chart and order of work."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from fem import (
    HCT9,
    HCT12,
    Assembler,
    ChartedSurface,
    Element,
    FemError,
    Material,
    Support,
    SurfaceSystem,
    element_tensors,
    load_operator,
    smooth_assembler,
    uniform_material,
)
from fem.types import FloatArray
from tests.fem.meshes import bent_chart, boundary_supports, domed, irregular, plate

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)


def varied_material(surface: ChartedSurface, seed: int = 3) -> Material:
    rng = np.random.default_rng(seed)
    count = surface.n_vertices
    return Material(
        rng.standard_normal((count, 3)), rng.uniform(0.1, 2.0, (count, 2)), rng.uniform(0.1, 2.0, (count, 3))
    )


@BOTH
def test_symmetric_and_positive_semidefinite_with_only_constants_free(element: Element) -> None:
    surface = domed(irregular(30))
    assembler = smooth_assembler(surface, element)
    matrix = assembler.assemble(element_tensors(surface, varied_material(surface))).matrix.toarray()
    assert np.array_equal(matrix, matrix.T)
    scale = 1.0 / np.sqrt(np.diag(matrix))
    eigenvalues = np.linalg.eigvalsh(matrix * scale[:, None] * scale)
    assert eigenvalues[0] > -1e-12
    assert eigenvalues[1] > 1e-6
    constant = np.zeros(assembler.dofs.n_dofs)
    constant[assembler.dofs.value_dofs] = 1.0
    assert np.abs(matrix @ constant).max() < 1e-12 * np.abs(matrix).max()


@BOTH
def test_positive_definite_once_held(element: Element) -> None:
    surface = irregular(30)
    assembler = Assembler(surface, element)
    matrix = assembler.assemble(element_tensors(surface, varied_material(surface))).matrix.toarray()
    free = ~boundary_supports(surface, Support.CLAMPED).held_dofs(assembler.dofs)
    held = matrix[np.ix_(free, free)]
    scale = 1.0 / np.sqrt(np.diag(held))
    assert np.linalg.eigvalsh(held * scale[:, None] * scale)[0] > 1e-4


@BOTH
def test_energy_of_a_quadratic_by_hand(element: Element) -> None:
    surface = plate(3)
    assembler = Assembler(surface, element)
    count = surface.n_vertices
    material = Material(
        np.tile([0.0, 1.0, 0.0], (count, 1)), np.tile([3.0, 5.0], (count, 1)), np.tile([7.0, 11.0, 13.0], (count, 1))
    )
    matrix = assembler.assemble(element_tensors(surface, material)).matrix
    x, y = surface.chart.T
    field = np.zeros(assembler.dofs.n_dofs)
    # w = x^2 + 2 x y: w_x = 2 x + 2 y, w_y = 2 x, w_xx = 2, w_xy = 2, w_yy = 0; the direction is y.
    field[: 3 * count] = np.column_stack([x**2 + 2.0 * x * y, 2.0 * x + 2.0 * y, 2.0 * x]).ravel()
    if element.dofs_per_edge:
        x, y = surface.chart[surface.edges].mean(axis=1).T
        slopes = np.column_stack([2.0 * x + 2.0 * y, 2.0 * x])
        field[3 * count :] = (slopes * surface.edge_normals).sum(axis=1)
    stretching = 3.0 * 4.0 / 3.0 + 5.0 * (4.0 / 3.0 + 8.0 / 4.0 + 4.0 / 3.0)
    bending = 11.0 * 2.0**2 + 2.0 * 13.0 * 2.0**2
    assert field @ (matrix @ field) == pytest.approx(stretching + bending, rel=1e-12)


@BOTH
def test_turning_the_direction_and_swapping_the_principal_values_changes_nothing(element: Element) -> None:
    surface = irregular(30)
    rng = np.random.default_rng(4)
    count = surface.n_vertices
    angle = rng.uniform(0.0, 2.0 * np.pi, count)
    direction = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(count)])
    turned = np.column_stack([-np.sin(angle), np.cos(angle), np.zeros(count)])
    stretching, bending = rng.uniform(0.1, 2.0, (count, 2)), rng.uniform(0.1, 2.0, (count, 3))
    assembler = Assembler(surface, element)
    first = assembler.assemble(element_tensors(surface, Material(direction, stretching, bending)))
    swapped = Material(turned, stretching[:, ::-1], bending[:, [1, 0, 2]])
    second = assembler.assemble(element_tensors(surface, swapped))
    assert np.abs((first.matrix - second.matrix).data).max(initial=0.0) < 1e-12 * np.abs(first.matrix.data).max()


@BOTH
def test_reassembly_of_touched_triangles_equals_assembly(element: Element) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    before, after = varied_material(surface), varied_material(surface, seed=9)
    brushed = np.arange(surface.n_vertices) < 10
    mixed = Material(
        *(
            np.where(brushed[:, None], getattr(after, name), getattr(before, name))
            for name in ("direction", "stretching", "bending")
        )
    )
    touched = np.flatnonzero(brushed[surface.triangles].any(axis=1))
    assert 0 < len(touched) < surface.n_triangles
    tensors = element_tensors(surface, mixed)
    old = assembler.assemble(element_tensors(surface, before))
    again = assembler.reassemble(old, tensors, touched)
    fresh = assembler.assemble(tensors)
    assert np.array_equal(again.matrix.data, fresh.matrix.data)
    assert not np.array_equal(old.matrix.data, fresh.matrix.data)


def test_tensors_of_another_surface_are_refused() -> None:
    small, large = plate(2), plate(3)
    tensors = element_tensors(small, uniform_material(small.n_vertices, 1.0, 1.0))
    with pytest.raises(FemError, match="tensors for 8 triangles, the surface has 18"):
        Assembler(large, HCT9).assemble(tensors)


def solved_values(surface: ChartedSurface, element: Element, material: Material) -> FloatArray:
    """Displacement of the vertices of the clamped surface under three loads that know only vertex numbers."""
    assembler = smooth_assembler(surface, element)
    stiffness = assembler.assemble(element_tensors(surface, material)).matrix
    system = SurfaceSystem(assembler.dofs, stiffness, boundary_supports(surface, Support.CLAMPED))
    load = np.random.default_rng(2).standard_normal((surface.n_vertices, 3))
    return system.solve(load_operator(assembler) @ load)[assembler.dofs.value_dofs]


@BOTH
def test_a_rigid_motion_of_the_surface_leaves_each_coordinate_unchanged(element: Element) -> None:
    surface = domed(irregular())
    material = varied_material(surface)
    motion = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix().T
    moved = ChartedSurface(surface.positions @ motion + np.array([5.0, -3.0, 2.0]), surface.triangles, surface.chart)
    turned = Material(material.direction @ motion, material.stretching, material.bending)
    assert solved_values(moved, element, turned) == pytest.approx(solved_values(surface, element, material), rel=1e-8)


@BOTH
def test_a_scaled_and_sheared_chart_gives_the_same_matrix(element: Element) -> None:
    # The normal slope of HCT-9 is linear in the chart, so only a similarity leaves it unchanged.
    shear = np.array([[2.0, 0.3], [0.0, 0.7]]) if element is HCT12 else 2.5 * np.array([[0.8, 0.6], [-0.6, 0.8]])
    surface = domed(irregular())
    sheared = ChartedSurface(surface.positions, surface.triangles, surface.chart @ shear)
    material = varied_material(surface)
    first, second = solved_values(surface, element, material), solved_values(sheared, element, material)
    assert second == pytest.approx(first, rel=1e-7, abs=1e-9 * np.abs(first).max())


def chart_difference(segments: int, element: Element, *, curved: bool) -> float:
    surface = domed(plate(segments)) if curved else plate(segments)
    other = ChartedSurface(surface.positions, surface.triangles, bent_chart(surface.chart))
    first, second = (smooth_values(each, element) for each in (surface, other))
    return float(np.linalg.norm(first - second) / np.linalg.norm(first))


def smooth_values(surface: ChartedSurface, element: Element) -> FloatArray:
    assembler = smooth_assembler(surface, element)
    material = uniform_material(surface.n_vertices, stretching=1.0, bending=1.0)
    stiffness = assembler.assemble(element_tensors(surface, material)).matrix
    system = SurfaceSystem(assembler.dofs, stiffness, boundary_supports(surface, Support.VALUE))
    x, y = surface.positions[:, :2].T
    load = np.column_stack([np.ones_like(x), x, np.sin(3.0 * x) * y])
    return system.solve(load_operator(assembler) @ load)[assembler.dofs.value_dofs]


@BOTH
@pytest.mark.parametrize("curved", [False, True], ids=["flat", "curved"])
def test_two_charts_of_one_surface_converge_to_each_other(element: Element, curved: bool) -> None:
    segments = [6, 12, 24]
    differences = [chart_difference(n, element, curved=curved) for n in segments]
    assert differences[2] < 0.001
    assert -np.polyfit(np.log(segments), np.log(differences), 1)[0] > 1.6


def test_a_flat_surface_is_straight_in_any_chart() -> None:
    # Second derivatives of the world coordinates vanish on a plane, however its chart bends.
    surface = plate(16)
    bent = ChartedSurface(surface.positions, surface.triangles, bent_chart(surface.chart))
    bending = element_tensors(bent, uniform_material(bent.n_vertices, stretching=0.0, bending=1.0))
    smooth = smooth_assembler(bent, HCT12)
    flat = Assembler(bent, HCT12)
    field = smooth.smooth_positions
    assert field is not None
    energies = [np.einsum("nc,nc->", field, (each.assemble(bending).matrix @ field)) for each in (smooth, flat)]
    assert energies[0] < 1e-3 * energies[1]
