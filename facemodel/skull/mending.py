"""Make bone of a mesh that came from elsewhere: welded, closed, turned outside out, and no finer than is of use."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import igl
import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from facemodel.errors import SkullError
from facemodel.mesh import Mesh, submesh
from fem.types import FloatArray, IntArray

FEWEST_TRIANGLES = 200
"""A mesh of fewer triangles has neither orbits nor jaw."""

USEFUL = 30_000
"""Triangles; twice those of the shipped skulls.  Springs end half a centimetre apart, so that more are never felt."""

BEARABLE = 200_000
"""Triangles that can be worked with where they cannot be reduced, since more than two meet at an edge."""

SAME_PLACE = 1e-6
"""Share of the mesh's size within which two corners are one: files in text keep six figures."""

CELL_CODE = np.array([1_000_003**2, 1_000_003, 1])
"""Makes one number of three that go up to a million."""

SPECK = 5e-4
"""Share of the whole surface below which a loose part is a speck, as scans have them; a tooth is ten times that."""

HOLLOW = 5e-3
"""Share of the cube as wide as a mesh that it must enclose; a skull of thin bone encloses some hundredths, an open
sheet next to nothing."""

Told = Callable[[str, float], None]


@dataclass(frozen=True, eq=False)
class Bone:
    """A mesh that can be a skull.

    Attributes
    ----------
    mesh : closed, in the units and axes in which it came
    triangles : how many there were
    specks : loose parts that were left out
    holes : that were closed
    """

    mesh: Mesh
    triangles: int
    specks: int = 0
    holes: int = 0

    @property
    def account(self) -> str:
        """What was done to it, in one sentence."""
        done = [f"{self.triangles:,} triangles".replace(",", " ")]
        if len(self.mesh.triangles) < 0.9 * self.triangles:
            done.append(f"reduced to {len(self.mesh.triangles):,}".replace(",", " "))
        if self.specks:
            done.append(f"{_counted(self.specks, 'speck')} left out")
        if self.holes:
            done.append(f"{_counted(self.holes, 'hole')} closed")
        return ", ".join(done)


def mended(positions: FloatArray, triangles: IntArray, told: Told = lambda _text, _share: None) -> Bone:
    """Bone of raw triangles.

    Parameters
    ----------
    positions : (n, 3) in any unit
    triangles : (t, 3)
    told : of every step and the share that is done

    Raises
    ------
    SkullError
        If nothing that a skull could be is enclosed by it.
    """
    count = len(triangles)
    if not np.isfinite(positions[triangles]).all():
        raise SkullError("has a corner that is nowhere")
    told("Welding corners", 0.3)
    mesh = _welded(positions, triangles)
    if len(mesh.triangles) < FEWEST_TRIANGLES:
        few = _counted(len(mesh.triangles), "triangle")
        raise SkullError(f"has {few} and a skull has at least {FEWEST_TRIANGLES}")
    mesh, specks = _without_specks(mesh)
    told("Closing holes", 0.4)
    mesh, holes = _closed(_turned_alike(mesh))
    _check_encloses(mesh)
    told("Reducing triangles", 0.5)
    return Bone(_reduced(mesh), count, specks, holes)


def _welded(positions: FloatArray, triangles: IntArray) -> Mesh:
    """The mesh with each corner once, and without triangles of no area or that are there twice."""
    used = positions[triangles].reshape(-1, 3)
    size = float(np.ptp(used, axis=0).max(initial=0.0)) or 1.0
    cells = np.round((used - used.min(axis=0, initial=np.inf)) / (SAME_PLACE * size)).astype(np.int64)
    _, first, number = np.unique((cells * CELL_CODE).sum(axis=1), return_index=True, return_inverse=True)
    welded = np.reshape(number, (-1, 3)).astype(np.int64)
    a, b, c = welded.T
    welded = welded[(a != b) & (b != c) & (c != a)]
    low, middle, high = np.sort(welded, axis=1).T
    order = np.lexsort((high, low * len(first) + middle))
    kept = np.ones(len(welded), dtype=np.bool_)
    again = (np.diff(low[order]) == 0) & (np.diff(middle[order]) == 0) & (np.diff(high[order]) == 0)
    kept[order[1:][again]] = False
    return submesh(Mesh(np.ascontiguousarray(used[first]), welded), kept)[0]


def _without_specks(mesh: Mesh) -> tuple[Mesh, int]:
    part = np.asarray(igl.vertex_components(mesh.triangles))[mesh.triangles[:, 0]]
    area = np.bincount(part, np.linalg.norm(mesh.triangle_normals, axis=1))
    specks = (area < SPECK * area.sum()) & (area > 0)
    return (submesh(mesh, ~specks[part])[0], int(specks.sum())) if specks.any() else (mesh, 0)


def _turned_alike(mesh: Mesh) -> Mesh:
    """The mesh with neighbouring triangles turned alike, and all of it outside out."""
    codes = np.sort(_codes(*_directed(mesh), len(mesh.positions)))
    if (np.diff(codes) > 0).all():
        return mesh if _enclosed(mesh).sum() >= 0 else Mesh(mesh.positions, mesh.triangles[:, ::-1].copy())
    alike, patch = igl.bfs_orient(mesh.triangles)
    turned = Mesh(mesh.positions, np.asarray(alike, dtype=np.int64))
    inward = np.bincount(patch, _enclosed(turned)) < 0
    return Mesh(mesh.positions, np.where(inward[patch][:, None], turned.triangles[:, ::-1], turned.triangles))


def _directed(mesh: Mesh) -> tuple[IntArray, IntArray]:
    """Start and end (3 T,) of the edges of all triangles, one way round."""
    return mesh.triangles.ravel(), mesh.triangles[:, [1, 2, 0]].ravel()


def _codes(start: IntArray, end: IntArray, count: int) -> IntArray:
    """One number (n,) for each edge between vertices of so many."""
    return np.asarray(start * count + end)


def _enclosed(mesh: Mesh) -> FloatArray:
    """Volume (T,) between each triangle and the middle of the mesh, below zero where it is turned inwards."""
    centre = mesh.positions.mean(axis=0)
    return np.asarray(((mesh.positions[mesh.triangles[:, 0]] - centre) * mesh.triangle_normals).sum(axis=1) / 6)


def _closed(mesh: Mesh) -> tuple[Mesh, int]:
    """The mesh with a fan in every hole."""
    start, end = _directed(mesh)
    codes, opposite = _codes(start, end, len(mesh.positions)), np.sort(_codes(end, start, len(mesh.positions)))
    open_ = opposite[np.minimum(np.searchsorted(opposite, codes), len(codes) - 1)] != codes
    rim = np.column_stack([start[open_], end[open_]])
    if not len(rim):
        return mesh, 0
    vertices, ends = np.unique(rim, return_inverse=True)
    ends = np.reshape(ends, (-1, 2))
    graph = coo_array((np.ones(len(ends)), tuple(ends.T)), shape=(len(vertices), len(vertices)))
    holes, hole = connected_components(graph, directed=False)
    sums = np.column_stack([np.bincount(hole, mesh.positions[vertices, k]) for k in range(3)])
    centres = sums / np.bincount(hole)[:, None]
    fans = np.column_stack([rim[:, 1], rim[:, 0], len(mesh.positions) + hole[ends[:, 0]]])
    return Mesh(np.concatenate([mesh.positions, centres]), np.concatenate([mesh.triangles, fans])), int(holes)


def _check_encloses(mesh: Mesh) -> None:
    cube = float(np.ptp(mesh.positions, axis=0).max()) ** 3
    if float(_enclosed(mesh).sum()) <= HOLLOW * cube:
        raise SkullError("is an open sheet that encloses nothing")


def _reduced(mesh: Mesh) -> Mesh:
    """The mesh with as many triangles as are of use, by edges collapsed where they matter least."""
    if len(mesh.triangles) <= USEFUL:
        return mesh
    size = float(np.ptp(mesh.positions, axis=0).max())
    low = mesh.positions.min(axis=0)
    fewer, triangles, _, _ = igl.qslim((mesh.positions - low) / size, mesh.triangles.astype(np.int32), USEFUL)
    if len(triangles):
        return Mesh(np.ascontiguousarray(fewer) * size + low, np.ascontiguousarray(triangles, dtype=np.int64))
    if len(mesh.triangles) <= BEARABLE:
        return mesh
    raise SkullError(
        f"has {len(mesh.triangles):,} triangles".replace(",", " ")
        + ", of which more than two meet at an edge, so that they cannot be reduced"
    )


def _counted(number: int, word: str) -> str:
    return f"1 {word}" if number == 1 else f"{number} {word}s"
