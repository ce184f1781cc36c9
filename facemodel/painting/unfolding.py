"""Straight lines on a triangle mesh: strips of triangles unfolded into the plane of their first one.

A geodesic on a triangle mesh is a straight line in the strip of triangles that it crosses, unfolded.  All lines from a
source that cross the same edges form a window: the source and the part of the last edge that it sees.  Windows are
pushed across one triangle after another, all of one generation at once (Chen and Han 1990; Xin and Wang 2009).
The plane is that of complex numbers, with the source at zero.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facemodel.mesh import Mesh
from fem import edge_topology
from fem.types import FloatArray, IntArray

ComplexArray = NDArray[np.complex128]

SHORTEST = 1e-9
"""Millimetres; keeps the division by the length of an edge defined where two vertices coincide."""


@dataclass(frozen=True, eq=False)
class Strips:
    """What unfolding needs to know of a mesh, by corner ``3 * triangle + k``.

    Attributes
    ----------
    apex : (3 T,) vertex at each corner
    following, preceding : (3 T,) the next and the previous corner of the same triangle
    across : (3 T,) the corner on the other side of the opposite edge, -1 at the rim
    length : (3 T,) length of the opposite edge, millimetres
    shape : (3 T,) complex, the corner in the frame in which the opposite edge runs from 0 to 1
    """

    apex: IntArray
    following: IntArray
    preceding: IntArray
    across: IntArray
    length: FloatArray
    shape: ComplexArray


@dataclass(frozen=True, eq=False)
class Windows:
    """Edges seen from sources.

    Attributes
    ----------
    source : (w,) number of the source
    corner : (w,) corner opposite the edge, on the source's side of it
    right, left : (w,) complex, the ends of the edge from the source, to its right and to its left
    first, last : (w,) complex, directions between which the edge is seen
    """

    source: IntArray
    corner: IntArray
    right: ComplexArray
    left: ComplexArray
    first: ComplexArray
    last: ComplexArray

    def __len__(self) -> int:
        return len(self.source)


def strips(mesh: Mesh) -> Strips:
    """The tables of a mesh."""
    triangles = mesh.triangles
    start = mesh.positions[np.roll(triangles, -1, axis=1).ravel()]
    end = mesh.positions[np.roll(triangles, -2, axis=1).ravel()]
    corner = mesh.positions[triangles.ravel()]
    length = np.maximum(np.linalg.norm(end - start, axis=1), SHORTEST)
    along = (end - start) / length[:, None]
    x = np.einsum("ij,ij->i", corner - start, along)
    y = np.linalg.norm(corner - start - x[:, None] * along, axis=1)
    corners = np.arange(triangles.size).reshape(-1, 3)
    following, preceding = np.roll(corners, -1, axis=1).ravel(), np.roll(corners, -2, axis=1).ravel()
    return Strips(triangles.ravel(), following, preceding, _across(triangles), length, (x + 1j * y) / length)


def _across(triangles: IntArray) -> IntArray:
    edge = edge_topology(triangles)[1].ravel()
    order = np.argsort(edge, kind="stable")
    pair = np.flatnonzero(edge[order][1:] == edge[order][:-1])
    across = np.full(len(edge), -1, dtype=np.int64)
    across[order[pair]] = order[pair + 1]
    across[order[pair + 1]] = order[pair]
    return across


def corner_windows(tables: Strips) -> Windows:
    """From every vertex the edges opposite to it; sources are numbered like vertices."""
    right = -tables.shape * tables.length
    left = (1 - tables.shape) * tables.length
    return Windows(tables.apex, np.arange(len(tables.apex)), right, left, right, left)


def point_windows(tables: Strips, triangle: int, barycentric: FloatArray) -> tuple[Windows, FloatArray]:
    """From a point inside a triangle its three edges, and the distances (3,) of its corners; the source is number 0."""
    corner = 3 * triangle + np.arange(3)
    ends = tables.length[corner[2]] * np.array([0.0, 1.0, tables.shape[corner[2]]])
    ends = ends - barycentric @ ends
    right, left = np.roll(ends, -1), np.roll(ends, -2)
    return Windows(np.zeros(3, dtype=np.int64), corner, right, left, right, left), np.abs(ends)


def unfold(
    tables: Strips, windows: Windows, reach: FloatArray, rings: int = 0
) -> tuple[IntArray, IntArray, FloatArray]:
    """Find the vertices that sources see along straight lines.

    Parameters
    ----------
    tables : of the mesh
    windows : the first edges seen
    reach : by source, millimetres; windows farther away are given up
    rings : as many triangles are crossed whatever the reach

    Returns
    -------
    sources, vertices, distances : (k,) each, what is seen; a pair may come several times
    """
    seen: list[tuple[IntArray, IntArray, FloatArray]] = [(np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0))]
    ring = 0
    while len(windows):
        goes_on = tables.across[windows.corner] >= 0
        if ring >= rings:
            goes_on &= _least_distance(tables, windows) <= reach[windows.source]
        windows, sight = _crossed(tables, windows, np.flatnonzero(goes_on))
        seen.append(sight)
        ring += 1
    sources, vertices, distances = (np.concatenate(column) for column in zip(*seen, strict=True))
    return sources, vertices, distances


def _cross(one: ComplexArray, other: ComplexArray) -> FloatArray:
    return np.asarray((one.conj() * other).imag)


def _least_distance(tables: Strips, windows: Windows) -> FloatArray:
    """What no point of each edge (w,) is nearer to the source than: cheap to find, and short of it by little."""
    farther = np.maximum(np.abs(windows.right), np.abs(windows.left))
    return np.asarray(farther - tables.length[windows.corner])


def _crossed(tables: Strips, old: Windows, keep: IntArray) -> tuple[Windows, tuple[IntArray, IntArray, FloatArray]]:
    """Push some windows across the next triangle: the windows behind it, and the apices that are seen."""
    source, corner = old.source[keep], tables.across[old.corner[keep]]
    right, left, first, last = old.right[keep], old.left[keep], old.first[keep], old.last[keep]
    apex = left + (right - left) * tables.shape[corner]
    past_first, before_last = _cross(first, apex) > 0, _cross(apex, last) > 0
    seen = past_first & before_last
    sight = (source[seen], tables.apex[corner[seen]], np.abs(apex[seen]))
    # To the right of the apex lies the edge opposite the next corner, to its left that opposite the previous one.
    a, b = np.flatnonzero(past_first), np.flatnonzero(before_last)
    windows = Windows(
        np.concatenate([source[a], source[b]]),
        np.concatenate([tables.following[corner[a]], tables.preceding[corner[b]]]),
        np.concatenate([right[a], apex[b]]),
        np.concatenate([apex[a], left[b]]),
        np.concatenate([first[a], np.where(past_first, apex, first)[b]]),
        np.concatenate([np.where(before_last, apex, last)[a], last[b]]),
    )
    return windows, sight
