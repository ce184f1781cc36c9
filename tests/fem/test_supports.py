"""What each kind of support holds."""

import numpy as np
import pytest

from fem import (
    HCT9,
    HCT12,
    Assembler,
    DofMap,
    Element,
    FemError,
    Foundation,
    PointSprings,
    Support,
    Supports,
    SurfaceSystem,
    element_tensors,
    load_operator,
    smooth_assembler,
    uniform_material,
)
from tests.fem.meshes import boundary_supports, domed, irregular, on_boundary, plate

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)


def test_kinds_hold_values_slopes_and_edges() -> None:
    surface = plate(1)
    dofs = DofMap(surface, HCT12)
    kinds = np.array([Support.FREE, Support.VALUE, Support.CLAMPED, Support.CLAMPED])
    held = np.flatnonzero(Supports(kinds).held_dofs(dofs))
    between_clamped = np.flatnonzero((surface.edges == [2, 3]).all(axis=1))
    assert held.tolist() == [3, 6, 7, 8, 9, 10, 11, 12 + between_clamped[0]]


@BOTH
@pytest.mark.parametrize("kind", [Support.VALUE, Support.CLAMPED])
def test_held_values_are_taken_and_slopes_only_when_clamped(element: Element, kind: Support) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 1.0))
    system = SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, boundary_supports(surface, kind))
    wanted = np.random.default_rng(0).standard_normal((assembler.dofs.n_dofs, 3))
    found = system.solve(np.zeros_like(wanted), held_values=wanted)
    rim = assembler.dofs.value_dofs[on_boundary(surface)]
    assert np.array_equal(found[rim], wanted[rim])
    assert np.array_equal(found[rim + 1], wanted[rim + 1]) == (kind is Support.CLAMPED)


@BOTH
def test_a_sliding_vertex_keeps_to_its_plane(element: Element) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    rng = np.random.default_rng(0)
    normals = rng.standard_normal((surface.n_vertices, 3))
    rim = on_boundary(surface)
    supports = Supports(np.where(rim, Support.SLIDING, Support.FREE), normals)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 0.1))
    stiffness = assembler.assemble(tensors).matrix
    system = SurfaceSystem(assembler.dofs, stiffness, supports)
    load = load_operator(assembler) @ rng.standard_normal((surface.n_vertices, 3))
    moved = system.solve(load)[assembler.dofs.value_dofs]
    unit = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    along = (moved * unit).sum(axis=1)[rim]
    assert np.abs(along).max() < 1e-10 * np.abs(moved).max()
    assert np.abs(moved[rim]).max() > 1e-3 * np.abs(moved).max()
    # The same through springs a million times stiffer than the skin.
    blocks = 1e6 * unit[:, :, None] * unit[:, None, :] * rim[:, None, None]
    free = Supports(np.zeros(surface.n_vertices, dtype=np.int64))
    penalised = SurfaceSystem(assembler.dofs, stiffness, free, PointSprings(blocks).coupling(assembler))
    assert penalised.solve(load)[assembler.dofs.value_dofs] == pytest.approx(moved, abs=1e-4 * np.abs(moved).max())


def test_a_sliding_vertex_can_be_lifted_along_its_normal() -> None:
    surface = plate(3)
    assembler = Assembler(surface, HCT9)
    kinds = np.where(on_boundary(surface), Support.SLIDING, Support.FREE)
    normals = np.tile([0.0, 3.0, 4.0], (surface.n_vertices, 1))
    soft = Foundation(np.tile(np.eye(3) * 1e-3, (surface.n_vertices, 1, 1))).coupling(assembler)
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 1.0))
    system = SurfaceSystem(assembler.dofs, assembler.assemble(tensors).matrix, Supports(kinds, normals), soft)
    held = np.zeros((assembler.dofs.n_dofs, 3))
    held[assembler.dofs.value_dofs] = [0.0, 0.6, 0.8]
    moved = system.solve(np.zeros_like(held), held_values=held)[assembler.dofs.value_dofs]
    assert moved[on_boundary(surface)] @ np.array([0.0, 0.6, 0.8]) == pytest.approx(1.0)


def test_bad_supports_are_refused() -> None:
    dofs = DofMap(plate(1), HCT9)
    with pytest.raises(FemError, match="Vertex 1 has the unknown kind of support 7"):
        Supports(np.array([0, 7, 0, 0]))
    with pytest.raises(FemError, match=r"need normals of shape \(4, 3\)"):
        Supports(np.full(4, Support.SLIDING))
    with pytest.raises(FemError, match="Vertex 0 slides but its normal is"):
        Supports(np.full(4, Support.SLIDING), np.zeros((4, 3)))
    with pytest.raises(FemError, match="5 supports for 4 vertices"):
        Supports(np.zeros(5, dtype=np.int64)).held_dofs(dofs)
