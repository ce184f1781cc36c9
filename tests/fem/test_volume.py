"""The layer that keeps its volume, against closed forms: what it costs, how it bulges, what it lets pass."""

import numpy as np
import pytest

from fem import (
    HCT9,
    HCT12,
    Assembler,
    ChartedSurface,
    Element,
    FemError,
    Support,
    Supports,
    SurfaceSystem,
    VolumeLayer,
    element_tensors,
    interpolate_smoothly,
    smooth_assembler,
    uniform_material,
)
from fem.types import FloatArray
from tests.fem.meshes import domed, irregular, plate

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)
KAPPA, THICKNESS = 3.0, 0.4


def layer(surface: ChartedSurface, kappa: float = KAPPA, thickness: float = THICKNESS) -> VolumeLayer:
    count = surface.n_vertices
    return VolumeLayer(np.full(count, kappa), np.full(count, thickness))


def coefficients(assembler: Assembler, displacement: FloatArray) -> FloatArray:
    """Unknowns (3 n_dofs,) of a displacement that is linear over a flat surface."""
    return np.asarray(interpolate_smoothly(assembler, displacement)).ravel()


def energy(assembler: Assembler, displacement: FloatArray, under: VolumeLayer) -> float:
    unknowns = coefficients(assembler, displacement)
    return float(unknowns @ (under.coupling(assembler) @ unknowns))


@BOTH
def test_what_is_stretched_and_sinks_as_much_as_it_thins_costs_nothing(element: Element) -> None:
    surface = irregular()
    x, y = surface.chart.T
    sinking = np.stack([0.1 * x, 0.06 * y, np.full(len(x), -THICKNESS / 2 * 0.16)], axis=1)
    assembler = Assembler(surface, element)
    assert energy(assembler, sinking, layer(surface)) == pytest.approx(0.0, abs=1e-12)


@BOTH
def test_a_stretch_costs_the_square_of_the_volume_it_adds(element: Element) -> None:
    surface = irregular()
    x, y = surface.chart.T
    stretched = np.stack([0.1 * x, 0.06 * y, np.zeros(len(x))], axis=1)
    cost = KAPPA * (THICKNESS / 2 * 0.16) ** 2 * surface.areas.sum()
    assert energy(Assembler(surface, element), stretched, layer(surface)) == pytest.approx(cost, rel=1e-9)


@BOTH
def test_a_shear_and_a_shift_along_the_surface_are_free(element: Element) -> None:
    surface = irregular()
    x, y = surface.chart.T
    sheared = np.stack([0.3 + 0.2 * y, 0.1 * x - 0.5, np.zeros(len(x))], axis=1)
    assert energy(Assembler(surface, element), sheared, layer(surface)) == pytest.approx(0.0, abs=1e-12)


def cap(segments: int, radius: float) -> ChartedSurface:
    """A part of a sphere over the unit square."""
    flat = plate(segments)
    x, y = (flat.chart - 0.5).T
    positions = np.stack([x, y, np.sqrt(radius**2 - x**2 - y**2)], axis=1)
    return ChartedSurface(positions, flat.triangles, flat.chart)


@BOTH
def test_a_sphere_that_grows_gains_volume_by_its_curvature_as_well(element: Element) -> None:
    radius, grown = 2.0, 0.01
    surface = cap(10, radius)
    assembler = smooth_assembler(surface, element)
    outward = grown * surface.positions / radius
    change = grown * (1 + THICKNESS / 2 * 2 / radius)
    cost = KAPPA * change**2 * surface.areas.sum()
    assert energy(assembler, outward, layer(surface)) == pytest.approx(cost, rel=0.02)


def squeezed(element: Element, kappa: float) -> tuple[Assembler, FloatArray]:
    """A plate held at its left side and pushed together from the right: its displacement at the vertices."""
    surface = plate(14)
    assembler = Assembler(surface, element)
    x = surface.chart[:, 0]
    kinds = np.where(x == 0.0, Support.VALUE, Support.FREE)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, bending=1e-4))
    coupling = layer(surface, kappa).coupling(assembler) if kappa else None
    system = SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, Supports(kinds), coupling)
    loads = np.zeros((assembler.dofs.n_dofs, 3))
    loads[assembler.dofs.value_dofs[x == 1.0], 0] = -0.005
    return assembler, np.asarray(system.solve(loads))


def gained(assembler: Assembler, solution: FloatArray) -> tuple[float, float]:
    """What a flat surface rose by as a volume, and what went out over its border."""
    surface = assembler.surface
    moved = solution[assembler.dofs.value_dofs]
    lifted = float((surface.areas * moved[surface.triangles, 2].mean(axis=1)).sum())
    middle = surface.positions.mean(axis=0)
    border = surface.edges[surface.boundary_edges]
    step = surface.positions[border[:, 1]] - surface.positions[border[:, 0]]
    outward = np.stack([step[:, 1], -step[:, 0]], axis=1)
    outward *= np.sign((outward * (surface.positions[border].mean(axis=1) - middle)[:, :2]).sum(axis=1))[:, None]
    return lifted, float(THICKNESS / 2 * (moved[border, :2].mean(axis=1) * outward).sum())


@BOTH
def test_a_plate_that_is_pushed_together_bulges_by_what_it_loses(element: Element) -> None:
    lifted, lost = gained(*squeezed(element, 500.0))
    assert lost < -1e-3
    # The border is added up along straight lines between its vertices.
    assert lifted == pytest.approx(-lost, rel=0.03)


@BOTH
def test_without_a_layer_nothing_bulges(element: Element) -> None:
    assert abs(gained(*squeezed(element, 0.0))[0]) < 1e-12


@BOTH
def test_volume_put_under_the_surface_lifts_it(element: Element) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    under = layer(surface)
    moved = np.tile([0.2, -0.1, 0.4], (surface.n_vertices, 1))
    unknowns = coefficients(assembler, moved)
    # A shift changes the volume by its normal part alone, which the normals at the vertices interpolate.
    normals = np.zeros((surface.n_vertices, 3))
    for corner in range(3):
        np.add.at(normals, surface.triangles[:, corner], surface.normals * surface.areas[:, None])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    wanted = under.coupling(assembler) @ unknowns
    given = under.load_operator(assembler) @ (normals * moved).sum(axis=1)
    assert np.linalg.norm(given - wanted) < 0.05 * np.linalg.norm(wanted)


@BOTH
def test_there_is_no_layer_where_its_stiffness_is_zero(element: Element) -> None:
    surface = irregular()
    stiffness = np.where(surface.chart[:, 0] > 0.0, KAPPA, 0.0)
    assembler = Assembler(surface, element)
    coupling = VolumeLayer(stiffness, np.full(surface.n_vertices, THICKNESS)).coupling(assembler)
    near = np.unique(surface.triangles[(stiffness[surface.triangles] > 0.0).any(axis=1)])
    touched = np.unique(assembler.dofs.vertex_of(np.unique(coupling.tocoo().row[coupling.tocoo().data != 0.0]) // 3))
    assert set(touched[np.isin(touched, np.arange(surface.n_vertices))]) <= set(near)
    assert abs(coupling - coupling.T).max() < 1e-12


@pytest.mark.parametrize("values", [[1.0, -1.0], [1.0, np.nan]])
def test_a_layer_is_of_something(values: list[float]) -> None:
    with pytest.raises(FemError, match="vertex 1"):
        VolumeLayer(np.array(values), np.ones(2))
    with pytest.raises(FemError, match="vertex 1"):
        VolumeLayer(np.ones(2), np.array(values))


def test_a_layer_belongs_to_a_surface() -> None:
    assembler = Assembler(irregular(), HCT9)
    with pytest.raises(FemError, match="vertices"):
        VolumeLayer(np.ones(3), np.ones(3)).coupling(assembler)
