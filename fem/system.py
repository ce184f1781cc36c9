"""The three coordinates of the displacement as one linear system: factorised once, solved for many loads."""

from collections.abc import Callable

import numpy as np
from scipy.sparse import bsr_array, coo_array, csc_array, eye_array, kron
from scipy.sparse.csgraph import connected_components

from fem.dofs import DofMap
from fem.errors import FemError, SingularSystemError
from fem.factor import Factor, LooseMatrixError, factorise
from fem.supports import Supports
from fem.types import BoolArray, FloatArray, IntArray

# Right-hand sides solved between two calls of the progress callback: enough that the factors are streamed from memory
# once for many, few enough that cancelling is felt as immediate.
CHUNK = 16

Progress = Callable[[int, int], None]


class SurfaceSystem:
    """K a = F for the displacement of a surface.

    The scalar stiffness serves each coordinate. Without springs and sliding supports one scalar factorisation
    does for all three; otherwise the unknowns are interleaved, ``3 * dof + coordinate``, and factorised
    together. Held degrees of freedom are eliminated. The factorisation is made on first use and kept.

    Parameters
    ----------
    dofs
        Numbering of the scalar degrees of freedom.
    stiffness
        (n_dofs, n_dofs) from `Assembler.assemble`.
    supports
        Where the surface is held.
    coupling
        (3 n_dofs, 3 n_dofs) springs from `SpringLayer.coupling`, or the sum of several; symmetric positive
        semidefinite.

    Raises
    ------
    FemError
        If the sizes do not agree.
    SingularSystemError
        If a connected part of the surface has neither support nor spring.
    """

    def __init__(
        self, dofs: DofMap, stiffness: csc_array, supports: Supports, coupling: csc_array | None = None
    ) -> None:
        n_dofs = dofs.n_dofs
        if stiffness.shape != (n_dofs, n_dofs):
            raise FemError(f"The stiffness is {stiffness.shape}, the surface has {n_dofs} degrees of freedom.")
        if coupling is not None and coupling.shape != (3 * n_dofs, 3 * n_dofs):
            raise FemError(f"The springs are {coupling.shape}, they must be {(3 * n_dofs, 3 * n_dofs)}.")
        self.dofs = dofs
        held = supports.held_dofs(dofs)
        _check_parts(dofs, held, supports, coupling)
        self.is_coupled = coupling is not None or len(supports.sliding) > 0
        self._rotation = _sliding_rotation(dofs, supports) if len(supports.sliding) else None
        matrix = stiffness
        if self.is_coupled:
            matrix = csc_array(kron(stiffness, eye_array(3), format="csc"))
            matrix = matrix if coupling is None else csc_array(matrix + coupling)
            held = np.repeat(held, 3)
            held[3 * dofs.value_dofs[supports.sliding]] = True
        if self._rotation is not None:
            matrix = csc_array(self._rotation.T @ matrix @ self._rotation)
        free = np.flatnonzero(~held)
        self._free = free[np.argsort(dofs.elimination_rank[free // 3 if self.is_coupled else free], kind="stable")]
        self._held = np.flatnonzero(held)
        columns = matrix[:, self._free]
        self._stiff_free = csc_array(columns[self._free])
        self._free_by_held = csc_array(columns[self._held]).T
        self._factor: Factor | None = None
        self.factorisations = 0
        self.loads_solved = 0

    @property
    def n_unknowns(self) -> int:
        """Number of unknowns that are factorised together."""
        return len(self._free)

    def factorise(self) -> None:
        """Factorise now rather than at the first solve; nothing happens when that is already done.

        Raises
        ------
        SingularSystemError
            If part of the surface can move without energy; it names the vertices.
        """
        if self._factor is not None or self.n_unknowns == 0:
            return
        try:
            self._factor = factorise(self._stiff_free, ordered=True)
        except LooseMatrixError as error:
            dofs = self._free // 3 if self.is_coupled else self._free
            vertices = _loose_vertices(self.dofs, dofs, error.motion)
            raise SingularSystemError(
                f"The surface is loose around vertex {vertices[0]}: it moves there against next to no stiffness. "
                "Hold more vertices, attach stiffer springs, or raise a stretching or bending that is zero.",
                vertices,
            ) from error
        self.factorisations += 1

    def solve(
        self, loads: FloatArray, held_values: FloatArray | None = None, progress: Progress | None = None
    ) -> FloatArray:
        """Solve for one load or many.

        Parameters
        ----------
        loads
            (n_dofs, 3) or (n_dofs, 3, M) consistent loads.
        held_values
            Displacements and slopes of the same shape, read only where the supports hold them; zero by
            default.
        progress
            Called as ``progress(done, total)`` before the first and after every chunk of loads. Whatever it
            raises ends the solve, which is how to cancel.

        Returns
        -------
        Coefficients of the displacement, shaped like `loads`.

        Raises
        ------
        FemError
            If a shape is wrong or a load is not finite.
        SingularSystemError
            If part of the surface can move without energy.
        """
        loads = self._checked(loads, "loads")
        values = None if held_values is None else self._checked(held_values, "held values")
        if values is not None and values.shape != loads.shape:
            raise FemError(f"The held values are {values.shape}, the loads {loads.shape}; they must agree.")
        total = 1 if loads.ndim == 2 else loads.shape[2]
        if progress is not None:
            progress(0, total)
        self.factorise()
        columns = self._to_unknowns(loads)
        solution = np.zeros(columns.shape)
        right = columns[self._free]
        if values is not None:
            solution[self._held] = self._to_unknowns(values)[self._held]
            right -= self._free_by_held @ solution[self._held]
        solution[self._free] = self._solved(right, total, progress)
        if self._rotation is not None:
            solution = self._rotation @ solution
        self.loads_solved += total
        return solution.reshape(loads.shape)

    def _checked(self, array: FloatArray, name: str) -> FloatArray:
        array = np.asarray(array, dtype=np.float64)
        n_dofs = self.dofs.n_dofs
        if array.ndim not in (2, 3) or array.shape[:2] != (n_dofs, 3):
            raise FemError(f"The {name} must be ({n_dofs}, 3) or ({n_dofs}, 3, M), not {array.shape}.")
        bad = np.argwhere(~np.isfinite(array))
        if len(bad):
            vertex = self.dofs.vertex_of(bad[:1, 0])[0]
            raise FemError(f"The {name} are not finite at vertex {vertex}.")
        return array

    def _solved(self, right: FloatArray, total: int, progress: Progress | None) -> FloatArray:
        if self._factor is None:
            return right
        # SuperLU wants its columns contiguous; so does every chunk then.
        right = np.asfortranarray(right)
        count = right.shape[1]
        for start in range(0, count, CHUNK):
            chunk = slice(start, min(start + CHUNK, count))
            right[:, chunk] = self._factor.solve(right[:, chunk])
            if progress is not None:
                progress(chunk.stop * total // count, total)
        return right

    def _to_unknowns(self, fields: FloatArray) -> FloatArray:
        rows = 3 * self.dofs.n_dofs if self.is_coupled else self.dofs.n_dofs
        columns = fields.reshape(rows, -1)
        return columns if self._rotation is None else np.asarray(self._rotation.T @ columns)


def _loose_vertices(dofs: DofMap, moving: IntArray, motion: FloatArray) -> IntArray:
    """Return the vertices displaced at least half as far as the farthest, that one first.

    Where nothing but slopes moves, their vertices.
    """
    is_value = np.isin(moving, dofs.value_dofs)
    if motion[is_value].max(initial=0.0) > 0.0:
        moving, motion = moving[is_value], motion[is_value]
    order = np.argsort(-motion, kind="stable")
    far = order[motion[order] >= 0.5 * motion.max()]
    vertices = dofs.vertex_of(moving[far])
    _, first = np.unique(vertices, return_index=True)
    return np.asarray(vertices[np.sort(first)], dtype=np.int64)


def _sliding_rotation(dofs: DofMap, supports: Supports) -> csc_array:
    """Return the (3 n_dofs, 3 n_dofs) rotation from sliding frames to world axes, identity elsewhere."""
    blocks = np.tile(np.eye(3), (dofs.n_dofs, 1, 1))
    blocks[dofs.value_dofs[supports.sliding]] = supports.sliding_frames()
    size = 3 * dofs.n_dofs
    diagonal = (blocks, np.arange(dofs.n_dofs), np.arange(dofs.n_dofs + 1))
    rotation = csc_array(bsr_array(diagonal, shape=(size, size)).tocsc())
    rotation.eliminate_zeros()
    return rotation


def _check_parts(dofs: DofMap, held: BoolArray, supports: Supports, coupling: csc_array | None) -> None:
    """Refuse a surface of which a connected part hangs in the air."""
    surface = dofs.surface
    anchored = np.zeros(surface.n_vertices, dtype=np.bool_)
    anchored[dofs.vertex_of(np.flatnonzero(held))] = True
    anchored[supports.sliding] = True
    if coupling is not None:
        stiff = np.asarray(coupling.diagonal()).reshape(-1, 3).max(axis=1) > 0.0
        anchored[dofs.vertex_of(np.flatnonzero(stiff))] = True
    edges = surface.edges
    graph = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(surface.n_vertices,) * 2)
    n_parts, part = connected_components(graph, directed=False)
    loose = np.flatnonzero(np.bincount(part[anchored], minlength=n_parts) == 0)
    if len(loose):
        vertices = np.flatnonzero(part == loose[0])
        raise SingularSystemError(
            f"The part of {len(vertices)} vertices around vertex {vertices[0]} has no support and no spring; "
            "hold some of its vertices or attach springs.",
            vertices,
        )
