"""Eyelashes: curved, tapering hairs that ride on the lid margins and turn with the lids about the eyeball."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.face import Eye
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.joined import Shape, joined
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
    """The lashes of the eyes of a face.

    Attributes
    ----------
    surface : what VTK draws; none where there are no lids to grow from
    """

    def __init__(
        self, roots: Sequence[tuple[Eye, LidLine]], rest: Float32Array, hair: tuple[float, float, float]
    ) -> None:
        """Plant lashes along the lines of the lids of some eyes on the resting skin ``rest`` (P, 3)."""
        self.surface: Surface | None = None
        plans = [_Plan(lids.places(rest), eye) for eye, lids in roots]
        if not plans:
            self._each: list[_LashesOfEye] = []
            return
        self.surface, shapes = joined([_ribbons(plan.count) for plan in plans])
        self.surface.actor.GetProperty().SetColor(*(0.45 * c for c in hair))
        strands = np.zeros((len(self.surface.points), 4), np.float32)
        spread(self.surface, strands, HAIR)
        parts = np.split(strands, np.cumsum([len(shape.points) for shape in shapes])[:-1])
        self._each = [_LashesOfEye(*root, *own) for root, *own in zip(roots, plans, shapes, parts, strict=True)]
        self.follow(rest)

    def follow(self, points: Float32Array) -> None:
        """Grow from the posed skin ``points`` (P, 3)."""
        grown = [each.follow(points) for each in self._each]
        if self.surface is not None and any(grown):
            self.surface.moved()


def _ribbons(count: int) -> Shape:
    """So many hairs, each a chain of places that are there twice."""
    ribs = np.arange(count)[:, None] * SEGMENTS * 2 + 2 * np.arange(SEGMENTS - 1)[None]
    a = ribs.reshape(-1)
    triangles = np.concatenate([np.stack([a, a + 1, a + 3], 1), np.stack([a, a + 3, a + 2], 1)])
    points, normals = (np.zeros((count * SEGMENTS * 2, 3), np.float32) for _ in "pn")
    return Shape(points, normals, triangles)


class _LashesOfEye:
    """The lashes of one eye, written into a shape and its strands (n, 4)."""

    def __init__(self, eye: Eye, lids: LidLine, plan: _Plan, shape: Shape, strands: Float32Array) -> None:
        self._centre, self._lids, self._plan = eye.centre, lids, plan
        self._points, self._normals = (array.reshape(-1, SEGMENTS, 2, 3) for array in (shape.points, shape.normals))
        self._strands = strands.reshape(-1, SEGMENTS, 2, 4)
        self._seen: FloatArray | None = None

    def follow(self, points: Float32Array) -> bool:
        """Grow from the posed skin (P, 3); whether the lids are seen elsewhere than before."""
        margin = self._lids.places(points)
        if self._seen is not None and same_line(margin, self._seen):
            return False
        self._seen = margin
        plan = self._plan
        _grow(margin, self._centre, plan.outward, plan.hairs, self._points, self._normals, self._strands)
        return True


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
