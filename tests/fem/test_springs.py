"""Springs against closed forms: one spring, an elastic foundation, rigid motion of the anchors."""

import numpy as np
import pytest

from fem import (
    HCT9,
    HCT12,
    Assembler,
    Element,
    FemError,
    Foundation,
    PointSprings,
    SpringSet,
    Support,
    Supports,
    SurfaceSystem,
    element_tensors,
    load_operator,
    smooth_assembler,
    uniform_material,
)
from fem.types import FloatArray
from tests.fem.meshes import domed, irregular, plate

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)


def free_system(assembler: Assembler, coupling: object, stretching: float = 1.0) -> SurfaceSystem:
    surface = assembler.surface
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, stretching, bending=0.1))
    nowhere = Supports(np.full(surface.n_vertices, Support.FREE))
    return SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, nowhere, coupling)


def random_blocks(count: int, seed: int = 0) -> FloatArray:
    root = np.random.default_rng(seed).standard_normal((count, 3, 3))
    return root @ np.swapaxes(root, 1, 2) + 0.1 * np.eye(3)


@BOTH
def test_one_vertex_on_three_springs_moves_by_force_over_stiffness(element: Element) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    directions = np.array([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 1.0, 1.0]])
    springs = SpringSet(np.array([4, 4, 4]), directions, np.array([2.0, 3.0, 5.0]))
    block = np.diag([2.0, 3.0, 0.0]) + 2.5 * np.array([[0, 0, 0], [0, 1, 1], [0, 1, 1]])
    blocks = springs.blocks(surface.n_vertices)
    assert blocks[4] == pytest.approx(block)
    system = free_system(assembler, PointSprings(blocks).coupling(assembler))
    load = np.zeros((assembler.dofs.n_dofs, 3))
    force = np.array([1.0, -2.0, 0.5])
    load[assembler.dofs.value_dofs[11]] = force
    moved = system.solve(load)[assembler.dofs.value_dofs]
    # Nothing else holds the surface, so the force passes through it into the springs of vertex 4.
    assert moved[4] == pytest.approx(np.linalg.solve(block, force), rel=1e-7)


@BOTH
def test_a_foundation_under_uniform_pressure_gives_way_evenly(element: Element) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    block = random_blocks(1)[0]
    foundation = Foundation(np.tile(block, (surface.n_vertices, 1, 1)))
    system = free_system(assembler, foundation.coupling(assembler))
    pressure = np.array([0.3, -0.1, 0.8])
    found = system.solve(load_operator(assembler) @ np.tile(pressure, (surface.n_vertices, 1)))
    moved = found[assembler.dofs.value_dofs]
    assert moved == pytest.approx(np.tile(np.linalg.solve(block, pressure), (surface.n_vertices, 1)), rel=1e-8)
    assert np.abs(np.delete(found, assembler.dofs.value_dofs, axis=0)).max() < 1e-8


@BOTH
def test_a_membrane_on_a_foundation_under_a_wave(element: Element) -> None:
    # -a w'' + b w'''' + k w = q cos(m pi x) with free sides: w = q cos(m pi x) / (a (m pi)^2 + b (m pi)^4 + k), since
    # the cosine has neither slope nor shear at the sides. Its end moments do not vanish, so bending is left out.
    surface = plate(12)
    assembler = Assembler(surface, element)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, stretching=0.7, bending=0.0))
    stiffness = assembler.assemble(tensors).matrix
    nowhere = Supports(np.full(surface.n_vertices, Support.FREE))
    foundation = Foundation(np.tile(np.diag([1.0, 2.0, 3.0]), (surface.n_vertices, 1, 1)))
    system = SurfaceSystem(assembler.dofs, stiffness, nowhere, foundation.coupling(assembler))
    wave = np.cos(2.0 * np.pi * surface.chart[:, 0])
    found = system.solve(load_operator(assembler) @ np.repeat(wave[:, None], 3, axis=1))
    exact = wave[:, None] / (0.7 * (2.0 * np.pi) ** 2 + np.array([1.0, 2.0, 3.0]))
    assert found[assembler.dofs.value_dofs] == pytest.approx(exact, abs=0.03 * np.abs(exact).max())


def softened(segments: int, element: Element, *, spread: bool) -> float:
    """Displacement of the middle of a plate on springs, pressed in the middle third."""
    surface = plate(segments)
    assembler = Assembler(surface, element)
    blocks = np.tile(np.eye(3), (surface.n_vertices, 1, 1))
    layer = Foundation(blocks) if spread else PointSprings(blocks)
    system = free_system(assembler, layer.coupling(assembler))
    x, y = surface.chart.T
    pressure = np.exp(-20.0 * ((x - 0.5) ** 2 + (y - 0.5) ** 2))
    found = system.solve(load_operator(assembler) @ np.repeat(pressure[:, None], 3, axis=1))
    return float(found[3 * np.flatnonzero((x == 0.5) & (y == 0.5))[0], 0])


@BOTH
def test_only_a_foundation_is_independent_of_mesh_density(element: Element) -> None:
    assert softened(8, element, spread=True) == pytest.approx(softened(16, element, spread=True), rel=0.02)
    assert softened(8, element, spread=False) > 2.0 * softened(16, element, spread=False)


@BOTH
@pytest.mark.parametrize("layer_type", [PointSprings, Foundation])
def test_anchors_that_move_together_carry_the_surface(
    element: Element, layer_type: type[PointSprings] | type[Foundation]
) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    rng = np.random.default_rng(1)
    count = surface.n_vertices
    vertices = np.repeat(np.arange(count), 4)
    springs = SpringSet(vertices, rng.standard_normal((4 * count, 3)), rng.uniform(0.1, 2.0, 4 * count))
    layer = layer_type(springs.blocks(count))
    shift = np.array([1.0, -2.0, 0.5])
    forces = springs.anchor_forces(np.tile(shift, (4 * count, 1)), count)
    found = free_system(assembler, layer.coupling(assembler)).solve(layer.anchor_loads(assembler, forces))
    assert found[assembler.dofs.value_dofs] == pytest.approx(np.tile(shift, (count, 1)), rel=1e-7)


def test_a_moved_anchor_pulls_along_its_spring_only() -> None:
    springs = SpringSet(np.array([1]), np.array([[0.0, 3.0, 4.0]]), np.array([10.0]))
    forces = springs.anchor_forces(np.array([[7.0, 1.0, 2.0]]), 3)
    assert forces[1] == pytest.approx(10.0 * (0.6 + 1.6) * np.array([0.0, 0.6, 0.8]))
    assert not forces[[0, 2]].any()


@BOTH
def test_couplings_are_symmetric_and_definite_where_there_are_springs(element: Element) -> None:
    surface = irregular(20)
    assembler = Assembler(surface, element)
    matrix = Foundation(random_blocks(surface.n_vertices)).coupling(assembler).toarray()
    assert np.array_equal(matrix, matrix.T)
    scale = 1.0 / np.sqrt(np.diag(matrix))
    assert np.linalg.eigvalsh(matrix * scale[:, None] * scale)[0] > 0.0


def test_bad_springs_are_refused() -> None:
    assembler = Assembler(plate(1), HCT9)
    one = np.array([2])
    with pytest.raises(FemError, match="Spring 0 at vertex 2 has no direction"):
        SpringSet(one, np.zeros((1, 3)), np.ones(1))
    with pytest.raises(FemError, match=r"stiffness -1.0; it must be finite and not negative"):
        SpringSet(one, np.ones((1, 3)), -np.ones(1))
    blocks = np.tile(np.eye(3), (4, 1, 1))
    blocks[3, 0, 0] = -1.0
    with pytest.raises(FemError, match="spring block of vertex 3"):
        Foundation(blocks)
    with pytest.raises(FemError, match=r"\(N, 3, 3\)"):
        PointSprings(np.eye(3))
    with pytest.raises(FemError, match="springs for 5 vertices, the surface has 4"):
        Foundation(np.tile(np.eye(3), (5, 1, 1))).coupling(assembler)
