"""Eyelashes: curved, tapering hairs that ride on the lid margins and turn with the lids about the eyeball."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.face import Eye
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.lids import LidLine, same_line
from ui.viewport.shading import HAIR
from ui.viewport.strands import spread
from ui.viewport.surface import Surface

COUNT = {"upper": 80, "lower": 40}
LENGTH = {"upper": 7.6, "lower": 3.4}
"""Hairs per lid, and their length in millimetres where they are longest."""
SEGMENTS = 6
"""Places along a hair; with fewer its bend is seen as corners from near."""
ROOT_WIDTH = {"upper": 0.18, "lower": 0.12}
"""Millimetres; a hair is thinner, but several grow together."""
SMALLEST = 1e-9
"""Length of a direction below which it is none."""


class Lashes:
    """The lashes of one eye.

    Attributes
    ----------
    surface : what VTK draws
    """

    def __init__(self, eye: Eye, lids: LidLine, rest: Float32Array, hair: tuple[float, float, float]) -> None:
        """Plant the lashes along a line of the lids on the resting skin ``rest`` (P, 3)."""
        self._centre = eye.centre
        self._lids = lids
        self._plan = _Plan(lids.places(rest), eye)
        count = self._plan.count
        ribs = np.arange(count)[:, None] * SEGMENTS * 2 + 2 * np.arange(SEGMENTS - 1)[None]
        a = ribs.reshape(-1)
        triangles = np.concatenate([np.stack([a, a + 1, a + 3], 1), np.stack([a, a + 3, a + 2], 1)])
        points, normals, self._strands = (np.zeros((count * SEGMENTS * 2, k), np.float32) for k in (3, 3, 4))
        self.surface = Surface(points, normals, triangles)
        self.surface.actor.GetProperty().SetColor(*(0.45 * c for c in hair))
        spread(self.surface, self._strands, HAIR)
        self._seen: FloatArray | None = None
        self.follow(rest)

    def follow(self, points: Float32Array) -> None:
        """Grow from the posed skin ``points`` (P, 3)."""
        margin = self._lids.places(points)
        if self._seen is not None and same_line(margin, self._seen):
            return
        self._seen = margin
        points, normals = (array.reshape(-1, SEGMENTS, 2, 3) for array in (self.surface.points, self.surface.normals))
        strands = self._strands.reshape(-1, SEGMENTS, 2, 4)
        _grow(margin, self._centre, self._plan.outward, self._plan.hairs, points, normals, strands)
        self.surface.moved()


class _Hairs(NamedTuple):
    """How each hair (H,) is rooted and bent.

    Attributes
    ----------
    start, stop, share : its root between two places of the lid line
    sign : 1 on the upper lid, -1 on the lower one
    spread : how far it heads outwards
    length, curl, width : of it
    """

    start: IntArray
    stop: IntArray
    share: FloatArray
    sign: FloatArray
    spread: FloatArray
    length: FloatArray
    curl: FloatArray
    width: FloatArray


class _Plan:
    """Where each hair is rooted and how it is bent, settled once at rest."""

    def __init__(self, margin: FloatArray, eye: Eye) -> None:
        random = np.random.default_rng(11)
        outward = 1.0 if eye.side == "L" else -1.0
        inner = margin[(margin[:, 0] * outward).argmin()]
        outer = margin[(margin[:, 0] * outward).argmax()]
        across = (outer - inner) * [1, 0, 0]
        parts = []
        following = np.roll(np.arange(len(margin)), -1)
        middle = (margin + margin[following]) / 2
        level = inner[1] + (middle - inner) @ across / (across @ across) * (outer[1] - inner[1])
        for lid, upper in (("upper", True), ("lower", False)):
            edges = np.flatnonzero((middle[:, 1] >= level) == upper)
            length = np.linalg.norm(margin[following[edges]] - margin[edges], axis=1)
            ends = np.cumsum(length)
            at = (np.arange(COUNT[lid]) + random.uniform(0.1, 0.9, COUNT[lid])) / COUNT[lid] * ends[-1]
            edge = np.searchsorted(ends, at)
            share = 1 - (ends[edge] - at) / length[edge]
            start, stop = edges[edge], following[edges[edge]]
            root = margin[start] * (1 - share)[:, None] + margin[stop] * share[:, None]
            s = np.clip((root - inner) @ across / (across @ across), 0, 1)
            size = LENGTH[lid] * np.interp(s, [0, 0.15, 0.5, 0.8, 1], [0.25, 0.5, 0.85, 1.0, 0.8])
            parts.append((start, stop, share, s, size * random.uniform(0.72, 1.0, len(s)), np.full(len(s), upper)))
        start, stop, share, s, length, upper_hair = (np.concatenate(column) for column in zip(*parts, strict=True))
        self.count = len(s)
        self.outward = outward
        self.hairs = _Hairs(
            start,
            stop,
            share,
            np.where(upper_hair, 1.0, -1.0),
            (s - 0.38) * np.where(upper_hair, 1.25, 0.9) + random.normal(0, 0.09, self.count),
            length,
            np.where(upper_hair, 1.15, 0.6) * random.uniform(0.8, 1.1, self.count),
            np.where(upper_hair, ROOT_WIDTH["upper"], ROOT_WIDTH["lower"]),
        )


@compiled
def _grow(
    margin: FloatArray,
    centre: FloatArray,
    outward: float,
    hairs: _Hairs,
    places: Float32Array,
    normals: Float32Array,
    strands: Float32Array,
) -> None:
    """Write places and normals (H, SEGMENTS, 2, 3) along the hairs, twice each, and their strands (H, SEGMENTS, 2, 4).

    Parameters
    ----------
    margin : (n, 3) the line of the lids
    centre : (3,) of the eyeball
    outward : in which direction x grows towards the outer corner of the eye
    """
    for hair in range(len(hairs.start)):
        share = hairs.share[hair]
        root = margin[hairs.start[hair]] * (1 - share) + margin[hairs.stop[hair]] * share
        radial = _unit(root - centre)
        side = -outward * radial[0] * radial
        side[0] += outward
        side = _unit(side)
        up = np.cross(radial, side) * (outward * hairs.sign[hair])
        heading = _unit(radial + 0.10 * up + hairs.spread[hair] * side)
        normal = _unit(radial + up)
        for segment in range(SEGMENTS):
            t = segment / (SEGMENTS - 1)
            path = root + hairs.length[hair] * (t * heading + 0.5 * hairs.curl[hair] * t**2 * up)
            along = _unit(heading + hairs.curl[hair] * t * up)
            half = 0.5 * hairs.width[hair] * (1 - 0.9 * t**1.5)
            for edge in range(2):
                places[hair, segment, edge] = path
                normals[hair, segment, edge] = normal
                strands[hair, segment, edge, :3] = along
                strands[hair, segment, edge, 3] = (2 * edge - 1) * half


@compiled
def _unit(vector: FloatArray) -> FloatArray:
    return vector / max(np.sqrt((vector * vector).sum()), SMALLEST)
