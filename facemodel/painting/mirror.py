"""Which vertex lies across the midline of a face."""

from __future__ import annotations

import numpy as np

from facemodel.errors import PaintError
from facemodel.face import Face
from fem.types import IntArray

ALIKE = 0.5
"""Part of the mean length of its edges by which a vertex' mirror image may miss its partner, where that is found by
position: nearer than to any neighbour of it."""

SYMMETRIC = 0.8
"""Least share of the skin's vertices that must have a partner for a face to count as symmetric."""

NOBODY = -1


def mirror_partners(face: Face) -> IntArray:
    """The vertex (N,) across the midline of every vertex, or -1 where there is none.

    By topology where the face knows its mirror map; by the position of the mirror image otherwise.

    Raises
    ------
    PaintError
        If the face is not symmetric.
    """
    count = len(face.skin.positions)
    own = np.arange(count)
    mirror = face.mirror
    if len(mirror) == count and np.array_equal(mirror[mirror], own) and not np.array_equal(mirror, own):
        return mirror
    away, partner = face.skin.tree.query(face.skin.positions * [-1.0, 1.0, 1.0])
    found = np.where(away <= ALIKE * _mean_edges(face), partner, NOBODY)
    if (found >= 0).mean() < SYMMETRIC:
        raise PaintError(
            f"The face “{face.title}” is not symmetric: {(found < 0).mean():.0%} of its vertices have no partner "
            "across the midline. Paint without mirroring."
        )
    return np.asarray(found, dtype=np.int64)


def _mean_edges(face: Face) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Mean length (N,) of the edges at every vertex, millimetres."""
    i, j = face.skin.edges.T
    length = np.linalg.norm(face.skin.positions[i] - face.skin.positions[j], axis=1)
    ends = np.concatenate([i, j])
    count = len(face.skin.positions)
    total = np.bincount(ends, np.concatenate([length, length]), count)
    return np.asarray(total / np.maximum(np.bincount(ends, minlength=count), 1))
