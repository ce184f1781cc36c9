"""What a lip is to the other one: its skin as a height over width and depth of the mouth, on an even grid.

Heights are those of a lip whose free side looks down: a lower lip is taken upside down.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.grid import beside, between
from facemodel.smooth import smooth_share
from fem.types import Float32Array, FloatArray, IntArray

WIDTHS, DEPTHS = 80, 56
"""Places of the grid across and from back to front: so near that crumpled lips are seen, too."""

FAR = 1e3
"""Millimetres; where there is no lip at all it is so far away."""

STEEP = 4.0
"""How steeply a lip rises at most, towards its edges and beyond them: what comes from the side meets it little by
little.  A lip that stands more upright counts as thicker by a fraction of a millimetre."""

ON = 12.0
"""Millimetres over which a lip goes on level into the mouth from where its skin ends."""

UPRIGHT, LEVEL = 0.1, 0.4
"""Share of a triangle that is seen from above up to which it does not meet the other lip, and from which on it does."""

AWAY = 10.0
"""Millimetres by which what does not meet it is taken back."""

ROWS = 8
"""Rows of the grid that are gone along side by side, so that none waits for what was just written."""

ON_EDGE = -1e-6
"""Twice the part of a triangle across from a corner, in cells of the grid, from which on a place is on the triangle:
neighbours leave none out."""


class Grid(NamedTuple):
    """An even grid over width and depth.

    Attributes
    ----------
    left, back : its first place
    wide, deep : steps from place to place
    """

    left: float
    back: float
    wide: float
    deep: float


@compiled
def place_points(here: Float32Array, middle: FloatArray, axes: FloatArray, places: FloatArray) -> None:
    """Write places (n, 3) along, above and before the middle of a slit of points (n, 3)."""
    for i in range(len(here)):
        x, y, z = here[i, 0] - middle[0], here[i, 1] - middle[1], here[i, 2] - middle[2]
        for axis in range(3):
            places[i, axis] = axes[axis, 0] * x + axes[axis, 1] * y + axes[axis, 2] * z


@compiled
def common_grid(places: FloatArray, upper: IntArray, lower: IntArray) -> Grid:
    """A grid over what some points of both lips share in width, and over the depth of both."""
    low, high = np.full((2, 2), 1e9), np.full((2, 2), -1e9)
    for side, points in enumerate((upper, lower)):
        for i in points:
            for k in range(2):
                value = places[i, 2 * k]
                low[side, k], high[side, k] = min(low[side, k], value), max(high[side, k], value)
    left, right = max(low[0, 0], low[1, 0]), min(high[0, 0], high[1, 0])
    back, front = min(low[0, 1], low[1, 1]), max(high[0, 1], high[1, 1])
    wide, deep = max(right - left, 1.0) / (WIDTHS - 1), max(front - back, 1.0) / (DEPTHS - 1)
    return Grid(left, back, wide, deep)


class OnGrid(NamedTuple):
    """Points on a grid.

    Attributes
    ----------
    u, v : (n,) steps from its first place across and forwards
    height : (n,) above the middle of the mouth, millimetres
    """

    u: FloatArray
    v: FloatArray
    height: FloatArray


@compiled
def on_grid(places: FloatArray, grid: Grid) -> OnGrid:
    """Points (n, 3) along, above and before the middle of the mouth, on a grid."""
    count = len(places)
    u, v, height = np.empty(count), np.empty(count), np.empty(count)
    per_wide, per_deep = 1 / grid.wide, 1 / grid.deep
    for i in range(count):
        u[i] = (places[i, 0] - grid.left) * per_wide
        v[i] = (places[i, 2] - grid.back) * per_deep
        height[i] = places[i, 1]
    return OnGrid(u, v, height)


@compiled
def raise_relief(
    points: OnGrid, triangles: IntArray, rim: IntArray, sign: float, grid: Grid, heights: FloatArray
) -> None:
    """Write the lowest heights (A, D) of a lip on a grid.

    Parameters
    ----------
    points : about the mouth
    triangles : (T, 3) of the lip
    rim : (E, 2) edges at which its skin ends within the mouth
    sign : 1 of the upper lip, -1 of the lower one
    """
    heights[:] = FAR
    u, v, h = points.u, points.v, points.height
    # Those that matter are found first, all alike, since a processor guesses badly which ones they are.
    chosen, count = np.empty(len(triangles), np.int64), 0
    for t in range(len(triangles)):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        chosen[count] = t
        count += int(_seen(u[a], u[b], u[c], v[a], v[b], v[c], sign, heights))
    for t in chosen[:count]:
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        _lay(u[a], u[b], u[c], v[a], v[b], v[c], sign * h[a], sign * h[b], sign * h[c], sign, grid, heights)
    on = ON / grid.deep
    for e in range(len(rim)):
        # In the order in which what goes on from the rim looks to where the lip does.
        a, b = (rim[e, 1], rim[e, 0]) if sign > 0 else (rim[e, 0], rim[e, 1])
        one, other = sign * h[a], sign * h[b]
        _lay(u[a], u[b], u[a], v[a], v[b], v[a] - on, one, other, one, sign, grid, heights)
        _lay(u[b], u[b], u[a], v[b], v[b] - on, v[a] - on, other, other, one, sign, grid, heights)
    _lean(grid, heights)


@compiled
def _places(a: float, b: float, c: float, count: int) -> tuple[float, float]:
    """The first and the last of so many places of the grid between three steps; the last before the first if none."""
    return max(np.ceil(min(a, b, c)), 0.0), min(np.floor(max(a, b, c)), count - 1.0)


@compiled
def _seen(
    u0: float, u1: float, u2: float, v0: float, v1: float, v2: float, sign: float, heights: FloatArray
) -> bool:  # fmt: skip
    """Whether a triangle looks to the other lip and is near a place of the grid (A, D)."""
    twice = (u1 - u0) * (v2 - v0) - (u2 - u0) * (v1 - v0)
    (first, last), (low, high) = _places(u0, u1, u2, heights.shape[0]), _places(v0, v1, v2, heights.shape[1])
    return bool((sign * twice > 0.0) & (low <= high) & (first <= last))


@compiled
def _lay(
    u0: float, u1: float, u2: float,
    v0: float, v1: float, v2: float,
    h0: float, h1: float, h2: float,
    sign: float, grid: Grid, heights: FloatArray,
) -> None:  # fmt: skip
    """Lower heights (A, D) to a triangle where it is over a place of the grid, of which u and v are whole numbers."""
    twice = (u1 - u0) * (v2 - v0) - (u2 - u0) * (v1 - v0)
    if sign * twice <= 0.0:
        return
    (first, last), (low, high) = _places(u0, u1, u2, heights.shape[0]), _places(v0, v1, v2, heights.shape[1])
    back = averted(u1 - u0, u2 - u0, v1 - v0, v2 - v0, h1 - h0, h2 - h0, grid)
    across = ((h1 - h0) * (v2 - v0) - (h2 - h0) * (v1 - v0)) / twice
    on = ((h2 - h0) * (u1 - u0) - (h1 - h0) * (u2 - u0)) / twice
    for i in range(int(first), int(last) + 1):
        for k in range(int(low), int(high) + 1):
            u, v = i - u0, k - v0
            b1 = sign * (u * (v2 - v0) - (u2 - u0) * v)
            b2 = sign * ((u1 - u0) * v - u * (v1 - v0))
            met = (b1 >= ON_EDGE) & (b2 >= ON_EDGE) & (b1 + b2 <= sign * twice - ON_EDGE)
            heights[i, k] = min(heights[i, k], h0 + across * u + on * v + back if met else FAR)


@compiled
def averted(
    u1: float, u2: float, v1: float, v2: float, h1: float, h2: float, grid: Grid, upright: float = 1.0
) -> float:
    """Millimetres by which a triangle, given by two of its sides in steps of the grid, recedes.

    In the corners of an open mouth skin stands upright, and no lip is above another one.

    Parameters
    ----------
    upright : share of the slopes that are met otherwise, from which on this one is met
    """
    x, y, z = (
        (h1 * v2 - h2 * v1) * grid.deep,
        (u2 * v1 - u1 * v2) * grid.wide * grid.deep,
        (u1 * h2 - u2 * h1) * grid.wide,
    )
    share = (abs(y) / np.sqrt(x * x + y * y + z * z) - upright * UPRIGHT) / (upright * (LEVEL - UPRIGHT))
    return AWAY * (1.0 - smooth_share(share))


@compiled
def _lean(grid: Grid, heights: FloatArray) -> None:
    """Let no height (A, D) rise by more than `STEEP` from its neighbours.

    The shortest way between two places of the grid goes aslant first, then straight: so all goes from row to row, both
    ways, then along the rows.
    """
    across, on = STEEP * grid.wide, STEEP * grid.deep
    aslant = np.hypot(across, on)
    count = len(heights)
    for i in range(1, count):
        _lower(heights[i], heights[i - 1], across, aslant)
    for i in range(count - 2, -1, -1):
        _lower(heights[i], heights[i + 1], across, aslant)
    for first in range(0, count, ROWS):
        _lower_along(heights[first : first + ROWS], on)


@compiled
def _lower(row: FloatArray, beside: FloatArray, across: float, aslant: float) -> None:
    """Lower a row (D,) to what its neighbour lets it be."""
    last = len(row) - 1
    row[0] = min(row[0], beside[0] + across, beside[1] + aslant)
    for k in range(1, last):
        straight, back, forth = beside[k] + across, beside[k - 1] + aslant, beside[k + 1] + aslant
        height = straight if straight < row[k] else row[k]
        height = back if back < height else height
        row[k] = forth if forth < height else height
    row[last] = min(row[last], beside[last] + across, beside[last - 1] + aslant)


@compiled
def _lower_along(rows: FloatArray, on: float) -> None:
    """Lower some rows (R, D), side by side, to what each place's neighbours in the same row let it be."""
    deep = rows.shape[1]
    for k in range(1, deep):
        for i in range(len(rows)):
            rows[i, k] = min(rows[i, k], rows[i, k - 1] + on)
    for k in range(deep - 2, -1, -1):
        for i in range(len(rows)):
            rows[i, k] = min(rows[i, k], rows[i, k + 1] + on)


@compiled
def height_at(heights: FloatArray, grid: Grid, u: float, v: float) -> float:
    """The height so many steps from the first place of a grid; beside it a lip rises away from there."""
    count, deep = heights.shape
    away = STEEP * (beside(u, count) * grid.wide + beside(v, deep) * grid.deep)
    return between(heights, u, v) + away
