"""The order in which unknowns are eliminated so that few new entries arise: nested dissection in the chart.

The triangles are cut in two along a line of the chart, again and again; what lies on a cut is eliminated after both of
its sides (George 1973). Of all lines in some directions the one with the fewest unknowns on it is taken, unless it
cuts off too little. On a face of three thousand vertices this fills the factors as little as minimum degree does; on
one of twenty thousand, irregularly refined, less than half as much.
"""

import numpy as np

from fem.types import BoolArray, FloatArray, IntArray

# Triangles that are not cut further; their unknowns are eliminated along a line, which is as good.
LEAF = 12
# Directions of the lines that are tried, over half a turn.
DIRECTIONS = 8
# Smallest share of the triangles on one side of a cut.
SMALLEST_SIDE = 0.25
# Price of a cut that leaves nothing on one side against one that halves.
IMBALANCE = 2.0


def nested_dissection(centres: FloatArray, element_dofs: IntArray, places: FloatArray) -> IntArray:
    """Return the degrees of freedom of all triangles in the order in which they are to be eliminated.

    Parameters
    ----------
    centres
        (T, 2) middle of each triangle in the chart.
    element_dofs
        (T, n) degrees of freedom of each triangle.
    places
        (n_dofs, 2) where in the chart each degree of freedom lies.
    """
    turn = np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    axes = np.stack([np.cos(turn), np.sin(turn)])
    heights = (centres @ axes).T
    taken = np.zeros(len(places), dtype=np.bool_)
    last_first: list[IntArray] = []
    waiting = [np.arange(len(element_dofs))]
    while waiting:
        elements = waiting.pop()
        own, local = np.unique(element_dofs[elements], return_inverse=True)
        free = ~taken[own]
        if len(elements) <= LEAF:
            chosen = own[free]
            chosen = chosen[np.argsort(places[chosen] @ axes[:, 1], kind="stable")]
        else:
            low, shared = _cut(heights[:, elements], local.reshape(len(elements), -1), free)
            chosen = own[shared]
            waiting += [elements[low], elements[~low]]
        taken[chosen] = True
        last_first.append(chosen)
    return np.concatenate(last_first[::-1])


def _cut(heights: FloatArray, local: IntArray, free: BoolArray) -> tuple[BoolArray, BoolArray]:
    """Choose the line with the fewest free unknowns on it.

    Parameters
    ----------
    heights
        (d, m) of m triangles over lines of d directions.
    local
        (m, n) number, below k, of each unknown of each triangle.
    free
        (k,) unknowns that no earlier cut has taken.

    Returns
    -------
    (m,) triangles below the line, and (k,) free unknowns that both of its sides share.
    """
    directions, count = heights.shape
    rank = np.empty((directions, count), dtype=np.int64)
    np.put_along_axis(rank, np.argsort(heights, axis=1, kind="stable"), np.arange(count)[None], axis=1)
    by_unknown = np.argsort(local, axis=None, kind="stable")
    starts = np.searchsorted(local.ravel()[by_unknown], np.arange(len(free)))
    ranks = rank[:, by_unknown // local.shape[1]]
    first, last = np.minimum.reduceat(ranks, starts, axis=1), np.maximum.reduceat(ranks, starts, axis=1)
    # A cut below rank c shares the unknowns whose first triangle is below c and whose last is not.
    row = (count + 1) * np.arange(directions)[:, None]
    begun, ended = (
        np.bincount((row + at + 1)[:, free].ravel(), minlength=directions * (count + 1)) for at in (first, last)
    )
    shared = np.cumsum((begun - ended).reshape(directions, count + 1), axis=1)
    least = int(SMALLEST_SIDE * count)
    below = np.arange(least, count - least + 1)
    price = shared[:, below] * (1.0 + (IMBALANCE - 1.0) * (2.0 * below / count - 1.0) ** 2)
    best, at = np.unravel_index(price.argmin(), price.shape)
    cut = below[at]
    return rank[best] < cut, free & (first[best] < cut) & (last[best] >= cut)
