"""Join scalar matrices of one symmetric pattern into one that couples the three coordinates."""

from collections.abc import Sequence

import numpy as np
from scipy.sparse import bsr_array, csc_array


def block_matrix(entries: Sequence[Sequence[csc_array]]) -> csc_array:
    """Return the (3 n, 3 n) matrix whose unknown ``3 * dof + coordinate`` couples by `entries`.

    Parameters
    ----------
    entries
        3 x 3 matrices (n, n) of one pattern that is symmetric, stored alike; entry (d, c) is the transpose of entry
        (c, d), so that the whole is symmetric.
    """
    pattern = entries[0][0]
    blocks = np.empty((len(pattern.data), 3, 3))
    for row in range(3):
        for column in range(3):
            # Compressed columns serve as compressed rows of the transposed matrix, which is the matrix itself.
            blocks[:, column, row] = entries[row][column].data
    size = 3 * pattern.shape[0]
    return csc_array(bsr_array((blocks, pattern.indices, pattern.indptr), shape=(size, size)).tocsc())
