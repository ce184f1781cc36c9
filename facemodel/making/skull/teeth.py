"""The teeth: one closed crown each, set along the dental arches of the measured head."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.interpolate import CubicSpline

from facemodel.making.skull.fields import along, rod, smooth_max, smooth_min
from facemodel.mesh import Mesh
from fem.types import FloatArray, IntArray

Form = Literal["incisor", "canine", "premolar", "molar"]


@dataclass(frozen=True)
class Tooth:
    """One crown: its form, and in millimetres its width along the arch, depth across it and height."""

    form: Form
    width: float
    depth: float
    height: float


@dataclass(frozen=True, eq=False)
class Row:
    """A tooth row of the left side, from the middle backwards.

    Attributes
    ----------
    neck, edge : (n, 2) plan (x, z) of the crowns' middle where they leave the bone, and at the biting edge
    teeth : front to back
    up : 1 where crowns stand up from the bone, -1 where they hang
    """

    neck: FloatArray
    edge: FloatArray
    teeth: tuple[Tooth, ...]
    up: float


UPPER = Row(
    np.array([(0, 142.8), (4.5, 142.5), (10.5, 140.2), (16, 135.6), (20.8, 129), (24, 121.5), (26.2, 113), (28, 98)]),
    np.array([(0, 145), (4.6, 144.6), (11, 142.4), (17, 137.6), (21.6, 130.6), (24.4, 122.5), (26.4, 113.5), (28, 98)]),
    (
        Tooth("incisor", 8.4, 6.6, 10.6),
        Tooth("incisor", 6.6, 6.0, 9.6),
        Tooth("canine", 7.5, 7.6, 10.4),
        Tooth("premolar", 6.8, 8.6, 8.6),
        Tooth("premolar", 6.6, 8.6, 8.0),
        Tooth("molar", 10.0, 10.4, 7.6),
        Tooth("molar", 9.2, 10.2, 7.0),
    ),
    -1.0,
)
LOWER = Row(
    np.array([(0, 137), (3, 136.8), (8, 134.6), (12.2, 130.5), (16, 124.5), (18.8, 117.5), (22.4, 108.5), (27.5, 93)]),
    np.array([(0, 142.4), (3, 142.2), (8.9, 140), (13.9, 135.2), (18.1, 128), (21.3, 119), (24.2, 110), (28.2, 93)]),
    (
        Tooth("incisor", 5.4, 5.6, 9.0),
        Tooth("incisor", 5.8, 5.8, 9.2),
        Tooth("canine", 6.8, 7.2, 10.2),
        Tooth("premolar", 6.9, 7.8, 8.6),
        Tooth("premolar", 7.0, 8.0, 8.0),
        Tooth("molar", 10.8, 10.0, 7.6),
        Tooth("molar", 10.2, 9.8, 7.2),
    ),
    1.0,
)
BITE = [(97, 671.2), (120, 665.6), (135, 662.2), (148, 660.4)]
"""Where the rows meet, (z, y): the plane of occlusion rises backwards."""

FREEWAY = 0.5
OVERBITE = 1.6
"""Millimetres that the rows stand apart at rest, and that upper incisors hang over the lower ones."""

ROOTED = 2.5
"""Millimetres of each crown that are sunk in the bone."""

NECK = 1.6
"""Millimetres of crown that the rim of its socket hides: what the grid rounds off is in it."""

RING = 12
"""Vertices around a crown."""

LEVEL = np.array([0.0, 0.4, 0.65, 0.86, 1.0])
WAIST: Mapping[Form, FloatArray] = {
    "incisor": np.array([[0.82, 1.0], [0.95, 0.95], [0.99, 0.72], [1.0, 0.46], [0.96, 0.24]]),
    "canine": np.array([[0.8, 1.0], [0.95, 1.0], [1.0, 0.8], [0.78, 0.56], [0.3, 0.26]]),
    "premolar": np.array([[0.82, 0.9], [0.96, 1.0], [1.0, 1.0], [0.97, 0.9], [0.74, 0.62]]),
    "molar": np.array([[0.86, 0.9], [0.97, 1.0], [1.0, 1.0], [0.97, 0.93], [0.82, 0.74]]),
}
"""Width and depth of a crown at each level from the neck to the edge, against its largest."""

CUSPS: Mapping[Form, tuple[int, float, float]] = {
    "incisor": (0, 0.0, 0.0),
    "canine": (0, 0.0, 0.5),
    "premolar": (2, 0.6, -0.8),
    "molar": (4, 0.5, -0.9),
}
"""Cusps around the chewing face, how far they rise and how far its middle does, millimetres."""


def crown(tooth: Tooth) -> tuple[FloatArray, IntArray]:
    """A crown: vertices (n, 4) as place across, share of the height, rise above that, place outwards; triangles."""
    angle = 2 * np.pi * (np.arange(RING) + 0.5) / RING
    square = (np.abs(np.cos(angle)) ** 3.0 + np.abs(np.sin(angle)) ** 3.0) ** (-1 / 3.0)
    around = np.stack([square * np.cos(angle) * tooth.width, square * np.sin(angle) * tooth.depth], axis=1) / 2
    cusps, rise, middle = CUSPS[tooth.form]
    bumps = rise * np.cos(cusps * (angle - np.pi / 4)) if cusps else np.zeros(RING)
    rows = []
    for level, waist in zip(LEVEL, WAIST[tooth.form], strict=True):
        place = around * waist
        rows.append(np.stack([place[:, 0], np.full(RING, level), bumps * (level == 1), place[:, 1]], axis=1))
    points = np.concatenate([*rows, [[0, 0, 0, 0], [0, 1, middle, 0]]])
    k = np.arange(RING)
    after = np.roll(k, -1)
    first, last = np.full(RING, len(points) - 2), np.full(RING, len(points) - 1)
    top = RING * (len(LEVEL) - 1)
    triangles = [np.stack([k, after, first], axis=1), np.stack([top + after, top + k, last], axis=1)]
    for low in range(0, top, RING):
        high = low + RING
        triangles.append(np.stack([low + after, low + k, high + k], axis=1))
        triangles.append(np.stack([low + after, high + k, high + after], axis=1))
    return points, np.concatenate(triangles)


def _arch(half: FloatArray) -> CubicSpline:
    """A smooth curve over a whole arch from its left half (n, 2); it runs over -1 to 1, the middle at 0."""
    whole = np.concatenate([half[:0:-1] * [-1, 1], half])
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(whole, axis=0), axis=1))])
    return CubicSpline(2 * length / length[-1] - 1, whole)


def tooth_row(row: Row) -> Mesh:
    """All crowns of one jaw, both sides, on the measured head: closed pieces that do not touch."""
    neck, edge = _arch(row.neck), _arch(row.edge)
    reach = np.linalg.norm(np.diff(row.edge, axis=0), axis=1).sum()
    positions: list[FloatArray] = []
    triangles: list[IntArray] = []
    start, count = 0.0, 0
    for tooth in row.teeth:
        share = (start + tooth.width / 2) / reach
        start += tooth.width
        ahead = edge(share, 1) / np.linalg.norm(edge(share, 1))
        local, corners = crown(tooth)
        span = tooth.height + ROOTED
        plan = neck(share) + local[:, 1:2] * (edge(share) - neck(share))
        plan = plan + local[:, :1] * ahead + local[:, 3:] * np.array([-ahead[1], ahead[0]])
        lap = OVERBITE * along(np.array([share * reach]), [(0, 1.0), (18, 0.8), (30, 0.0)])[0] - FREEWAY
        bite = along(edge(share)[1:], BITE)[0] + row.up * lap / 2
        height = bite + row.up * (span * (local[:, 1] - 1) + local[:, 2])
        left = np.stack([plan[:, 0], height, plan[:, 1]], axis=1)
        for side in (1, -1):
            positions.append(left * [side, 1, 1])
            triangles.append((corners if side * row.up > 0 else corners[:, ::-1]) + count)
            count += len(left)
    return Mesh(np.concatenate(positions), np.concatenate(triangles))


def sockets(p: FloatArray, row: Row) -> FloatArray:
    """The alveolar process of one jaw: bone that rises about the roots, at points (n, 3) of the left side."""
    neck = _arch(row.neck)
    reach = np.linalg.norm(np.diff(row.edge, axis=0), axis=1).sum()
    start = 0.0
    best = np.full(len(p), np.inf)
    for tooth in row.teeth:
        x, z = neck((start + tooth.width / 2) / reach)
        start += tooth.width
        gum = along(np.array([z]), BITE)[0] - row.up * (tooth.height - NECK)
        root = rod(p, [(x, gum, z), (0.94 * x, gum - row.up * 11, z - 4)], [tooth.depth * 0.74, tooth.depth * 0.45])
        best = smooth_min(best, smooth_max(root, row.up * (p[:, 1] - gum), 2.0), 2.5)
    return best
