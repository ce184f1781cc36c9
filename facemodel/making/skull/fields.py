"""Shapes as signed distances, to be joined, cut and blended: negative inside, millimetres."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import PchipInterpolator

from fem.types import FloatArray


def smooth_max(a: FloatArray, b: FloatArray, width: float) -> FloatArray:
    """Intersection of two shapes with the edge rounded over a width in millimetres."""
    overlap = np.maximum(width - np.abs(a - b), 0.0)
    return np.asarray(np.maximum(a, b) + overlap**2 / (4 * width))


def smooth_min(a: FloatArray, b: FloatArray, width: float) -> FloatArray:
    """Union of two shapes with the crease filled over a width in millimetres."""
    return -smooth_max(-a, -b, width)


def carved(a: FloatArray, tool: FloatArray, width: float) -> FloatArray:
    """What is left of a shape when a tool is taken out of it, the edge rounded over a width in millimetres."""
    return smooth_max(a, -tool, width)


def ellipsoid(p: FloatArray, centre: Sequence[float], radii: Sequence[float]) -> FloatArray:
    """Ellipsoid at points (n, 3); a distance near its surface, which is where it matters."""
    r = np.asarray(radii)
    d = (p - centre) / r
    level = np.linalg.norm(d, axis=1)
    slope = np.linalg.norm(d / r, axis=1)
    return np.asarray(level * (level - 1) / np.maximum(slope, 1e-9))


def rod(p: FloatArray, path: Sequence[Sequence[float]], radii: Sequence[float]) -> FloatArray:
    """Round bar along a polyline whose radius changes linearly between the knots."""
    knots = np.asarray(path, dtype=np.float64)
    best = np.full(len(p), np.inf)
    for a, b, ra, rb in zip(knots[:-1], knots[1:], radii[:-1], radii[1:], strict=True):
        t = np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        best = np.minimum(best, np.linalg.norm(p - a - t[:, None] * (b - a), axis=1) - ra - t * (rb - ra))
    return best


def outline(u: FloatArray, v: FloatArray, corners: Sequence[Sequence[float]]) -> FloatArray:
    """Signed distance (n,) in a plane to a closed polygon (m, 2) of any orientation."""
    c = np.asarray(corners, dtype=np.float64)
    best = np.full(len(u), np.inf)
    inside = np.zeros(len(u), dtype=np.bool_)
    for (au, av), (bu, bv) in zip(c, np.roll(c, -1, axis=0), strict=True):
        du, dv = bu - au, bv - av
        t = np.clip(((u - au) * du + (v - av) * dv) / (du * du + dv * dv), 0, 1)
        best = np.minimum(best, (u - au - t * du) ** 2 + (v - av - t * dv) ** 2)
        if dv != 0:
            inside ^= ((av > v) != (bv > v)) & (u < au + (v - av) * du / dv)
    return np.asarray(np.where(inside, -1.0, 1.0) * np.sqrt(best))


def along(x: FloatArray, knots: Sequence[tuple[float, float]]) -> FloatArray:
    """Smooth function through (x, value) knots that never overshoots them, level beyond the ends."""
    at, value = zip(*sorted(knots), strict=True)
    return np.asarray(PchipInterpolator(at, value)(np.clip(x, at[0], at[-1])))
