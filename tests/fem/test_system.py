"""The solved system: superposition, one factorisation, cancelling, and what it says of loose surfaces."""

import numpy as np
import pytest
from scipy.sparse import eye_array, kron
from scipy.sparse.linalg import spsolve

from fem import (
    HCT9,
    HCT12,
    Assembler,
    ChartedSurface,
    Element,
    FemError,
    Foundation,
    PointSprings,
    SingularSystemError,
    Support,
    Supports,
    SurfaceSystem,
    element_tensors,
    load_operator,
    smooth_assembler,
    uniform_material,
)
from fem.types import FloatArray
from tests.fem.meshes import boundary_supports, domed, irregular, plate

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)
COUPLED = pytest.mark.parametrize("coupled", [False, True], ids=["apart", "coupled"])


def tissue(count: int) -> FloatArray:
    normal = np.random.default_rng(6).standard_normal((count, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return 0.5 * normal[:, :, None] * normal[:, None, :] + 0.05 * np.eye(3)


def held_face(element: Element, *, coupled: bool) -> tuple[Assembler, SurfaceSystem]:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 0.2))
    coupling = Foundation(tissue(surface.n_vertices)).coupling(assembler) if coupled else None
    stiffness = assembler.assemble(tensors).matrix
    return assembler, SurfaceSystem(assembler.dofs, stiffness, boundary_supports(surface, Support.CLAMPED), coupling)


def random_loads(assembler: Assembler, count: int) -> FloatArray:
    forces = np.random.default_rng(8).standard_normal((assembler.surface.n_vertices, 3 * count))
    return (load_operator(assembler) @ forces).reshape(-1, 3, count)


@BOTH
@COUPLED
def test_fields_superpose(element: Element, coupled: bool) -> None:
    assembler, system = held_face(element, coupled=coupled)
    loads = random_loads(assembler, 20)
    weights = np.random.default_rng(1).uniform(-1.0, 1.0, 20)
    fields = system.solve(loads)
    at_once = system.solve(loads @ weights)
    assert np.abs(fields @ weights - at_once).max() < 1e-12 * np.abs(at_once).max()


@BOTH
@COUPLED
def test_one_factorisation_serves_every_load(element: Element, coupled: bool) -> None:
    assembler, system = held_face(element, coupled=coupled)
    assert system.factorisations == 0
    for count in (1, 3, 17):
        system.solve(random_loads(assembler, count))
    assert (system.factorisations, system.loads_solved) == (1, 21)


@BOTH
def test_springs_that_do_not_mix_coordinates_change_nothing_between_the_two_ways(element: Element) -> None:
    assembler, alone = held_face(element, coupled=False)
    surface = assembler.surface
    nothing = PointSprings(np.zeros((surface.n_vertices, 3, 3))).coupling(assembler)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 0.2))
    supports = boundary_supports(surface, Support.CLAMPED)
    together = SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, supports, nothing)
    assert together.n_unknowns == 3 * alone.n_unknowns
    loads = random_loads(assembler, 2)
    expected = alone.solve(loads)
    assert together.solve(loads) == pytest.approx(expected, abs=1e-10 * np.abs(expected).max())


@BOTH
def test_solution_matches_an_independent_solver(element: Element) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 0.2))
    stiffness = assembler.assemble(tensors).matrix
    coupling = Foundation(tissue(surface.n_vertices)).coupling(assembler)
    system = SurfaceSystem(assembler.dofs, stiffness, Supports(np.zeros(surface.n_vertices, dtype=int)), coupling)
    loads = random_loads(assembler, 1)[..., 0]
    expected = spsolve((kron(stiffness, eye_array(3)) + coupling).tocsc(), loads.ravel()).reshape(-1, 3)
    assert system.solve(loads) == pytest.approx(expected, abs=1e-9 * np.abs(expected).max())


def test_a_fully_held_surface_takes_its_held_values() -> None:
    surface = plate(2)
    assembler = Assembler(surface, HCT12)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 1.0))
    everywhere = Supports(np.full(surface.n_vertices, Support.CLAMPED))
    system = SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, everywhere)
    wanted = np.random.default_rng(0).standard_normal((assembler.dofs.n_dofs, 3))
    assert np.array_equal(system.solve(np.zeros_like(wanted), held_values=wanted), wanted)


class StoppedError(Exception):
    pass


def test_progress_counts_loads_and_can_cancel() -> None:
    assembler, system = held_face(HCT9, coupled=True)
    loads = random_loads(assembler, 20)
    seen: list[tuple[int, int]] = []
    system.solve(loads, progress=lambda done, total: seen.append((done, total)))
    assert seen[0] == (0, 20)
    assert seen[-1] == (20, 20)
    assert len(seen) > 2
    assert [done for done, _ in seen] == sorted({done for done, _ in seen})

    def stop(done: int, total: int) -> None:
        if 0 < done < total:
            raise StoppedError

    with pytest.raises(StoppedError):
        system.solve(loads, progress=stop)
    assert np.isfinite(system.solve(loads)).all()


def plain_system(surface: ChartedSurface, supports: Supports, stretching: float, bending: float) -> SurfaceSystem:
    assembler = Assembler(surface, HCT12)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, stretching, bending))
    return SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, supports)


def two_plates() -> ChartedSurface:
    one = plate(2)
    chart = np.concatenate([one.chart, one.chart + np.array([2.0, 0.0])])
    triangles = np.concatenate([one.triangles, one.triangles + one.n_vertices])
    return ChartedSurface(np.pad(chart, ((0, 0), (0, 1))), triangles, chart)


def test_a_part_without_support_is_named() -> None:
    kinds = np.zeros(18, dtype=np.int64)
    kinds[:9] = Support.CLAMPED
    with pytest.raises(SingularSystemError, match="part of 9 vertices around vertex 9 has no support and no") as caught:
        plain_system(two_plates(), Supports(kinds), 1.0, 1.0)
    assert caught.value.vertices.tolist() == list(range(9, 18))


def test_springs_hold_a_part_too() -> None:
    surface = two_plates()
    assembler = Assembler(surface, HCT9)
    tensors = element_tensors(surface, uniform_material(18, 1.0, 1.0))
    kinds = np.zeros(18, dtype=np.int64)
    kinds[:9] = Support.CLAMPED
    blocks = np.zeros((18, 3, 3))
    blocks[12] = np.eye(3)
    coupling = PointSprings(blocks).coupling(assembler)
    system = SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, Supports(kinds), coupling)
    assert np.isfinite(system.solve(np.ones((assembler.dofs.n_dofs, 3)))).all()


@pytest.mark.parametrize("held", [1, 2])
def test_a_hinged_plate_is_loose_at_its_far_corner(held: int) -> None:
    # With bending alone one held value leaves two rotations, two held values along a side leave one.
    surface = plate(6)
    kinds = np.zeros(surface.n_vertices, dtype=np.int64)
    kinds[[0, 6][:held]] = Support.VALUE
    system = plain_system(surface, Supports(kinds), stretching=0.0, bending=1.0)
    with pytest.raises(SingularSystemError, match="loose around vertex") as caught:
        system.solve(np.ones((system.dofs.n_dofs, 3)))
    assert surface.chart[caught.value.vertices[0]].max() == 1.0
    assert 0 not in caught.value.vertices


def test_three_held_values_are_enough_for_a_plate() -> None:
    surface = plate(6)
    kinds = np.zeros(surface.n_vertices, dtype=np.int64)
    kinds[[0, 6, 42]] = Support.VALUE
    system = plain_system(surface, Supports(kinds), stretching=0.0, bending=1.0)
    assert np.isfinite(system.solve(np.ones((system.dofs.n_dofs, 3)))).all()


def test_springs_along_one_direction_only_leave_the_others_loose() -> None:
    surface = plate(4)
    assembler = Assembler(surface, HCT9)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 1.0))
    blocks = np.tile(np.diag([0.0, 0.0, 1.0]), (surface.n_vertices, 1, 1))
    nowhere = Supports(np.zeros(surface.n_vertices, dtype=np.int64))
    coupling = Foundation(blocks).coupling(assembler)
    system = SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, nowhere, coupling)
    with pytest.raises(SingularSystemError, match="loose around vertex"):
        system.factorise()
    assert system.factorisations == 0


def test_skin_without_any_stiffness_is_loose_where_it_has_none() -> None:
    surface = plate(6)
    assembler = Assembler(surface, HCT9)
    stiff = uniform_material(surface.n_vertices, 1.0, 1.0)
    soft = np.hypot(*(surface.chart - 0.5).T) < 0.3
    material = type(stiff)(stiff.direction, stiff.stretching * ~soft[:, None], stiff.bending * ~soft[:, None])
    stiffness = assembler.assemble(element_tensors(surface, material)).matrix
    system = SurfaceSystem(assembler.dofs, stiffness, boundary_supports(surface, Support.CLAMPED))
    with pytest.raises(SingularSystemError) as caught:
        system.factorise()
    assert soft[caught.value.vertices].all()


def test_very_soft_springs_are_not_mistaken_for_none() -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, HCT12)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 1.0))
    nowhere = Supports(np.zeros(surface.n_vertices, dtype=np.int64))
    foundation = Foundation(np.tile(1e-6 * np.eye(3), (surface.n_vertices, 1, 1)))
    stiffness = assembler.assemble(tensors).matrix
    system = SurfaceSystem(assembler.dofs, stiffness, nowhere, foundation.coupling(assembler))
    load = load_operator(assembler) @ np.full((surface.n_vertices, 3), 1e-6)
    moved = system.solve(load)[assembler.dofs.value_dofs]
    assert moved == pytest.approx(1.0, rel=1e-4)


def test_loads_that_cannot_be_are_refused() -> None:
    assembler, system = held_face(HCT9, coupled=False)
    good = random_loads(assembler, 2)
    with pytest.raises(FemError, match=r"loads must be \(\d+, 3\)"):
        system.solve(good[:-1])
    with pytest.raises(FemError, match="they must agree"):
        system.solve(good, held_values=good[..., 0])
    broken = good.copy()
    broken[3 * 17 + 1, 2, 0] = np.nan
    with pytest.raises(FemError, match="loads are not finite at vertex 17"):
        system.solve(broken)
    with pytest.raises(FemError, match="stiffness is"):
        SurfaceSystem(assembler.dofs, eye_array(3).tocsc(), boundary_supports(assembler.surface, Support.VALUE))
    stiffness = assembler.matrix_of(np.ones((assembler.surface.n_triangles, 9, 9)))
    with pytest.raises(FemError, match="springs are"):
        SurfaceSystem(assembler.dofs, stiffness, boundary_supports(assembler.surface, Support.VALUE), stiffness)
