"""The teeth of a skull where those of its face are: crowns set along its rows, and the bone about their roots follows.

The tables of tissue depth know little of teeth: lips and cheeks lie on them however they stand.  The rows that a face
is drawn with, and before which its lips are kept, say more.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.interpolate import RBFInterpolator
from scipy.spatial import KDTree

from facemodel.dental_arch import HEIGHTS, DentalArch
from facemodel.making.skull.frame import Frame
from facemodel.making.skull.teeth import LEVEL, RING, ROOTED, WAIST, Row, crown, tooth_row
from facemodel.smooth import smooth
from fem.types import FloatArray

Seat = Callable[[FloatArray], FloatArray]

APART = 0.995
"""Width of a crown against the room it has, so that neighbours do not touch."""

BELLY, RECEDED = -0.3, -1.4
"""Millimetres that crowns stand out of the lips' side of a row, below zero since thin lips rest on it; the same of
their necks."""

ROOT, DEEP_SHARE = 10.0, 0.8
"""Millimetres from the neck into the bone to the tip of a root, and the share of the neck's way that it goes."""

CLOSE, FAR = 6.0, 30.0
"""Millimetres from the necks within which bone goes all of their way, and from where on none of it: chin, nose, cheek
bones and joints stay as deep as the tables say."""

PINS = 10
"""Of the bone beyond, every so many a vertex is held, so that the way between it and the roots is smooth; so is bone
under the landmarks that lie on no lip."""

UNDER_GUM, GUM, SPREAD = 0.4, 0.7, 0.1
"""Millimetres that the bone between the teeth stands out of the lips' side of a row; the share of the way from edge to
root at which it begins to go farther, and by how much: millimetres per millimetre squared."""

OBLIQUE = 7.0
"""Millimetres that it does so beside the last molar."""

SAMPLES = 121
"""Places along a row at which it is known how far out it stands."""

NOISE = 0.5
"""Smoothing of the thin-plate spline of the ways: crowns may miss their sockets by some tenths of a millimetre, bone
between two of them must not fold."""


def crowns_along(row: Row, arch: DentalArch) -> FloatArray:
    """The crowns of a row (n, 3), numbered as by `tooth_row`, with their lips' side on that of an arch."""
    middles, rooms = (arch.bounds[1:] + arch.bounds[:-1]) / 2, np.diff(arch.bounds)
    placed = []
    for tooth, middle, room, height in zip(row.teeth, middles, rooms, HEIGHTS[arch.jaw], strict=True):
        across, share, rise, out = crown(tooth)[0].T
        depth = np.interp(share, LEVEL, WAIST[tooth.form][:, 1] * tooth.depth / 2)
        out = out - depth + np.interp(share, LEVEL[:2], [RECEDED, BELLY])
        up = (height + ROOTED) * (1 - share) - rise
        for side in (1.0, -1.0):
            edge, root, outward = (each[0] for each in arch.at(np.array([side * middle])))
            rooted = (root - edge) / np.linalg.norm(root - edge)
            backward = side * arch.edge_at(side * middle, 1)
            backward *= APART * room / tooth.width / np.linalg.norm(backward)
            placed.append(edge + np.outer(across, backward) + np.outer(up, rooted) + np.outer(out, outward))
    return np.concatenate(placed)


def seat_of(frame: Frame, rows: Sequence[tuple[Row, DentalArch]]) -> Seat:
    """How bone (n, 3) that a frame has carried over goes along with its necks to where the arches have them.

    It is one map of space for both jaws, so that bones which did not touch do not do so after it.

    Parameters
    ----------
    frame : from the measured head to this one
    rows : of teeth on the measured head, each with the arch of the same teeth on this one
    """
    there, goal = (
        np.concatenate([_roots(row, crowns) for row, crowns in placed])
        for placed in (
            [(row, tooth_row(row).positions) for row, _ in rows],
            [(row, crowns_along(row, arch)) for row, arch in rows],
        )
    )
    here = frame.here(there.reshape(-1, 3)).reshape(there.shape)
    deep = here[:, :1] + ROOT * _unit(here[:, :1] - here[:, 1:2])
    ways = goal - here
    places = np.concatenate([here, deep], axis=1).reshape(-1, 3)
    ways = np.concatenate([ways, DEEP_SHARE * ways[:, :1]], axis=1).reshape(-1, 3)
    tree = KDTree(places)
    pins = frame.bone.inner.positions[::PINS]
    pins = np.concatenate([pins[tree.query(pins)[0] > FAR], frame.firm])
    known, moved = np.concatenate([places, pins]), np.concatenate([ways, np.zeros_like(pins)])
    way = RBFInterpolator(known, moved, kernel="thin_plate_spline", smoothing=NOISE)

    def seat(points: FloatArray) -> FloatArray:
        away, _ = tree.query(points, distance_upper_bound=FAR)
        near = np.isfinite(away)
        seated = points.copy()
        seated[near] += smooth(away[near], FAR, CLOSE)[:, None] * way(points[near])
        return seated

    return seat


def before_row(arch: DentalArch, points: FloatArray) -> FloatArray:
    """Signed distance (n,) of points (n, 3) to where the bone about a row of teeth ends: below its gum, no farther out.

    Past the roots it lets chin, nose and cheek bones be, and beside the molars the oblique line.
    """
    along = np.linspace(-arch.bounds[-1], arch.bounds[-1], SAMPLES)
    edge, root, outward = arch.at(along)
    _, nearest = KDTree(np.concatenate([edge, root])).query(points)
    place = nearest % SAMPLES
    height = np.linalg.norm(root - edge, axis=1)[place]
    arm = points - edge[place]
    down = (arm * (root - edge)[place]).sum(axis=1) / height
    sideways = np.abs(along[place])
    behind = np.linalg.norm(arm, axis=1) * (place % (SAMPLES - 1) == 0)
    room = UNDER_GUM + SPREAD * np.maximum(down - GUM * height, 0.0) ** 2
    room += OBLIQUE * smooth(sideways, arch.bounds[3], arch.bounds[-1]) + behind
    return np.asarray((arm * outward[place]).sum(axis=1) - room)


def _roots(row: Row, crowns: FloatArray) -> FloatArray:
    """Of every crown (T, 6, 3) the middles of its neck and of the ring above, and four places around the neck."""
    each = crowns.reshape(2 * len(row.teeth), -1, 3)
    neck, above = each[:, :RING], each[:, RING : 2 * RING]
    middles = [ring.mean(axis=1, keepdims=True) for ring in (neck, above)]
    return np.concatenate([*middles, neck[:, :: RING // 4]], axis=1)


def _unit(vectors: FloatArray) -> FloatArray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))
