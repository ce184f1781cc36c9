"""The order of elimination: every unknown once, both sides of a cut before it, and factors that fill little."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse import csc_array
from scipy.sparse.linalg import splu

from fem import (
    HCT9,
    HCT12,
    DofMap,
    Element,
    Support,
    SurfaceSystem,
    element_tensors,
    smooth_assembler,
    uniform_material,
)
from fem.ordering import LEAF, nested_dissection
from tests.fem.meshes import boundary_supports, domed, irregular, plate

BOTH = pytest.mark.parametrize("element", [HCT9, HCT12], ids=lambda e: e.name)


@BOTH
@given(st.integers(1, 9), st.booleans())
def test_every_unknown_is_eliminated_once(element: Element, size: int, holed: bool) -> None:
    dofs = DofMap(irregular(10 * size) if holed else plate(size), element)
    assert np.array_equal(np.sort(dofs.elimination_rank), np.arange(dofs.n_dofs))


@BOTH
def test_the_last_unknowns_cut_the_surface_in_two(element: Element) -> None:
    """Taking away the tail of the order leaves at least two parts, none larger than three quarters."""
    surface = plate(16)
    dofs = DofMap(surface, element)
    sides = np.sort(dofs.elimination_rank)[::-1]
    parts: list[set[int]] = []
    for tail in range(1, dofs.n_dofs // 4):
        parts = parts_without(dofs, set(np.flatnonzero(dofs.elimination_rank >= sides[tail - 1]).tolist()))
        if len(parts) > 1:
            break
    assert len(parts) == 2
    assert max(len(part) for part in parts) <= 0.76 * dofs.n_dofs
    # A line across 16 squares holds 17 vertices and, for HCT-12, the 16 edges on it.
    assert tail <= 3 * 17 + 16


def parts_without(dofs: DofMap, gone: set[int]) -> list[set[int]]:
    """Return the sets of unknowns that triangles join when some are taken away."""
    parts: list[set[int]] = []
    for own in dofs.element_dofs.tolist():
        joined = set(own) - gone
        if not joined:
            continue
        apart = []
        for part in parts:
            if part & joined:
                joined |= part
            else:
                apart.append(part)
        parts = [*apart, joined]
    return parts


def test_a_few_triangles_are_not_cut() -> None:
    surface = plate(2)
    assert surface.n_triangles <= LEAF
    dofs = DofMap(surface, HCT12)
    order = np.argsort(dofs.elimination_rank)
    height = surface.chart[dofs.vertex_of(order)] @ [np.cos(np.pi / 8), np.sin(np.pi / 8)]
    assert np.array_equal(height, np.sort(height))


def test_triangles_on_one_place_are_ordered_too() -> None:
    """Centres that coincide leave no line between them, and still there is an order."""
    count = 4 * LEAF
    element_dofs = np.arange(count * 3).reshape(count, 3) // 2
    n_dofs = int(element_dofs.max()) + 1
    order = nested_dissection(np.zeros((count, 2)), element_dofs, np.zeros((n_dofs, 2)))
    assert np.array_equal(np.sort(order), np.arange(n_dofs))


def stiffness_of_a_plate(element: Element, segments: int) -> tuple[DofMap, csc_array]:
    surface = plate(segments)
    assembler = smooth_assembler(surface, element)
    matrix = assembler.assemble(element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 1.0))).matrix
    return assembler.dofs, matrix


@BOTH
def test_the_factors_fill_about_as_little_as_by_minimum_degree(element: Element) -> None:
    dofs, matrix = stiffness_of_a_plate(element, 24)
    free = np.flatnonzero(~boundary_supports(dofs.surface, Support.CLAMPED).held_dofs(dofs))
    ordered = free[np.argsort(dofs.elimination_rank[free])]

    def fill(rows: np.ndarray, order: str) -> int:
        columns = matrix[:, rows]
        options = {"SymmetricMode": True}
        return splu(columns[rows], permc_spec=order, diag_pivot_thresh=0.0, options=options).nnz

    assert fill(ordered, "NATURAL") < 1.25 * fill(free, "MMD_AT_PLUS_A")
    assert fill(ordered, "NATURAL") < 0.6 * fill(np.random.default_rng(1).permutation(free), "NATURAL")


@BOTH
def test_the_order_does_not_change_the_solution(element: Element) -> None:
    surface = domed(irregular())
    assembler = smooth_assembler(surface, element)
    matrix = assembler.assemble(element_tensors(surface, uniform_material(surface.n_vertices, 1.0, 0.2))).matrix
    supports = boundary_supports(surface, Support.CLAMPED)
    load = np.random.default_rng(2).standard_normal((assembler.dofs.n_dofs, 3))
    free = np.flatnonzero(~supports.held_dofs(assembler.dofs))
    expected = np.zeros_like(load)
    expected[free] = np.linalg.solve(matrix.toarray()[np.ix_(free, free)], load[free])
    found = SurfaceSystem(assembler.dofs, matrix, supports).solve(load)
    assert found == pytest.approx(expected, rel=1e-8, abs=1e-10)
