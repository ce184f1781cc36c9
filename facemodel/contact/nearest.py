"""The skin of one lip that is nearest to points of the other one, in the corners of a mouth, in any direction.

Points are looked for in cells from the middles of triangles: few triangles have any about them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.frame import Axes
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

REACH = 0.8
"""Millimetres from a point within which skin is looked for."""

LEFT = 0.15
"""Millimetres that points may stay behind the nearest skin: half of what lips may be in each other."""

CELL = 0.5
"""Millimetres of a cell in which points are looked for."""

NEXT = 2
"""Cells either way in which a triangle looks for points, from its middle: as far as `REACH` and half its own length."""

CELLS = 30
"""Cells in each direction about a corner; what is farther off is in the last one."""

SAME = 1e-6
"""Millimetres by which two triangles are at the same distance: at an edge or a corner that they share."""

TINY = 1e-30
"""What keeps a triangle without an area from facing anywhere."""


class Corners(NamedTuple):
    """Points in the corners of one lip, and what they meet of the other one.

    Attributes
    ----------
    points : (k,) of that lip
    hold : (k,) how far they are met, from 0 to 1
    triangles : (T, 3) of the other lip
    inner : (n,) of all points, 0 at the border of the other lip, which is nearest to what is beside it, and 1 elsewhere
    """

    points: IntArray
    hold: FloatArray
    triangles: IntArray
    inner: FloatArray


class Nearest(NamedTuple):
    """The skin of the other lip that is nearest to each point; where some is nearer than `LEFT`, any that is.

    Attributes
    ----------
    away : (k,) how far it is, millimetres; `REACH` where it is farther than that
    way : (k, 3) to it
    facing : (k,) how much it looks along that way, from -1 to 1: above 0 the point is behind it
    inner : (k,) 0 where it is at the border of its lip, 1 at the end of its first triangle
    """

    away: FloatArray
    way: FloatArray
    facing: FloatArray
    inner: FloatArray


class Cells(NamedTuple):
    """Points of a lip in cells about both corners of the mouth.

    Attributes
    ----------
    base : (2, 3) where the cells of each corner begin
    first : (2, A, A) the first point at each place up and forward, wherever it is to the side
    following : (k,) the one that follows each
    about : (2, A, A, A) whether there are points in the cells about each
    """

    base: FloatArray
    first: IntArray
    following: IntArray
    about: BoolArray


@compiled
def nearest_of(here: Float32Array, axes: Axes, lip: Corners, near: BoolArray) -> Nearest:
    """What is nearest to the points of a lip that are near the other one, of posed points (n, 3).

    Parameters
    ----------
    near : (n,) which of all points are next to the other lip; only triangles at those are looked at
    """
    count = len(lip.points)
    nearest = Nearest(np.full(count, REACH), np.zeros((count, 3)), np.zeros(count), np.zeros(count))
    cells = _in_cells(here, axes, lip, near)
    for t in range(len(lip.triangles)):
        a, b, c = lip.triangles[t, 0], lip.triangles[t, 1], lip.triangles[t, 2]
        if not (near[a] | near[b] | near[c]):
            continue
        x, y, z = (
            (here[a, 0] + here[b, 0] + here[c, 0]) / 3,
            (here[a, 1] + here[b, 1] + here[c, 1]) / 3,
            (here[a, 2] + here[b, 2] + here[c, 2]) / 3,
        )
        side = int(x > axes.middle[0])
        i, k, m = _cell(x, cells.base[side, 0]), _cell(y, cells.base[side, 1]), _cell(z, cells.base[side, 2])
        if cells.about[side, i, k, m]:
            _meet_about(here, lip, (a, b, c), (x, y, z), cells, (side, i, k, m), nearest)
    return nearest


@compiled
def _cell(at: float, base: float) -> int:
    """Which cell a place is in; those that are farther are in the outermost ones."""
    return int(min(max((at - base) / CELL, 0.0), CELLS - 1.0))


@compiled
def _in_cells(here: Float32Array, axes: Axes, lip: Corners, near: BoolArray) -> Cells:
    """Those points of a lip that are near in cells; none is in the outermost ones."""
    base = np.full((2, 3), 1e9)
    for i in lip.points:
        side = int(here[i, 0] > axes.middle[0])
        for axis in range(3):
            base[side, axis] = min(base[side, axis], here[i, axis] - 2 * NEXT * CELL)
    first, following = np.full((2, CELLS, CELLS), -1), np.empty(len(lip.points), np.int64)
    about = np.zeros((2, CELLS, CELLS, CELLS), np.bool_)
    last = CELLS - 1 - 2 * NEXT
    for number, point in enumerate(lip.points):
        if near[point]:
            side = int(here[point, 0] > axes.middle[0])
            i = min(_cell(here[point, 0], base[side, 0]), last)
            k = min(_cell(here[point, 1], base[side, 1]), last)
            m = min(_cell(here[point, 2], base[side, 2]), last)
            following[number], first[side, k, m] = first[side, k, m], number
            for u in range(i - NEXT, i + NEXT + 1):
                for v in range(k - NEXT, k + NEXT + 1):
                    for w in range(m - NEXT, m + NEXT + 1):
                        about[side, u, v, w] = True
    return Cells(base, first, following, about)


@compiled
def _meet_about(
    here: Float32Array,
    lip: Corners,
    triangle: tuple[int, int, int],
    middle: tuple[float, float, float],
    cells: Cells,
    cell: tuple[int, int, int, int],
    nearest: Nearest,
) -> None:
    """Note a triangle of which middle and cell are given for all points to which it is the nearest so far."""
    x, y, z = middle
    side, _, v, w = cell
    radius = 0.0
    for corner in triangle:
        right, up, front = here[corner, 0] - x, here[corner, 1] - y, here[corner, 2] - z
        radius = max(radius, right * right + up * up + front * front)
    radius = np.sqrt(radius)
    for k in range(v - NEXT, v + NEXT + 1):
        for m in range(w - NEXT, w + NEXT + 1):
            number = cells.first[side, k, m]
            while number >= 0:
                at = lip.points[number]
                right, up, front = here[at, 0] - x, here[at, 1] - y, here[at, 2] - z
                away = nearest.away[number]
                if (right * right + up * up + front * front < (away + radius) ** 2) & (away > LEFT):
                    _meet(here, lip, number, triangle[0], triangle[1], triangle[2], nearest)
                number = cells.following[number]


@compiled
def _meet(here: Float32Array, lip: Corners, number: int, a: int, b: int, c: int, nearest: Nearest) -> None:
    """Note a triangle if it is the nearest to a point so far.

    Of those that share the nearest edge or corner, the one that looks most along the way is right about the side.
    """
    i = lip.points[number]
    x, y, z = here[i, 0] - here[a, 0], here[i, 1] - here[a, 1], here[i, 2] - here[a, 2]
    x1, y1, z1 = here[b, 0] - here[a, 0], here[b, 1] - here[a, 1], here[b, 2] - here[a, 2]
    x2, y2, z2 = here[c, 0] - here[a, 0], here[c, 1] - here[a, 1], here[c, 2] - here[a, 2]
    d1, d2 = x1 * x + y1 * y + z1 * z, x2 * x + y2 * y + z2 * z
    one, two = _closest(x1 * x1 + y1 * y1 + z1 * z1, x1 * x2 + y1 * y2 + z1 * z2, x2 * x2 + y2 * y2 + z2 * z2, d1, d2)
    x, y, z = one * x1 + two * x2 - x, one * y1 + two * y2 - y, one * z1 + two * z2 - z
    away = np.sqrt(x * x + y * y + z * z)
    if not away <= nearest.away[number] + SAME:  # a triangle without an area is nowhere
        return
    nx, ny, nz = y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2
    facing = (nx * x + ny * y + nz * z) / np.sqrt(nx * nx + ny * ny + nz * nz + TINY) / (away + TINY)
    if away > nearest.away[number] - SAME and abs(facing) <= abs(nearest.facing[number]):
        return
    nearest.away[number], nearest.facing[number] = away, facing
    nearest.way[number, 0], nearest.way[number, 1], nearest.way[number, 2] = x, y, z
    nearest.inner[number] = (1 - one - two) * lip.inner[a] + one * lip.inner[b] + two * lip.inner[c]


@compiled
def _closest(aa: float, ab: float, bb: float, pa: float, pb: float) -> tuple[float, float]:
    """The shares of two sides of a triangle that lead from their common corner to its nearest place to a point.

    After Ericson, "Real-Time Collision Detection" (2005), 5.1.5.

    Parameters
    ----------
    aa, ab, bb : products of the sides with each other
    pa, pb : products of the sides with the way from that corner to the point
    """
    if pa <= 0.0 and pb <= 0.0:
        return 0.0, 0.0
    if pa >= aa and pb - ab <= pa - aa:
        return 1.0, 0.0
    if pb >= bb and pa - ab <= pb - bb:
        return 0.0, 1.0
    one, two, whole = bb * pa - ab * pb, aa * pb - ab * pa, aa * bb - ab * ab
    if two <= 0.0 and 0.0 <= pa <= aa:
        return pa / aa, 0.0
    if one <= 0.0 and 0.0 <= pb <= bb:
        return 0.0, pb / bb
    if one + two >= whole:
        share = (pb - ab - pa + aa) / (aa - 2 * ab + bb)
        return 1 - share, share
    return one / whole, two / whole
