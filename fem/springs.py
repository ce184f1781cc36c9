"""Springs between the surface and what lies below it, each with its own direction.

A spring of axial stiffness c along the unit vector d adds c d d^T to the three coordinates of its vertex, and
when its anchor moves by delta it loads the vertex with c d d^T delta. Summed per vertex, that is a 3 x 3
block and a force. The blocks act in one of two ways behind the same interface: concentrated at the vertices,
or spread over the surface.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from scipy.sparse import bsr_array, csc_array

from fem.assembly import Assembler, batches
from fem.blocks import block_matrix
from fem.errors import FemError
from fem.loads import load_operator
from fem.types import FloatArray, IntArray

# Two shape functions (3 + 3) times a stiffness linear in the triangle (1).
FOUNDATION_DEGREE = 7
# Rounding allowed in the symmetry and the eigenvalues of a block, as a share of its largest entry.
BLOCK_TOLERANCE = 1e-10
# The six entries of a symmetric 3 x 3 block.
_ROWS = np.array([0, 1, 2, 0, 1, 2])
_COLUMNS = np.array([0, 1, 2, 1, 2, 0])
# Which of them stands at each row and column.
_PLACES = ((0, 3, 5), (3, 1, 4), (5, 4, 2))


@dataclass(frozen=True, eq=False)
class SpringSet:
    """M springs, each from a vertex to an anchor.

    Parameters
    ----------
    vertices
        (M,) vertex of each spring; a vertex may have many.
    directions
        (M, 3) vectors along the springs, of any length but not zero.
    stiffness
        (M,) axial stiffness: N/mm for `PointSprings`, N/mm^3 for a `Foundation`. Not negative.

    Raises
    ------
    FemError
        If a direction is zero or a stiffness is negative or not finite.
    """

    vertices: IntArray
    directions: FloatArray
    stiffness: FloatArray

    def __post_init__(self) -> None:
        length = np.linalg.norm(self.directions, axis=1)
        bad = np.flatnonzero(~(np.isfinite(length) & (length > 0.0)))
        if len(bad):
            raise FemError(f"Spring {bad[0]} at vertex {self.vertices[bad[0]]} has no direction.")
        bad = np.flatnonzero(~(np.isfinite(self.stiffness) & (self.stiffness >= 0.0)))
        if len(bad):
            raise FemError(
                f"Spring {bad[0]} at vertex {self.vertices[bad[0]]} has stiffness {self.stiffness[bad[0]]}; "
                "it must be finite and not negative."
            )
        object.__setattr__(self, "directions", self.directions / length[:, None])

    def blocks(self, n_vertices: int) -> FloatArray:
        """Return the (N, 3, 3) sum of c d d^T at every vertex."""
        outer = self.directions[:, :, None] * self.directions[:, None, :]
        return self._summed(self.stiffness[:, None, None] * outer, n_vertices)

    def anchor_forces(self, displacements: FloatArray, n_vertices: int) -> FloatArray:
        """Return the (N, 3) sum of c d d^T delta for anchors displaced by `displacements` (M, 3)."""
        pull = self.stiffness * (self.directions * displacements).sum(axis=1)
        return self._summed(pull[:, None] * self.directions, n_vertices)

    def _summed(self, per_spring: FloatArray, n_vertices: int) -> FloatArray:
        result = np.zeros((n_vertices, *per_spring.shape[1:]))
        np.add.at(result, self.vertices, per_spring)
        return result


class SpringLayer(Protocol):
    """Springs as a matrix that couples the coordinates, and the loads of their moved anchors."""

    def coupling(self, assembler: Assembler) -> csc_array:
        """Return the (3 n_dofs, 3 n_dofs) matrix, unknown ``3 * dof + coordinate``."""
        ...

    def anchor_loads(self, assembler: Assembler, forces: FloatArray) -> FloatArray:
        """Return (n_dofs, k) loads of `forces` (N, k) summed at the vertices by `SpringSet.anchor_forces`."""
        ...


@dataclass(frozen=True, eq=False)
class PointSprings:
    """Springs concentrated at the vertices; their effect grows with the number of vertices.

    Parameters
    ----------
    blocks
        (N, 3, 3) symmetric positive semidefinite stiffness of each vertex in N/mm.
    """

    blocks: FloatArray

    def __post_init__(self) -> None:
        _check_blocks(self.blocks)

    def coupling(self, assembler: Assembler) -> csc_array:
        """Return the (3 n_dofs, 3 n_dofs) matrix, unknown ``3 * dof + coordinate``."""
        _check_count(len(self.blocks), assembler)
        n_dofs = assembler.dofs.n_dofs
        value_dofs = assembler.dofs.value_dofs
        starts = np.searchsorted(value_dofs, np.arange(n_dofs + 1))
        matrix = bsr_array((self.blocks, value_dofs, starts), shape=(3 * n_dofs, 3 * n_dofs))
        return csc_array(matrix.tocsc())

    def anchor_loads(self, assembler: Assembler, forces: FloatArray) -> FloatArray:
        """Return (n_dofs, k) loads of `forces` (N, k) in newtons at the vertices."""
        _check_count(len(forces), assembler)
        result = np.zeros((assembler.dofs.n_dofs, forces.shape[1]))
        result[assembler.dofs.value_dofs] = forces
        return result


@dataclass(frozen=True, eq=False)
class Foundation:
    """Springs spread over the surface: integral of w^T k w, with k linear in every triangle.

    The solution does not depend on the density of the mesh.

    Parameters
    ----------
    blocks
        (N, 3, 3) symmetric positive semidefinite stiffness per area at each vertex in N/mm^3.
    """

    blocks: FloatArray

    def __post_init__(self) -> None:
        _check_blocks(self.blocks)

    def coupling(self, assembler: Assembler) -> csc_array:
        """Return the (3 n_dofs, 3 n_dofs) matrix, unknown ``3 * dof + coordinate``."""
        _check_count(len(self.blocks), assembler)
        entries = self.blocks[:, _ROWS, _COLUMNS]
        local = assembler.dofs.element_dofs
        matrices = np.empty((6, len(local), local.shape[1], local.shape[1]))
        for batch in batches(len(local)):
            own = entries[assembler.surface.triangles[batch]]
            masses = _corner_masses(assembler, np.arange(batch.start, batch.stop))
            matrices[:, batch] = np.einsum("mce,mcij->emij", own, masses, optimize=True)
        scalars = [assembler.matrix_of(entry) for entry in matrices]
        return block_matrix([[scalars[_PLACES[row][column]] for column in range(3)] for row in range(3)])

    def anchor_loads(self, assembler: Assembler, forces: FloatArray) -> FloatArray:
        """Return (n_dofs, k) loads of `forces` (N, k) per area at the vertices, linear in every triangle."""
        _check_count(len(forces), assembler)
        return np.asarray(load_operator(assembler) @ forces)


def _corner_masses(assembler: Assembler, elements: IntArray) -> FloatArray:
    """Return (m, 3, n, n) integrals of Phi^T lambda_c Phi, lambda_c the coordinate of corner c."""
    quadrature = assembler.quadrature(FOUNDATION_DEGREE)
    weights = assembler.surface.areas[elements, None] * quadrature.weights
    shapes = quadrature.values(elements)
    transposed = np.swapaxes(shapes, 1, 2)
    corners = [(transposed * (weights * quadrature.barycentric[:, corner])[:, None]) @ shapes for corner in range(3)]
    masses = np.stack(corners, axis=1)
    return np.asarray(0.5 * (masses + np.swapaxes(masses, 2, 3)))


def _check_blocks(blocks: FloatArray) -> None:
    if blocks.ndim != 3 or blocks.shape[1:] != (3, 3):
        raise FemError(f"Spring blocks must be (N, 3, 3), not {blocks.shape}.")
    finite = np.asarray(np.isfinite(blocks).all(axis=(1, 2)))
    safe = np.where(finite[:, None, None], blocks, 0.0)
    limit = BLOCK_TOLERANCE * np.abs(safe).max(axis=(1, 2))
    skew = np.abs(safe - np.swapaxes(safe, 1, 2)).max(axis=(1, 2))
    least = np.linalg.eigvalsh(safe)[:, 0]
    bad = np.flatnonzero(~(finite & (skew <= limit) & (least >= -limit)))
    if len(bad):
        raise FemError(f"The spring block of vertex {bad[0]} is not symmetric positive semidefinite.")


def _check_count(count: int, assembler: Assembler) -> None:
    if count != assembler.surface.n_vertices:
        raise FemError(f"There are springs for {count} vertices, the surface has {assembler.surface.n_vertices}.")
