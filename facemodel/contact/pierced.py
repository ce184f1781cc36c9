"""What the reliefs of two lips are too coarse for: each point of one lip against each triangle of the other one.

In a pursed corner skin crumples into ridges that are narrower than a cell of the grid, and stand out unseen between
its places.  Only what is next to the other lip there is compared so, as it takes longer.
"""

from __future__ import annotations

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.frame import Axes
from facemodel.contact.lips import Lip
from facemodel.contact.relief import DEPTHS, WIDTHS, Grid, OnGrid, averted, on_grid, place_points
from facemodel.smooth import smooth_share
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

BESIDE, SLOPE = 0.2, 4.0
"""Millimetres beside a triangle within which it is met as if it sloped away so steeply, so that no point jumps."""

RIDGE = 1.0
"""Millimetres that a ridge stands out at most; what is twice as deep is no ridge, but other skin that turns back."""

MIDDLE, ASIDE = 0.3, (0.5, 0.8)
"""How much more upright skin is met in the middle of a mouth, where it stands so in another lip alone, and shares of
half the mouth from which on it is met less, and from which on as little as in a corner."""

SHORTEST = 1e-12
"""Square millimetres of an edge that has no length."""

CELL = 2
"""Steps of the grid either way in a cell in which points are looked for: few have more than one point in them."""

LEFT = 0.04
"""Millimetres that are left as they are; less than the skin between the lips."""


@compiled
def bring_out(
    here: Float32Array,
    axes: Axes,
    grid: Grid,
    upper: Lip,
    lower: Lip,
    near: BoolArray,
    high: FloatArray,
    low: FloatArray,
) -> float:
    """Bring the points of both lips that are near out of triangles of the other one, in place.

    Returned is how far one of them went at most.

    Once the upper lip is out of the lower one, it stays so while that one comes out of it: they only move apart.

    Parameters
    ----------
    here : (n, 3) posed points
    grid : over width and depth
    near : (n,) which of the points are next to the other lip
    high, low : (m,) how deep the kept points of both lips may stay
    """
    places = np.empty((len(here), 3))
    place_points(here, axes.middle, axes.axes, places)
    points = on_grid(places, grid)
    far = _bring_out(here, axes, points, grid, upper, lower, near, high)
    return max(_bring_out(here, axes, points, grid, lower, upper, near, low), far)


@compiled
def _bring_out(
    here: Float32Array,
    axes: Axes,
    points: OnGrid,
    grid: Grid,
    lip: Lip,
    other: Lip,
    near: BoolArray,
    spared: FloatArray,
) -> float:
    """The same for one of them; the points on the grid go with it."""
    deep = depths(points, grid, lip, other, near)
    farthest = 0.0
    for number, i in enumerate(lip.kept):
        by = lip.hold[number] * (deep[number] - spared[number] - LEFT)
        if by > 0.0:
            farthest = max(farthest, by)
            points.height[i] += lip.sign * by
            for axis in range(3):
                here[i, axis] += lip.sign * by * axes.axes[1, axis]
    return farthest


@compiled
def depths(points: OnGrid, grid: Grid, lip: Lip, other: Lip, near: BoolArray) -> FloatArray:
    """How far (m,) the kept points of a lip are in the triangles of the other one; 0 where they are in none."""
    found = np.zeros(len(lip.kept))
    first, following = _in_cells(points, lip, near)
    u, v, h, sign = points.u, points.v, points.height, other.sign
    left, back = BESIDE / grid.wide, BESIDE / grid.deep
    for t in range(len(other.met)):
        a, b, c = other.met[t, 0], other.met[t, 1], other.met[t, 2]
        if not (near[a] | near[b] | near[c]):
            continue
        twice = (u[b] - u[a]) * (v[c] - v[a]) - (u[c] - u[a]) * (v[b] - v[a])
        if sign * twice <= 0.0:
            continue
        low, high = _cell(min(u[a], u[b], u[c]) - left, WIDTHS), _cell(max(u[a], u[b], u[c]) + left, WIDTHS)
        rear, fore = _cell(min(v[a], v[b], v[c]) - back, DEPTHS), _cell(max(v[a], v[b], v[c]) + back, DEPTHS)
        top = max(-sign * h[a], -sign * h[b], -sign * h[c])
        for i in range(low, high + 1):
            for k in range(rear, fore + 1):
                number = first[i, k]
                while number >= 0:
                    point = lip.kept[number]
                    if top + sign * h[point] > found[number]:
                        found[number] = max(found[number], _depth(points, point, a, b, c, twice, grid, sign))
                    number = following[number]
    return found


@compiled
def _cell(at: float, count: int) -> int:
    """Which cell a step of so many is in; those beside the grid are in its outermost ones."""
    return int(min(max(at, 0.0), count - 1.0)) // CELL


@compiled
def _in_cells(points: OnGrid, lip: Lip, near: BoolArray) -> tuple[IntArray, IntArray]:
    """The first kept point of a lip (A, D) in each cell of the grid of those that are near, and which follows each."""
    first, following = np.full((WIDTHS // CELL, DEPTHS // CELL), -1), np.empty(len(lip.kept), np.int64)
    for number, i in enumerate(lip.kept):
        if near[i]:
            cell = _cell(points.u[i], WIDTHS), _cell(points.v[i], DEPTHS)
            following[number], first[cell] = first[cell], number
    return first, following


@compiled
def _depth(points: OnGrid, i: int, a: int, b: int, c: int, twice: float, grid: Grid, sign: float) -> float:
    """How far a point is in a triangle of the other lip, straight up or down, or in the slope beside it."""
    u, v, h = points.u, points.v, points.height
    u1, u2, v1, v2, x, y = u[b] - u[a], u[c] - u[a], v[b] - v[a], v[c] - v[a], u[i] - u[a], v[i] - v[a]
    one, two = (x * v2 - u2 * y) / twice, (u1 * y - x * v1) / twice
    if min(one, two, 1.0 - one - two) < 0.0:
        one, two = _on_edge(
            x * grid.wide, y * grid.deep, u1 * grid.wide, v1 * grid.deep, u2 * grid.wide, v2 * grid.deep
        )
    right, front = (x - one * u1 - two * u2) * grid.wide, (y - one * v1 - two * v2) * grid.deep
    h1, h2 = sign * (h[b] - h[a]), sign * (h[c] - h[a])
    height = sign * (h[a] - h[i]) + one * h1 + two * h2 + SLOPE * np.sqrt(right * right + front * front)
    aside = abs(2 * u[i] / (WIDTHS - 1) - 1)
    upright = MIDDLE + (1 - MIDDLE) * smooth_share((aside - ASIDE[0]) / (ASIDE[1] - ASIDE[0]))
    depth = -(height + averted(u1, u2, v1, v2, h1, h2, grid, upright))
    return float(depth * (1 - smooth_share(depth / RIDGE - 1)))


@compiled
def _on_edge(x: float, y: float, x1: float, y1: float, x2: float, y2: float) -> tuple[float, float]:
    """Shares of two corners of a triangle, the other one being the origin, in the place of its edges nearest to one."""
    t = _along(x, y, x1, y1)
    one, two, least = t, 0.0, (x - t * x1) ** 2 + (y - t * y1) ** 2
    t = _along(x, y, x2, y2)
    away = (x - t * x2) ** 2 + (y - t * y2) ** 2
    if away < least:
        one, two, least = 0.0, t, away
    t = _along(x - x1, y - y1, x2 - x1, y2 - y1)
    if (x - x1 - t * (x2 - x1)) ** 2 + (y - y1 - t * (y2 - y1)) ** 2 < least:
        one, two = 1.0 - t, t
    return one, two


@compiled
def _along(x: float, y: float, to_x: float, to_y: float) -> float:
    """Share of a way from the origin that lies abreast of a place."""
    return min(max((x * to_x + y * to_y) / max(to_x * to_x + to_y * to_y, SHORTEST), 0.0), 1.0)
