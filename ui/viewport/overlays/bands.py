"""The shape of a muscle as a band: rows of fibres laid between bone and skin, swelling to a belly."""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np

from facemodel.mesh import Mesh
from facemodel.muscles import Muscle
from facemodel.muscles.curve import paths
from fem.types import FloatArray, IntArray

STEPS = 12
"""Segments along a fibre."""
AROUND = 96
"""Segments round a sphincter."""
ROWS = 9
"""Fibres drawn across a ring, or across a muscle with a single fibre."""
UNDER_SKIN = 1.0
"""Millimetres of skin over a muscle."""
BELLY = 1.6
"""Millimetres that a muscle swells between its ends."""
SLIM = 0.28
"""Half width of a muscle with a single fibre, and of a ring, over its width of influence."""


@dataclass(frozen=True, eq=False)
class Band:
    """A muscle as a grid of points.

    Attributes
    ----------
    points : (rows, columns, 3) fibres from origin to attachment, or round a ring
    along : (columns,) 0 at the origin, 1 at the attachment; all one for a ring, which hangs on the skin alone
    closed : whether the columns close to a ring
    """

    points: FloatArray
    along: FloatArray
    closed: bool

    @property
    def triangles(self) -> IntArray:
        """Triangles of the grid, vertices numbered row by row."""
        rows, columns = self.points.shape[:2]
        spans = columns if self.closed else columns - 1
        i, j = np.meshgrid(np.arange(rows - 1), np.arange(spans), indexing="ij")
        a, b = i * columns + j, i * columns + (j + 1) % columns
        c, d = a + columns, b + columns
        return np.concatenate([np.stack([a, b, d], -1).reshape(-1, 3), np.stack([a, d, c], -1).reshape(-1, 3)])


def band(muscle: Muscle, skin: Mesh) -> Band:
    """The band of a muscle under a resting skin."""
    if muscle.ring is not None:
        points, along, closed = _ring(muscle), np.ones(AROUND), True
        if muscle.ring.sector.any() or muscle.model == "lid":
            closed = False
            along = np.ones(points.shape[1])
    else:
        points, along, closed = _fan(muscle), np.linspace(0, 1, STEPS + 1), False
    rows = points.shape[0]
    across = 1 - np.linspace(-1, 1, rows) ** 2 if rows > 1 else np.ones(1)
    belly = BELLY * np.sqrt(across)[:, None] * (np.sin(np.pi * along)[None] if muscle.ring is None else 0.7)
    return Band(_below(points, skin, belly), along, closed)


def _fan(muscle: Muscle) -> FloatArray:
    """Fibres (rows, STEPS + 1, 3), straight or bent over the bone."""
    lines = paths(muscle.fibres, max(ROWS, min(muscle.count, 24)), STEPS)
    if len(lines) > 1:
        return lines
    side = np.cross(lines[0, -1] - lines[0, 0], [0.0, 0.0, 1.0])
    side *= SLIM * muscle.width / max(float(np.linalg.norm(side)), 1e-9)
    t = np.linspace(0.5, 1, STEPS + 1)[:, None]
    return np.asarray(lines + np.linspace(-1, 1, ROWS)[:, None, None] * t * side)


def _ring(muscle: Muscle) -> FloatArray:
    """Concentric fibres (ROWS, columns, 3) of a ring, of half a ring, or of an upper lid."""
    ring = muscle.ring
    assert ring is not None
    a, b = np.linalg.norm(ring.long_axis), np.linalg.norm(ring.short_axis)
    turn = np.linspace(0, 2 * np.pi, AROUND, endpoint=False)
    if muscle.model == "lid":
        turn = np.linspace(0.08 * np.pi, 0.92 * np.pi, AROUND // 2)
        spread = np.linspace(0.35, 1.0, ROWS)
        scales = np.stack([np.full(ROWS, 0.95), spread], axis=1)
    else:
        if ring.sector.any():
            middle = np.arctan2(ring.sector @ ring.short_axis / b, ring.sector @ ring.long_axis / a)
            turn = middle + np.linspace(-np.pi / 2, np.pi / 2, AROUND // 2 + 1)
        half = SLIM * muscle.width * np.linspace(-1, 1, ROWS)
        scales = np.stack([1 + half / a, 1 + half / b], axis=1)
    return np.asarray(
        ring.centre
        + (scales[:, :1] * np.cos(turn))[..., None] * ring.long_axis
        + (scales[:, 1:] * np.sin(turn))[..., None] * ring.short_axis
    )


def _below(points: FloatArray, skin: Mesh, belly: FloatArray) -> FloatArray:
    """Push points that would stand out of the skin under it, and swell the rest towards it.

    A ring lies in a plane and the face does not, so all its points go to the skin.
    """
    flat = points.reshape(-1, 3)
    _, element, nearest = igl.point_mesh_squared_distance(np.ascontiguousarray(flat), skin.positions, skin.triangles)
    normal = skin.normals[skin.triangles[element]].mean(axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    depth = np.einsum("nc,nc->n", nearest - flat, normal)
    wanted = np.maximum(depth - np.broadcast_to(belly, points.shape[:2]).ravel(), UNDER_SKIN)
    return np.asarray((flat + (depth - wanted)[:, None] * normal).reshape(points.shape))
