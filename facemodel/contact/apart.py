"""Lips that a pose puts into each other part, as wholes and then point by point."""

from __future__ import annotations

import numpy as np

from facemodel.contact.aside import bring_aside, corners_of, depths_aside
from facemodel.contact.lips import (
    LipPair,
    LipReading,
    bring_apart,
    part_lips,
    spared_at_rest,
)
from facemodel.contact.pierced import bring_out, depths
from facemodel.contact.relief import Grid
from fem.types import BoolArray, Float32Array, FloatArray

PRESSED = 2.0
"""Millimetres of overlap from which on nothing is left to be as it is at rest: pressed lips lie flat on each other."""


class Lips:
    """Keeps the lips of a face from going through each other.

    Parameters
    ----------
    pair : of the face
    rest : (n, 3) points of the site at rest
    """

    def __init__(self, pair: LipPair, rest: Float32Array) -> None:
        self._pair = pair
        high, low = pair.overlaps(rest)
        self._resting = np.maximum(high, 0.0), np.maximum(low, 0.0)
        self._spared = spared_at_rest(rest, pair.axes, pair.upper, pair.lower)
        reading, near = pair.read(rest), np.ones(len(rest), dtype=np.bool_)
        self._deep = (
            depths(reading.points, reading.grid, pair.upper, pair.lower, near),
            depths(reading.points, reading.grid, pair.lower, pair.upper, near),
        )
        self._corners = corners_of(pair, rest)
        self._behind = depths_aside(rest, pair.axes, self._corners)

    def part(self, here: Float32Array) -> tuple[float, LipReading | None]:
        """Part the lips of posed points (n, 3) as wholes, in place.

        Returned are how deep they were in each other, and how they stand, unless that is to be read anew.
        """
        pair = self._pair
        deepest, moved, reading = part_lips(here, pair.axes, pair.upper, pair.lower, *self._resting)
        return deepest, None if moved else reading

    def read(self, here: Float32Array) -> LipReading:
        """How the lips stand on posed points (n, 3)."""
        return self._pair.read(here)

    def keep_apart(self, here: Float32Array, reading: LipReading, deepest: float) -> BoolArray:
        """Bring what is still beyond the face between the lips onto it, in place, point by point.

        Returned are the points (n,) that are next to the other lip.

        Parameters
        ----------
        reading : how the lips stand
        deepest : how far they were in each other before they were parted
        """
        pair, near = self._pair, np.zeros(len(here), dtype=np.bool_)
        high, low = _still(self._spared, deepest)
        bring_apart(here, pair.axes, pair.upper, pair.lower, reading, high, low, near)
        return near

    def bring_out(self, here: Float32Array, grid: Grid, near: BoolArray, deepest: float) -> float:
        """Bring points that are in a triangle of the other lip out of it, in place; how far one went at most.

        Parameters
        ----------
        grid : over width and depth
        near : (n,) which are next to the other lip
        deepest : how far the lips were in each other before they were parted
        """
        pair = self._pair
        high, low = _still(self._deep, deepest)
        return bring_out(here, pair.axes, grid, pair.upper, pair.lower, near, high, low)

    def bring_aside(self, here: Float32Array, near: BoolArray, deepest: float) -> None:
        """Bring points in the corners that are right behind skin of the other lip back to it, in place.

        Parameters
        ----------
        near : (n,) which are next to the other lip
        deepest : how far the lips were in each other before they were parted
        """
        bring_aside(here, self._pair.axes, self._corners, near, _left(deepest) * self._behind)


def _left(deepest: float) -> float:
    """The share that is left of how points rest when lips were so deep in each other."""
    return 1 - min(deepest / PRESSED, 1.0)


def _still(resting: tuple[FloatArray, FloatArray], deepest: float) -> tuple[FloatArray, FloatArray]:
    """What is left of how points rest when lips were so deep in each other."""
    share = _left(deepest)
    return share * resting[0], share * resting[1]
