"""The clean cut of the neck: a plane just above the rim of the skin, and a plain cap in it.

The triangles that the plane crosses are cut once, and what is left of them moves with the corners they had; all others
stay the skin's own.
"""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np

from facemodel.display import DisplaySurface
from fem.types import BoolArray, FloatArray, IntArray
from ui.viewport.edges import between
from ui.viewport.surface import Surface

ABOVE_RIM = 0.3
"""Millimetres between the highest point of the rim, as a wavy line about a plane, and the cut."""
UPRIGHT = 0.7
"""Least upward share of the normal of a rim that is a neck's and not the edge of a mask."""
CAP = (0.46, 0.36, 0.325)
"""Of the section, as it is seen from anywhere: darker than skin and lighter than shadow, calm on both backdrops."""


@dataclass(frozen=True, eq=False)
class NeckCut:
    """The skin cut off at the neck.

    Attributes
    ----------
    kept : (F,) which triangles of the drawn skin lie above the cut
    start, stop, share : (n,) each point of the strip that is left of the crossed triangles, as drawn points and how
        far it lies from one to the other
    strip : (t, 3) triangles of the strip
    edge : (m,) points of the strip on the cut, in order
    normal : (3,) of the cut, towards the head
    """

    kept: BoolArray
    start: IntArray
    stop: IntArray
    share: FloatArray
    strip: IntArray
    edge: IntArray
    normal: FloatArray

    def of(self, values: FloatArray) -> FloatArray:
        """Values (P, k) of the drawn points at the points of the strip (n, k)."""
        return between(values, self.start, self.stop, self.share)


def neck_cut(display: DisplaySurface) -> NeckCut | None:
    """Cut the neck; none if the skin does not end in one."""
    loops = [np.array(loop, dtype=np.int64) for loop in igl.boundary_loop_all(display.triangles)]
    if not loops:
        return None
    points = display.points.astype(np.float64)
    rim = max(loops, key=lambda loop: float(np.ptp(points[loop], axis=0).max()))
    middle = points[rim].mean(axis=0)
    normal = np.linalg.svd(points[rim] - middle, full_matrices=False)[2][2]
    normal *= 1.0 if normal[1] >= 0 else -1.0
    height = (points - middle) @ normal
    if normal[1] < UPRIGHT or height.mean() < 0:
        return None
    return _cut(display, height - height[rim].max() - ABOVE_RIM, normal)


def _cut(display: DisplaySurface, height: FloatArray, normal: FloatArray) -> NeckCut:
    above = height[display.triangles] > 0
    crossed = above.any(axis=1) & ~above.all(axis=1)
    number: dict[tuple[int, int], int] = {}
    triangles: list[list[int]] = []
    for corners, inside in zip(display.triangles[crossed].tolist(), above[crossed].tolist(), strict=True):
        polygon: list[int] = []
        for k, a in enumerate(corners):
            b = corners[(k + 1) % 3]
            if inside[k]:
                polygon.append(number.setdefault((a, a), len(number)))
            if inside[k] != inside[(k + 1) % 3]:
                polygon.append(number.setdefault((min(a, b), max(a, b)), len(number)))
        triangles += [[polygon[0], polygon[k], polygon[k + 1]] for k in range(1, len(polygon) - 1)]
    start, stop = np.array(list(number)).T
    on_cut = start != stop
    rise = height[start] - height[stop]
    share = np.where(on_cut, height[start] / np.where(on_cut, rise, 1.0), 0.0)
    places = display.points[start] * (1 - share)[:, None] + display.points[stop] * share[:, None]
    edge = np.flatnonzero(on_cut)
    middle = places[edge].mean(axis=0)
    edge = edge[np.argsort(np.arctan2(places[edge, 0] - middle[0], places[edge, 2] - middle[2]))]
    return NeckCut(above.all(axis=1), start, stop, share, np.array(triangles, dtype=np.int64), edge, normal)


def neck_cap(cut: NeckCut, display: DisplaySurface) -> Surface:
    """A disk within the cut, seen from below."""
    ring = cut.of(display.points.astype(np.float64))[cut.edge]
    count = len(ring)
    j = np.arange(count)
    triangles = np.stack([(j + 1) % count, j, np.full(count, count)], axis=1)
    points = np.concatenate([ring, ring.mean(axis=0, keepdims=True)]).astype(np.float32)
    normals = np.ascontiguousarray(np.broadcast_to(-cut.normal, points.shape), dtype=np.float32)
    surface = Surface(points, normals, triangles)
    look = surface.actor.GetProperty()
    look.SetColor(*CAP)
    look.LightingOff()
    look.BackfaceCullingOn()
    return surface
