"""Columns across a slit of the skin: in each the profile of the upper and of the lower lip or lid, as they are posed.

A column is found once, where a plane across the slit cuts the surface at rest: a chain of places on edges of triangles
that starts at the edge of the slit.  It is a line of the skin, and goes wherever the skin goes.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from fem.types import BoolArray, Float32Array, FloatArray, IntArray

Crossing = tuple[int, int]
"""An edge of triangles that a plane cuts, smaller point first."""


@dataclass(frozen=True, eq=False)
class Sheet:
    """A surface that columns run over.

    Attributes
    ----------
    points : (P, 3) at rest
    triangles : (T, 3) only those that a column may run over
    first : number of its first point among those that are posed
    edge : (n,) points of the slit's edge in order, from which the columns start
    reach : millimetres that they run from there
    samples : places on each
    """

    points: FloatArray
    triangles: IntArray
    first: int
    edge: IntArray
    reach: float
    samples: int


@dataclass(frozen=True, eq=False)
class Columns:
    """Profiles on one side of a slit.

    Attributes
    ----------
    operator : (I J, L) from the posed points to the places on I columns, J on each
    count : I
    """

    operator: csr_array
    count: int

    def places(self, posed: Float32Array) -> Float32Array:
        """The places (I, J, 3) on posed points (L, 3)."""
        return np.asarray(self.operator @ posed, dtype=np.float32).reshape(self.count, -1, 3)


def trace(sheet: Sheet, heights: Sequence[FloatArray], total: int) -> tuple[Columns, IntArray]:
    """Columns where surfaces cut a sheet.

    Parameters
    ----------
    heights : (P,) of the sheet's points over each of the surfaces, along the slit
    total : L, of all points that are posed

    Returns
    -------
    columns : of those surfaces that cut the edge of the slit
    kept : (i,) their numbers
    """
    runs = [_run(sheet, height) for height in heights]
    places = [place for run in runs if run is not None for place in run]
    rows = [row for row, place in enumerate(places) for _ in place]
    columns = [point for place in places for point, _ in place]
    values = np.array([share for place in places for _, share in place], dtype=np.float32)
    operator = csr_array((values, (rows, columns)), shape=(len(places), total))
    kept = [number for number, run in enumerate(runs) if run is not None]
    return Columns(operator, len(kept)), np.array(kept, dtype=np.int64)


def _run(sheet: Sheet, height: FloatArray) -> list[list[tuple[int, float]]] | None:
    """The sampled chain along which a plane cuts a sheet, each place as points and shares; none if it misses its edge.

    Parameters
    ----------
    height : (P,) of the points over the plane
    """
    above = height >= 0
    neighbours = _links(sheet.triangles, above)
    start = _start(sheet.edge, above)
    if start is None or start not in neighbours:
        return None
    chain, seen = [start], {start}
    places = [_place(start, height, sheet.points)]
    length = [0.0]
    while length[-1] < sheet.reach:
        onward = [each for each in neighbours[chain[-1]] if each not in seen]
        if not onward:
            break
        chain.append(onward[0])
        seen.add(onward[0])
        places.append(_place(onward[0], height, sheet.points))
        length.append(length[-1] + float(np.linalg.norm(places[-1] - places[-2])))
    return _sampled(sheet, chain, height, np.array(length))


def _links(triangles: IntArray, above: BoolArray) -> dict[Crossing, list[Crossing]]:
    """For every edge that is cut the edges that are cut in the same triangle."""
    links: dict[Crossing, list[Crossing]] = defaultdict(list)
    inside = above[triangles]
    cut = inside.any(axis=1) & ~inside.all(axis=1)
    for corners, over in zip(triangles[cut].tolist(), inside[cut].tolist(), strict=True):
        one, other = [
            (min(corners[k], corners[(k + 1) % 3]), max(corners[k], corners[(k + 1) % 3]))
            for k in range(3)
            if over[k] != over[(k + 1) % 3]
        ]
        links[one].append(other)
        links[other].append(one)
    return links


def _start(edge: IntArray, above: BoolArray) -> Crossing | None:
    """Where a plane cuts the edge of a slit; of several places the middle one."""
    cut = np.flatnonzero(above[edge[:-1]] != above[edge[1:]])
    if len(cut) == 0:
        return None
    k = int(cut[len(cut) // 2])
    one, other = int(edge[k]), int(edge[k + 1])
    return min(one, other), max(one, other)


def _share(crossing: Crossing, height: FloatArray) -> float:
    """How far from its first to its second point an edge is cut."""
    one, other = crossing
    return float(height[one] / (height[one] - height[other]))


def _place(crossing: Crossing, height: FloatArray, points: FloatArray) -> FloatArray:
    share = _share(crossing, height)
    return np.asarray(points[crossing[0]] * (1 - share) + points[crossing[1]] * share)


def _sampled(
    sheet: Sheet, chain: list[Crossing], height: FloatArray, length: FloatArray
) -> list[list[tuple[int, float]]]:
    """Evenly spaced places on a chain; one that is shorter than the reach ends in several places at its end."""
    made = []
    for at in np.linspace(0.0, sheet.reach, sheet.samples):
        k = int(np.clip(np.searchsorted(length, at) - 1, 0, max(len(chain) - 2, 0)))
        step = length[k + 1] - length[k] if len(chain) > 1 else 1.0
        along = float(np.clip((at - length[k]) / step, 0.0, 1.0)) if step > 0 else 0.0
        place = []
        for crossing, share in ((chain[k], 1 - along), (chain[min(k + 1, len(chain) - 1)], along)):
            cut = _share(crossing, height)
            place += [(sheet.first + crossing[0], share * (1 - cut)), (sheet.first + crossing[1], share * cut)]
        made.append(place)
    return made
