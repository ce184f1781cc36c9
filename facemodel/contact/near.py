"""Which points of a lip are next to the other one: only those are compared with it triangle by triangle.

The reliefs tell it of points that are kept on their own side.  In the corners, where skin is met that no relief is of,
both lips are looked at from the front: where all of one stands well above all of the other, none of it is near.
"""

from __future__ import annotations

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.relief import WIDTHS, OnGrid
from fem.types import BoolArray, FloatArray, IntArray

NEXT = 1.5
"""Millimetres from the other lip, or from the face between both, within which a point is next to it: crumpled skin
stands out of its relief by less than that."""

BESIDE = 4
"""Steps of the grid to either side in which the other lip counts: as far as a triangle of it reaches."""

NONE = 1e9
"""Millimetres at which a lip is that is not there at all."""


@compiled
def mark_kept(near: BoolArray, kept: IntArray, beyond: FloatArray) -> None:
    """Mark which of all points (n,) are next to the other lip, of those (m,) of which it is known how far beyond."""
    for number, i in enumerate(kept):
        near[i] = beyond[number] > -NEXT


@compiled
def mark_corners(near: BoolArray, points: OnGrid, upper: IntArray, lower: IntArray) -> None:
    """Mark which of all points (n,) are next to the other lip, or may be, of those in the corners of both lips."""
    over, under = _lowest(points, upper, 1.0), _lowest(points, lower, -1.0)
    _mark(near, points, upper, 1.0, under)
    _mark(near, points, lower, -1.0, over)


@compiled
def _lowest(points: OnGrid, lip: IntArray, sign: float) -> FloatArray:
    """How low (A,) a lip comes in each step across, and beside it; a lower one is taken upside down."""
    here, around = np.full(WIDTHS, NONE), np.full(WIDTHS, NONE)
    for i in lip:
        step = _step(points.u[i])
        here[step] = min(here[step], sign * points.height[i])
    for step in range(WIDTHS):
        for beside in range(max(step - BESIDE, 0), min(step + BESIDE + 1, WIDTHS)):
            around[step] = min(around[step], here[beside])
    return around


@compiled
def _mark(near: BoolArray, points: OnGrid, lip: IntArray, sign: float, other: FloatArray) -> None:
    for i in lip:
        near[i] = sign * points.height[i] + other[_step(points.u[i])] < NEXT


@compiled
def _step(u: float) -> int:
    """Which step of the grid a place is in; those beside it are in its outermost ones."""
    return int(min(max(u, 0.0), WIDTHS - 1.0))
