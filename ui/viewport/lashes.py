"""Eyelashes: curved, tapering hairs that ride on the lid margins and turn with the lids about the eyeball."""

from __future__ import annotations

import numpy as np

from facemodel.face import Eye
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.lids import LidLine
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
        if self._seen is not None and np.array_equal(margin, self._seen):
            return
        self._seen = margin
        places, normals, strands = self._plan.grow(margin, self._centre)
        self.surface.points[:] = places.reshape(-1, 3)
        self.surface.normals[:] = normals.reshape(-1, 3)
        self._strands[:] = strands.reshape(-1, 4)
        self.surface.moved()


class _Plan:
    """Where each hair is rooted and how it is bent, settled once at rest."""

    def __init__(self, margin: FloatArray, eye: Eye) -> None:
        random = np.random.default_rng(11)
        outward = 1.0 if eye.side == "L" else -1.0
        inner = margin[(margin[:, 0] * outward).argmin()]
        outer = margin[(margin[:, 0] * outward).argmax()]
        across = (outer - inner) * [1, 0, 0]
        self.low: list[IntArray] = []
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
        columns = [np.concatenate(column) for column in zip(*parts, strict=True)]
        self.start, self.stop, self.share, self.s, self.length, upper_hair = columns
        self.count = len(self.s)
        self.sign = np.where(upper_hair, 1.0, -1.0)
        self.spread = (self.s - 0.38) * np.where(upper_hair, 1.25, 0.9) + random.normal(0, 0.09, self.count)
        self.curl = np.where(upper_hair, 1.15, 0.6) * random.uniform(0.8, 1.1, self.count)
        self.width = np.where(upper_hair, ROOT_WIDTH["upper"], ROOT_WIDTH["lower"])
        self.outward = outward

    def grow(self, margin: FloatArray, centre: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Places and normals (H, SEGMENTS, 2, 3) along the hairs, twice each, and their strands (H, SEGMENTS, 2, 4)."""
        share = self.share[:, None]
        root = margin[self.start] * (1 - share) + margin[self.stop] * share
        radial = _unit(root - centre)
        side = _unit(np.array([self.outward, 0.0, 0.0]) - radial * (radial[:, :1] * self.outward))
        up = np.cross(radial, side) * self.outward * self.sign[:, None]
        heading = _unit(radial + 0.10 * up + self.spread[:, None] * side)
        t = np.linspace(0, 1, SEGMENTS)[None, :, None]
        size, curl = self.length[:, None, None], self.curl[:, None, None]
        path = root[:, None] + size * (t * heading[:, None] + 0.5 * curl * t**2 * up[:, None])
        along = _unit(heading[:, None] + curl * t * up[:, None])
        half = 0.5 * self.width[:, None, None] * (1 - 0.9 * t**1.5)
        strands = np.stack([np.concatenate([along, sign * half], axis=2) for sign in (-1, 1)], axis=2)
        normal = np.broadcast_to(_unit(radial + up)[:, None, None], (self.count, SEGMENTS, 2, 3))
        return np.stack([path, path], axis=2), normal, strands


def _unit(vectors: FloatArray) -> FloatArray:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-9))
