"""Lips rest on each other: where a pose puts them into each other, both give way, and the skin around with them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.frame import Axes
from facemodel.contact.laying import COLUMNS
from facemodel.contact.near import mark_corners, mark_kept
from facemodel.contact.relief import (
    DEPTHS,
    WIDTHS,
    Grid,
    OnGrid,
    common_grid,
    height_at,
    on_grid,
    place_points,
    raise_relief,
)
from facemodel.contact.spread import Spread, lift
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

SHARE = 0.5
"""What each lip gives way."""

FLATTENED = 0.25
"""Share of an overlap in which lips flatten against each other rather than give way: they are soft."""

SOFT = 0.6
"""Millimetres that they flatten at most: more than that would crumple a lip that stands steeply on the other one."""

WAYS = 2
"""How often lips give way as a whole: where they have moved to they may meet other parts of each other."""

LEFT = 0.15
"""Millimetres that the second time leaves to each point by itself."""

ROUNDS = 2
"""How often each point is brought back onto its own side: what it meets there has moved, too."""

TOLERATED = 0.04
"""Millimetres that all times but the first leave as they are; less than the skin between the lips."""

SKIN = 0.05
"""Millimetres between each lip and the face between them: what is drawn is flat from point to point."""


class Lip(NamedTuple):
    """One lip, in numbers of the points about the mouth.

    Attributes
    ----------
    sign : 1 of the upper lip, -1 of the lower one
    kept : (m,) points that are kept on their own side
    hold : (m,) how far they are, from 0 to 1: less and less where skin begins that goes where it will
    skin : from which of them on they are skin; those before are of the lining
    column : (m,) which column each of them is nearest to
    triangles : (T, 3) drawn of it, of which its relief is made
    met : (U, 3) those and what is in the corners, where lips are one piece of skin
    corners : (b,) points of these, of which no relief tells how near the other lip is
    rim : (E, 2) edges at which its skin ends within the mouth
    spread : how the points go with the columns where the lips part; nothing at the corners, which are of both
    whole : the same where both lips go the same way
    """

    sign: float
    kept: IntArray
    hold: FloatArray
    skin: int
    column: IntArray
    triangles: IntArray
    met: IntArray
    corners: IntArray
    rim: IntArray
    spread: Spread
    whole: Spread


class LipPair:
    """Both lips of a mouth.

    Parameters
    ----------
    axes : of the mouth
    upper, lower : its lips
    """

    def __init__(self, axes: Axes, upper: Lip, lower: Lip) -> None:
        self.axes, self.upper, self.lower = axes, upper, lower

    def read(self, here: Float32Array) -> LipReading:
        """How the lips stand on posed points (n, 3)."""
        return read_lips(here, self.axes, self.upper, self.lower)

    def overlaps(self, here: Float32Array) -> tuple[FloatArray, FloatArray]:
        """How far the kept points (m,) of both lips are in the other one; below zero where they are apart."""
        return overlaps_of(here, self.axes, self.upper, self.lower)

    def part(self, here: Float32Array, rise: FloatArray, fall: FloatArray) -> None:
        """Move the upper lip up and the lower one down by ways (I,) of their columns, in place."""
        lift(here, self.upper.spread, rise, self.axes.axes[1])
        lift(here, self.lower.spread, fall, -self.axes.axes[1])

    def keep_apart(self, here: Float32Array, high: FloatArray, low: FloatArray) -> None:
        """Bring points that are beyond the face between the lips, by more than is spared of both, onto it, in place."""
        near = np.zeros(len(here), dtype=np.bool_)
        bring_apart(here, self.axes, self.upper, self.lower, self.read(here), high, low, near)


class LipReading(NamedTuple):
    """How the lips stand in a pose.

    Attributes
    ----------
    points : about the mouth, on the grid
    over, under : (A, D) reliefs of the upper and of the lower lip
    grid : on which they are given
    """

    points: OnGrid
    over: FloatArray
    under: FloatArray
    grid: Grid


@compiled
def read_lips(here: Float32Array, axes: Axes, upper: Lip, lower: Lip) -> LipReading:
    """How lips stand on posed points (n, 3)."""
    places = np.empty((len(here), 3))
    place_points(here, axes.middle, axes.axes, places)
    grid = common_grid(places, upper.kept, lower.kept)
    points = on_grid(places, grid)
    over, under = np.empty((WIDTHS, DEPTHS)), np.empty((WIDTHS, DEPTHS))
    raise_relief(points, upper.triangles, upper.rim, upper.sign, grid, over)
    raise_relief(points, lower.triangles, lower.rim, lower.sign, grid, under)
    return LipReading(points, over, under, grid)


@compiled
def overlaps_of(here: Float32Array, axes: Axes, upper: Lip, lower: Lip) -> tuple[FloatArray, FloatArray]:
    """See `LipPair.overlaps`."""
    reading = read_lips(here, axes, upper, lower)
    return _overlap(reading, upper, reading.under), _overlap(reading, lower, reading.over)


@compiled
def _overlap(reading: LipReading, lip: Lip, other: FloatArray) -> FloatArray:
    """How far the kept points (m,) of a lip are in the other one, of which the relief is given."""
    found, points = np.empty(len(lip.kept)), reading.points
    for number, i in enumerate(lip.kept):
        there = height_at(other, reading.grid, points.u[i], points.v[i])
        found[number] = -(there + lip.sign * points.height[i])
    return found


@compiled
def _beyond(reading: LipReading, lip: Lip, own: FloatArray, other: FloatArray) -> FloatArray:
    """How far the kept points (m,) of a lip are beyond the face between both, or beyond the other one where it is off.

    The face lies halfway where the lips are in each other.
    """
    found, points = np.empty(len(lip.kept)), reading.points
    for number, i in enumerate(lip.kept):
        u, v = points.u[i], points.v[i]
        there = height_at(other, reading.grid, u, v)
        gap = height_at(own, reading.grid, u, v) + there
        found[number] = SKIN + min(gap, 0.0) / 2 - (there + lip.sign * points.height[i])
    return found


@compiled
def spared_at_rest(rest: Float32Array, axes: Axes, upper: Lip, lower: Lip) -> tuple[FloatArray, FloatArray]:
    """How far the kept points of both lips are beyond the face between them at rest, which is left so."""
    reading = read_lips(rest, axes, upper, lower)
    one = np.maximum(_beyond(reading, upper, reading.over, reading.under), 0.0)
    other = np.maximum(_beyond(reading, lower, reading.under, reading.over), 0.0)
    return one, other


@compiled
def _ways(overlap: FloatArray, resting: FloatArray, lip: Lip) -> FloatArray:
    """How much farther than at rest each column (I,) of a lip is in the other one at most."""
    ways = np.zeros(COLUMNS)
    for number in range(len(overlap)):
        column = lip.column[number]
        ways[column] = max(ways[column], lip.hold[number] * (overlap[number] - resting[number]))
    return ways


@compiled
def part_lips(
    here: Float32Array, axes: Axes, upper: Lip, lower: Lip, resting_high: FloatArray, resting_low: FloatArray
) -> tuple[float, bool, LipReading]:
    """See `apart.Lips.part`; how far the points of both lips rest in each other is given.

    Whether any was moved since they were read is returned, too.
    """
    deepest, moved = 0.0, False
    left_over, left_under = np.zeros(COLUMNS), np.zeros(COLUMNS)
    reading = read_lips(here, axes, upper, lower)
    for turn in range(WAYS):
        if moved:
            reading = read_lips(here, axes, upper, lower)
            moved = False
        rise = _ways(_overlap(reading, upper, reading.under), resting_high, upper)
        fall = _ways(_overlap(reading, lower, reading.over), resting_low, lower)
        if turn == 0:
            deepest = max(rise.max(), fall.max())
            left_over, left_under = np.minimum(FLATTENED * rise, SOFT), np.minimum(FLATTENED * fall, SOFT)
        rise, fall = np.maximum(rise - left_over, 0.0), np.maximum(fall - left_under, 0.0)
        if not (rise.any() or fall.any()):
            break
        lift(here, upper.spread, SHARE * rise, axes.axes[1])
        lift(here, lower.spread, SHARE * fall, -axes.axes[1])
        left_over, left_under = left_over + LEFT, left_under + LEFT
        moved = True
    return deepest, moved, reading


@compiled
def bring_apart(
    here: Float32Array,
    axes: Axes,
    upper: Lip,
    lower: Lip,
    reading: LipReading,
    high: FloatArray,
    low: FloatArray,
    near: BoolArray,
) -> None:
    """Move the points of both lips that are beyond the face between them onto it, in place; mark which are near it."""
    left = 0.0
    for turn in range(ROUNDS):
        one = _beyond(reading, upper, reading.over, reading.under) - high - left
        other = _beyond(reading, lower, reading.under, reading.over) - low - left
        moved = _bring_back(here, upper, one, axes)
        moved = _bring_back(here, lower, other, axes) or moved
        mark_kept(near, upper.kept, one)
        mark_kept(near, lower.kept, other)
        mark_corners(near, reading.points, upper.corners, lower.corners)
        if not moved or turn == ROUNDS - 1:
            break
        left = TOLERATED
        reading = read_lips(here, axes, upper, lower)


@compiled
def _bring_back(here: Float32Array, lip: Lip, beyond: FloatArray, axes: Axes) -> bool:
    """Move the kept points of a lip by what they are beyond (m,), in place; whether any is."""
    moved = False
    for number, i in enumerate(lip.kept):
        by = lip.hold[number] * beyond[number]
        if by > 0.0:
            moved = True
            for axis in range(3):
                here[i, axis] += lip.sign * by * axes.axes[1, axis]
    return moved
