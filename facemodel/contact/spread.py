"""How the skin about a slit goes with its columns: each point with four neighbouring ones at most."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from fem.types import Float32Array, FloatArray, IntArray

ABREAST = 4
"""Columns that a cubic spline reaches at any place."""


class Spread(NamedTuple):
    """How much points go with columns.

    Attributes
    ----------
    points : (m,) those that go with any
    first : (m,) the first column that each goes with
    share : (m, 4) how much with that one and the next three
    """

    points: IntArray
    first: IntArray
    share: FloatArray


def spread_of(shares: FloatArray) -> Spread:
    """The same of shares (n, I) of which no point has more than four, one beside the other."""
    points = np.flatnonzero(shares.any(axis=1))
    first = np.minimum((shares[points] != 0).argmax(axis=1), shares.shape[1] - ABREAST)
    chosen = first[:, None] + np.arange(ABREAST)
    return Spread(points, first, np.take_along_axis(shares[points], chosen, axis=1))


@compiled
def gone_with(spread: Spread, ways: FloatArray, number: int) -> float:
    """How far one of the points of a spread, by its number there, goes with ways (I,) of the columns."""
    total = 0.0
    for k in range(ABREAST):
        total += spread.share[number, k] * ways[spread.first[number] + k]
    return total


@compiled
def lift(here: Float32Array, spread: Spread, ways: FloatArray, up: FloatArray) -> None:
    """Move points (n, 3) along a direction (3,) with ways (I,) of the columns, in place."""
    for number in range(len(spread.points)):
        by = gone_with(spread, ways, number)
        if by != 0.0:
            for axis in range(3):
                here[spread.points[number], axis] += by * up[axis]


@compiled
def carry(here: Float32Array, spread: Spread, ways: FloatArray) -> None:
    """Move points (n, 3) with ways (I, 3) of the columns, in place."""
    for number in range(len(spread.points)):
        first, i = spread.first[number], spread.points[number]
        for axis in range(3):
            by = 0.0
            for k in range(ABREAST):
                by += spread.share[number, k] * ways[first + k, axis]
            here[i, axis] += by
