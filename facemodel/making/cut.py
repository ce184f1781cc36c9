"""Cut the head out of the base mesh: one manifold skin with four boundary loops, and the parts behind it.

The base mesh is one closed body whose mouth and eye sockets are pockets. Its UV seams run along the wet line
of the lips and along the lid margins: the skin of the head is one UV island, the pockets are others.
The neck belongs to the island of the body and is clipped by a plane.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from facemodel.making.wheel import BaseMesh
from fem.types import BoolArray, FloatArray, IntArray

NECK_NORMAL = np.array([0.0, 1.0, 0.40])
NECK_POINT = np.array([0.0, 596.0, 0.0])
"""The plane that clips the neck, on the base mesh: square to the neck's axis, well below the chin."""

NEAR_PLANE = 3.0
"""Millimetres: a vertex nearer to the clipping plane is slid onto it, so that no sliver is cut off."""

RIM_Z = 28.0
RIM_NECK = 7.0
"""Millimetres: the solved face lies in front of this z (behind the ears), this far above the neck's plane."""


@dataclass(frozen=True)
class Cut:
    """The skin as a recipe that fits every individual: vertex = (1 - t) base[a] + t base[b].

    Attributes
    ----------
    ends : (N, 2) int, the base vertices a and b
    along : (N,) float, t
    triangles : (T, 3) int
    solved : (T,) bool, the triangles in front of the rim
    uv : (N, 2) float
    mirror : (N,) int, the vertex across the midline
    """

    ends: IntArray
    along: FloatArray
    triangles: IntArray
    solved: BoolArray
    uv: FloatArray
    mirror: IntArray

    def positions(self, base: FloatArray) -> FloatArray:
        """Skin positions (N, 3) for base positions or displacements (V, 3)."""
        a, b = self.ends.T
        return np.asarray(base[a] * (1 - self.along[:, None]) + base[b] * self.along[:, None])


def uv_islands(quads: IntArray) -> IntArray:
    """Label the quads (Q, 4, 2) by UV island (Q,): joined where they share an edge in both index sets."""
    corner = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2, 2)
    order = np.argsort(corner[:, :, 0], axis=1)[:, :, None]
    ends = np.take_along_axis(corner, np.broadcast_to(order, corner.shape), axis=1).reshape(-1, 4)
    _, edge = np.unique(ends, axis=0, return_inverse=True)
    face = np.repeat(np.arange(len(quads)), 4)
    sort = np.argsort(edge, kind="stable")
    same = edge[sort][1:] == edge[sort][:-1]
    i, j = face[sort][1:][same], face[sort][:-1][same]
    graph = coo_array((np.ones(len(i)), (i, j)), shape=(len(quads), len(quads)))
    return np.asarray(connected_components(graph, directed=False)[1])


def island_of(quads: IntArray, labels: IntArray, vertex: int) -> IntArray:
    """Quads of the smallest island that holds a vertex."""
    candidates = np.unique(labels[(quads[:, :, 0] == vertex).any(axis=1)])
    return np.asarray(quads[labels == min(candidates, key=lambda k: int((labels == k).sum()))])


def triangulate(quads: IntArray, positions: FloatArray, mirror: IntArray) -> IntArray:
    """Split quads (Q, 4) along the shorter diagonal, the same way on both sides of the midline: (2 Q, 3)."""
    left = positions[quads].mean(axis=1)[:, 0] > 0
    chosen = quads[left]
    d = positions[chosen]
    first = np.linalg.norm(d[:, 0] - d[:, 2], axis=1) <= np.linalg.norm(d[:, 1] - d[:, 3], axis=1)
    turned = np.where(first[:, None], chosen, np.roll(chosen, -1, axis=1))
    half = np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]])
    return np.concatenate([half, mirror[half][:, ::-1]])


def _slid_onto_plane(triangles: IntArray, positions: FloatArray, height: FloatArray) -> tuple[IntArray, FloatArray]:
    """For every vertex near the plane the neighbour towards which it slides, and the share of that edge."""
    partner = np.arange(len(positions))
    share = np.zeros(len(positions))
    best = np.zeros(len(positions))
    for a, b in [(0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)]:
        i, j = triangles[:, a], triangles[:, b]
        drop = height[i] - height[j]
        steep = np.abs(drop) / np.linalg.norm(positions[i] - positions[j], axis=1)
        for k in np.flatnonzero((np.abs(height[i]) < NEAR_PLANE) & (np.abs(drop) > NEAR_PLANE)):
            if steep[k] > best[i[k]] + 1e-9:
                best[i[k]], partner[i[k]], share[i[k]] = steep[k], j[k], height[i[k]] / drop[k]
    return partner, share


def _clip(
    triangles: IntArray, positions: FloatArray, height: FloatArray
) -> tuple[IntArray, dict[tuple[int, int], int]]:
    """Keep what lies above height zero; new vertices are numbered from len(height), keyed by their edge.

    Four corners are split from the old one nearer to the midline, so that both sides are cut the same way.
    """
    new: dict[tuple[int, int], int] = {}

    def crossing(a: int, b: int) -> int:
        return new.setdefault((min(a, b), max(a, b)), len(height) + len(new))

    kept: list[list[int]] = []
    for corners in triangles.tolist():
        above = [height[c] >= 0 for c in corners]
        if not any(height[c] > 0 for c in corners):
            continue
        polygon: list[int] = []
        for k, a in enumerate(corners):
            b = corners[(k + 1) % 3]
            if above[k]:
                polygon.append(a)
            if above[k] != above[(k + 1) % 3] and height[a] != 0 and height[b] != 0:
                polygon.append(crossing(a, b))
        if len(polygon) == 4:
            first = min((c for c in polygon if c < len(height)), key=lambda c: abs(float(positions[c, 0])))
            at = polygon.index(first)
            polygon = polygon[at:] + polygon[:at]
        kept += [[polygon[0], polygon[k], polygon[k + 1]] for k in range(1, len(polygon) - 1)]
    return np.array(kept), new


def cut_head(base: BaseMesh, mirror: IntArray, mouth_vertex: int) -> Cut:
    """Cut the skin of the head.

    Parameters
    ----------
    base : the base mesh
    mirror : (V,) the base vertex across the midline
    mouth_vertex : any base vertex on the nose, to tell the head's island from the others
    """
    body = base.groups["body"]
    labels = uv_islands(body)
    head = island_of(body, labels, mouth_vertex)
    torso = body[labels == np.bincount(labels[labels != labels[(body[:, :, 0] == mouth_vertex).any(1)][0]]).argmax()]
    high = base.positions[torso[:, :, 0]][:, :, 1].max(axis=1) > NECK_POINT[1] - 60
    quads = np.concatenate([head, torso[high]])
    triangles = triangulate(quads[:, :, 0], base.positions, mirror)

    height = (base.positions - NECK_POINT) @ (NECK_NORMAL / np.linalg.norm(NECK_NORMAL))
    height[np.unique(head[:, :, 0])] = np.maximum(height[np.unique(head[:, :, 0])], 2 * NEAR_PLANE)
    partner, share = _slid_onto_plane(triangles, base.positions, height)
    height[partner != np.arange(len(height))] = 0.0
    triangles, new = _clip(triangles, base.positions, height)

    old = np.arange(len(height))
    added = np.array(sorted(new, key=lambda edge: new[edge])).reshape(-1, 2)
    cut_at = height[added[:, 0]] / (height[added[:, 0]] - height[added[:, 1]])
    ends = np.concatenate([np.stack([old, partner], axis=1), added])
    along = np.concatenate([share, cut_at])
    return _compact(base, mirror, head, triangles, ends, along)


def _compact(
    base: BaseMesh, mirror: IntArray, head: IntArray, triangles: IntArray, ends: IntArray, along: FloatArray
) -> Cut:
    """Number the vertices in use from zero and carry uv, mirror and the solved region over."""
    used, inverse = np.unique(triangles, return_inverse=True)
    triangles = inverse.reshape(-1, 3)
    ends, along = ends[used], along[used]
    at = (1 - along[:, None]) * base.positions[ends[:, 0]] + along[:, None] * base.positions[ends[:, 1]]

    reflected = at * [-1, 1, 1]
    across = np.linalg.norm(at[None, :, :] - reflected[:, None, :], axis=2).argmin(axis=1)
    number = {int(v): k for k, (v, e) in enumerate(zip(ends[:, 0], used, strict=True)) if e < len(base.positions)}
    for v, k in number.items():
        across[k] = number.get(int(mirror[v]), across[k])

    uv = np.full((len(used), 2), np.nan)
    for vertex, texture in head.reshape(-1, 2):
        uv[number[int(vertex)]] = base.uv[texture]
    bare = np.isnan(uv[:, 0])
    nearest = np.linalg.norm(at[bare][:, None] - at[~bare][None], axis=2).argmin(axis=1)
    uv[bare] = uv[~bare][nearest]

    rise = (at - NECK_POINT) @ (NECK_NORMAL / np.linalg.norm(NECK_NORMAL))
    inside = (at[:, 2] > RIM_Z) & (rise > RIM_NECK)
    return Cut(ends, along, triangles, inside[triangles].all(axis=1), uv, across)
