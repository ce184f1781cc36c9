"""The lids of an eye as they stand in a pose: where the columns of both are along their slit, and how far apart."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.spread import Spread, gone_with
from fem.types import Float32Array, FloatArray, IntArray


class Round(NamedTuple):
    """Things go up round an eyeball, about the axis through its centre from corner to corner of the lids.

    Attributes
    ----------
    centre : (3,) of the eyeball
    radius : of it, millimetres
    axes : (3, 3) unit vectors to the left corner, up and forward
    """

    centre: FloatArray
    radius: float
    axes: FloatArray

    def along(self, points: FloatArray) -> FloatArray:
        """Millimetres towards the left corner, of points (..., 3)."""
        return np.asarray((points - self.centre) @ self.axes[0])


class Lid(NamedTuple):
    """One side of a slit.

    Attributes
    ----------
    sign : 1 of the upper one, -1 of the lower one
    starts, points, shares : the places of its columns, one after the other, as rows of a sparse matrix
    spread : how the points go with the columns
    kept : (k,) points that are kept on their own side
    """

    sign: float
    starts: IntArray
    points: IntArray
    shares: FloatArray
    spread: Spread
    kept: IntArray


class Reading(NamedTuple):
    """How the sides of a slit stand in a pose.

    Attributes
    ----------
    at, lower_at : (I,) where the columns of each side are along the slit, in increasing order
    upper : (I,) height of the upper side, millimetres on the eyeball
    lower : (I,) height of the lower side below it
    """

    at: FloatArray
    lower_at: FloatArray
    upper: FloatArray
    lower: FloatArray


class LidColumns(NamedTuple):
    """The columns of a slit and what goes with them, on the n points of a site.

    Attributes
    ----------
    round : about what they turn
    upper, lower : its sides
    columns : how many, I
    """

    round: Round
    upper: Lid
    lower: Lid
    columns: int


class Spared(NamedTuple):
    """How far the sides of a slit are in each other at rest, which is left as it is, millimetres.

    Attributes
    ----------
    upper, lower : of each point that is kept on its side
    columns : (I,) of the columns
    """

    upper: FloatArray
    lower: FloatArray
    columns: FloatArray


@compiled
def gap_of(reading: Reading) -> FloatArray:
    """How far (I,) the sides are apart; below zero where they are in each other."""
    return reading.upper - reading.lower


@compiled
def _place(here: Float32Array, about: Round, lid: Lid, row: int) -> tuple[float, float]:
    """Where one place of the columns is along the slit, and how high."""
    x = y = z = 0.0
    for k in range(lid.starts[row], lid.starts[row + 1]):
        i, share = lid.points[k], lid.shares[k]
        x, y, z = x + share * here[i, 0], y + share * here[i, 1], z + share * here[i, 2]
    return _coordinates(about, x, y, z)


@compiled
def _coordinates(about: Round, x: float, y: float, z: float) -> tuple[float, float]:
    """How far along and how high a place is; on the eyeball, so that a margin that points at its centre is level."""
    x, y, z = x - about.centre[0], y - about.centre[1], z - about.centre[2]
    axes = about.axes
    along = axes[0, 0] * x + axes[0, 1] * y + axes[0, 2] * z
    up = axes[1, 0] * x + axes[1, 1] * y + axes[1, 2] * z
    forward = axes[2, 0] * x + axes[2, 1] * y + axes[2, 2] * z
    return along, about.radius * np.arctan2(up, forward)


@compiled
def _side(here: Float32Array, about: Round, lid: Lid, count: int, ends: bool) -> tuple[FloatArray, FloatArray]:
    """Where (I,) the columns of a side are, in order, and how high: at their ends, or nearest to the other."""
    samples = (len(lid.starts) - 1) // count
    at, height = np.empty(count), np.empty(count)
    for column in range(count):
        at[column], height[column] = _place(here, about, lid, (column + 1) * samples - 1)
        if not ends:
            for sample in range(samples - 1):
                along, high = _place(here, about, lid, column * samples + sample)
                if lid.sign * high < lid.sign * height[column]:
                    at[column], height[column] = along, high
        if column > 0:
            at[column] = max(at[column], at[column - 1])
    return at, height


@compiled
def read_lids(here: Float32Array, lids: LidColumns, ends: bool) -> Reading:
    """How the sides stand on posed points (n, 3): where their columns end, or where they come nearest to each other."""
    at, over = _side(here, lids.round, lids.upper, lids.columns, ends)
    lower_at, under = _side(here, lids.round, lids.lower, lids.columns, ends)
    return Reading(at, lower_at, over, np.interp(at, lower_at, under))


@compiled
def part_lids(here: Float32Array, lids: LidColumns, reading: Reading, up: FloatArray, down: FloatArray) -> None:
    """Move the upper side up and the lower one down by millimetres (I,) at the upper side's columns, in place."""
    _turn(here, lids.round, lids.upper.spread, up)
    _turn(here, lids.round, lids.lower.spread, -np.interp(reading.lower_at, reading.at, down))


@compiled
def keep_lids_apart(here: Float32Array, lids: LidColumns, reading: Reading, spared: Spared) -> None:
    """Bring what is still beyond the line midway between the sides back onto it, in place.

    Where the sides are apart each may go up to the other one.

    Parameters
    ----------
    spared : how far points may be beyond it, as they are at rest
    """
    for side, allowed in ((lids.upper, spared.upper), (lids.lower, spared.lower)):
        beyond = _beyond(here, lids.round, side, reading) - allowed
        _turn_points(here, lids.round, side.kept, side.sign * np.maximum(beyond, 0.0))


@compiled
def spared_at(rest: Float32Array, lids: LidColumns, reading: Reading) -> Spared:
    """How far the points of both sides are beyond the line between them at rest (n, 3)."""
    upper = np.maximum(_beyond(rest, lids.round, lids.upper, reading), 0.0)
    lower = np.maximum(_beyond(rest, lids.round, lids.lower, reading), 0.0)
    return Spared(upper, lower, np.maximum(-gap_of(reading), 0.0))


@compiled
def _turn_point(here: Float32Array, about: Round, i: int, by: float) -> None:
    """Move a point up by millimetres on the eyeball; it keeps its distance from the axis."""
    axes = about.axes
    x, y, z = here[i, 0] - about.centre[0], here[i, 1] - about.centre[1], here[i, 2] - about.centre[2]
    high = axes[1, 0] * x + axes[1, 1] * y + axes[1, 2] * z
    far = axes[2, 0] * x + axes[2, 1] * y + axes[2, 2] * z
    sine, less = np.sin(by / about.radius), np.cos(by / about.radius) - 1
    up, forward = less * high + sine * far, less * far - sine * high
    for axis in range(3):
        here[i, axis] += up * axes[1, axis] + forward * axes[2, axis]


@compiled
def _turn(here: Float32Array, about: Round, spread: Spread, ways: FloatArray) -> None:
    """Move points (n, 3) up with ways (I,) of the columns, in place."""
    for number in range(len(spread.points)):
        by = gone_with(spread, ways, number)
        if by != 0.0:
            _turn_point(here, about, spread.points[number], by)


@compiled
def _turn_points(here: Float32Array, about: Round, points: IntArray, ways: FloatArray) -> None:
    """Move some of the points (n, 3) up, each by its own way, in place."""
    for number, i in enumerate(points):
        if ways[number] != 0.0:
            _turn_point(here, about, i, ways[number])


@compiled
def _beyond(here: Float32Array, about: Round, lid: Lid, reading: Reading) -> FloatArray:
    """How far (k,) the kept points of a side are beyond the line between the sides; below zero on their own side."""
    line = np.empty(len(reading.at))
    for column in range(len(line)):
        free = max(reading.upper[column] - reading.lower[column], 0.0) / 2
        line[column] = (reading.upper[column] + reading.lower[column]) / 2 - lid.sign * free
    at, height = np.empty(len(lid.kept)), np.empty(len(lid.kept))
    for number, i in enumerate(lid.kept):
        at[number], height[number] = _coordinates(about, here[i, 0], here[i, 1], here[i, 2])
    return lid.sign * (np.interp(at, reading.at, line) - height)
