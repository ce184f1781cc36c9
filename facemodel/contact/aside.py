"""What stands upright in the corners of a mouth: points of the lower lip behind skin of the upper one beside them.

Lips in contact meet vertically, but where a pursed corner crumples skin may stand so upright that a point is right
behind it while straight above there is none.  Such a point goes back to what is nearest to it.  It is the lower lip
that gets behind the upper one so; that one stays, as nothing is gained where both move.
"""

from __future__ import annotations

import igl
import numpy as np
from scipy.spatial import KDTree

from facemodel.compiled import compiled
from facemodel.contact.frame import Axes
from facemodel.contact.lips import LipPair
from facemodel.contact.nearest import LEFT, REACH, Corners, Nearest, nearest_of
from facemodel.smooth import smooth, smooth_share
from fem.types import BoolArray, Float32Array, FloatArray

CORNER, END = (0.8, 0.87), (0.94, 0.97)
"""Shares of half the mouth between which points are met aside, each fading in or out: at the end lips are one skin."""

CLOSE = (1.2, 1.8)
"""Millimetres from the other lip at rest up to which points get behind it, and from where on none does."""

AROUND = 1.7
"""Millimetres from such points at rest within which skin of the other lip may be the nearest to them."""

RIDGE = REACH / 2
"""Millimetres that skin gets behind other skin so at most; what is twice as deep is behind a whole lip, not in it."""

WITHIN = 10.0
"""How many times sooner than at the end of its first triangle skin counts entirely, from the border of a lip on: in the
corners lips end at each other, and a point gets behind the last triangle before."""

SMALLEST = 1.0
"""Millimetres of half a mouth that has no lips to meet."""


def corners_of(pair: LipPair, rest: Float32Array) -> Corners:
    """The corners of the lower lip of a mouth with points (n, 3) at rest."""
    lip, other, along = pair.lower, pair.upper, np.abs(pair.axes.along(rest))
    half = float(along[np.concatenate([lip.met, other.met])].max(initial=SMALLEST))
    away = KDTree(rest[np.unique(other.met)]).query(rest[lip.kept])[0]
    share = along[lip.kept] / half
    hold = lip.hold * smooth(share, *CORNER) * (1 - smooth(share, *END))
    hold *= 1 - smooth(away, *CLOSE)
    points = lip.kept[hold > 0]
    inner = np.ones(len(rest))
    inner[igl.boundary_facets(other.met)[0].ravel()] = 0.0
    triangles = other.met[:0]
    if len(points):
        near = KDTree(rest[points]).query(rest[other.met].mean(axis=1))[0] < CLOSE[1] + AROUND
        triangles = other.met[near]
    return Corners(points, hold[hold > 0], np.ascontiguousarray(triangles), inner)


@compiled
def bring_aside(here: Float32Array, axes: Axes, lip: Corners, near: BoolArray, spared: FloatArray) -> None:
    """Bring points in the corners of the lower lip that are behind skin of the upper one back to it, in place.

    Parameters
    ----------
    here : (n, 3) posed points
    near : (n,) which of them are next to the other lip
    spared : (k,) how deep those of the corners may stay
    """
    nearest = nearest_of(here, axes, lip, near)
    for number, i in enumerate(lip.points):
        by = lip.hold[number] * (depth_of(nearest, number) - max(spared[number], LEFT))
        if by > 0.0:
            share = by / nearest.away[number]
            for axis in range(3):
                here[i, axis] += share * nearest.way[number, axis]


@compiled
def depth_of(nearest: Nearest, number: int) -> float:
    """How far a point is behind the nearest skin of the upper lip, less and less what is too deep for a ridge."""
    if nearest.facing[number] <= 0.0:
        return 0.0
    depth = nearest.away[number]
    inner = min(WITHIN * nearest.inner[number], 1.0)
    return float(depth * inner * (1 - smooth_share(depth / RIDGE - 1)))


@compiled
def depths_aside(here: Float32Array, axes: Axes, lip: Corners) -> FloatArray:
    """How far all points (k,) of the corners are behind the nearest skin of the upper lip."""
    nearest = nearest_of(here, axes, lip, np.ones(len(here), np.bool_))
    found = np.empty(len(lip.points))
    for number in range(len(found)):
        found[number] = depth_of(nearest, number)
    return found
