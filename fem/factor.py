"""Sparse factorisation of a symmetric positive definite matrix, checked once and then reused."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array, diags_array
from scipy.sparse.linalg import SuperLU, splu

from fem.errors import FemError
from fem.types import FloatArray

# A known solution must come back to this accuracy, each unknown measured by the root of its diagonal entry. Held
# surfaces return it to 1e-7 or better, loose ones miss it altogether; in between, where springs are far softer than
# the skin, it foretells the error of the displacement, and a thousandth is as much as may pass for a solution.
PROBE_TOLERANCE = 1e-3
# Share of the diagonal added to a loose matrix so that it can be factorised to find how it moves.
LOOSE_SHIFT = 1e-9
LOOSE_ITERATIONS = 3
_SEED = 1998


class LooseMatrixError(FemError):
    """The matrix is singular to working accuracy.

    Parameters
    ----------
    motion
        (n,) size of each unknown in the motion that costs no energy.
    """

    def __init__(self, motion: FloatArray) -> None:
        super().__init__("The stiffness is singular to working accuracy; look for very thin triangles.")
        self.motion = motion


@dataclass(frozen=True, eq=False)
class Factor:
    """The factors of a matrix.

    Parameters
    ----------
    lu
        SuperLU factors in an ordering for symmetric patterns.
    """

    lu: SuperLU

    def solve(self, right_hand_sides: FloatArray) -> FloatArray:
        """Return the (n, k) solutions for (n, k) right-hand sides."""
        return np.asarray(self.lu.solve(np.asfortranarray(right_hand_sides)), dtype=np.float64)


def factorise(matrix: csc_array, ordered: bool = False) -> Factor:
    """Factorise an (n, n) symmetric positive definite matrix, without pivoting.

    Parameters
    ----------
    matrix
        The matrix.
    ordered
        Whether its rows are in an order that fills the factors little, as `DofMap.elimination_rank` tells. Other
        matrices are ordered by symmetric minimum degree, five times faster here than the default of SciPy.

    Raises
    ------
    LooseMatrixError
        If it is singular, exactly or to working accuracy.
    """
    diagonal = np.asarray(matrix.diagonal(), dtype=np.float64)
    if not np.all(diagonal > 0.0):
        raise LooseMatrixError((~(diagonal > 0.0)).astype(np.float64))
    try:
        factor = Factor(_lu(matrix, ordered))
    except RuntimeError as error:
        raise LooseMatrixError(_loose_motion(matrix, diagonal, ordered)) from error
    scale = np.sqrt(diagonal)
    known = np.random.default_rng(_SEED).choice([-1.0, 1.0], len(scale)) / scale
    returned = factor.solve(np.asarray(matrix @ known)[:, None])[:, 0]
    if not np.all(np.abs(returned - known) * scale < PROBE_TOLERANCE):
        raise LooseMatrixError(_loose_motion(matrix, diagonal, ordered))
    return factor


def _lu(matrix: csc_array, ordered: bool) -> SuperLU:
    order = "NATURAL" if ordered else "MMD_AT_PLUS_A"
    return splu(matrix, permc_spec=order, diag_pivot_thresh=0.0, options={"SymmetricMode": True})


def _loose_motion(matrix: csc_array, diagonal: FloatArray, ordered: bool) -> FloatArray:
    """Find the motion of least energy by inverse iteration on the matrix with a slightly raised diagonal."""
    scale = np.sqrt(diagonal)
    shifted = _lu(csc_array(matrix + diags_array(LOOSE_SHIFT * diagonal)), ordered)
    motion = np.random.default_rng(_SEED).standard_normal(len(scale))
    for _ in range(LOOSE_ITERATIONS):
        motion = shifted.solve(motion * scale) * scale
        motion /= np.abs(motion).max()
    return np.asarray(np.abs(motion / scale))
