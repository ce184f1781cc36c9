"""The front of a row of teeth as seen from the middle of its arch: how far out it stands in every direction."""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np

from facemodel.mesh import Mesh
from fem.types import Float32Array, FloatArray

BEHIND = 10.0
"""Millimetres from the back of a row to the axis from which it is seen: from there every tooth shows its front."""

DIRECTIONS, LEVELS = 64, 28
"""How finely the front is sampled, along the arch and upwards: steps of two millimetres and less than one."""

GUM = 12.0
"""Millimetres beyond its roots over which a row goes on as gum."""

ROUND = 2.0
"""How far out a row stands beyond its cutting edge less than at it, as a share of how far beyond: lips slip over it."""

FAR = 200.0
"""Millimetres from the axis: outside of every head."""


@dataclass(frozen=True, eq=False)
class Arch:
    """A row of teeth on a grid of directions and levels.

    Attributes
    ----------
    axis : (2,) x and z of the upright axis that the arch is seen from
    angles : (D,) from the front, increasing to the left; radians
    levels : (L,) increasing height
    reach : (D, L) how far from the axis the front of teeth and gum stands
    """

    axis: FloatArray
    angles: FloatArray
    levels: FloatArray
    reach: FloatArray

    def depth(self, points: Float32Array | FloatArray) -> tuple[FloatArray, FloatArray]:
        """How deep (...,) points (..., 3) are in teeth and gum, below zero outside, and the ways out (..., 3)."""
        x, z = points[..., 0] - self.axis[0], points[..., 2] - self.axis[1]
        away, angle = np.hypot(x, z), np.arctan2(x, z)
        out = np.stack([x, np.zeros_like(x), z], axis=-1) / np.maximum(away, 1e-6)[..., None]
        return self._reach_at(angle, points[..., 1]) - away, out

    def _reach_at(self, angle: FloatArray, level: FloatArray | Float32Array) -> FloatArray:
        """The reach between the grid's places; none to the sides and below the last row of the grid."""
        u = (angle - self.angles[0]) / (self.angles[1] - self.angles[0])
        v = (level - self.levels[0]) / (self.levels[1] - self.levels[0])
        inside = (u >= 0) & (u <= len(self.angles) - 1) & (v >= 0) & (v <= len(self.levels) - 1)
        i = np.clip(u.astype(np.int64), 0, len(self.angles) - 2)
        j = np.clip(v.astype(np.int64), 0, len(self.levels) - 2)
        s, t = np.clip(u - i, 0, 1), np.clip(v - j, 0, 1)
        r = self.reach
        low = r[i, j] * (1 - s) + r[i + 1, j] * s
        high = r[i, j + 1] * (1 - s) + r[i + 1, j + 1] * s
        return np.where(inside, low * (1 - t) + high * t, -FAR)


def arch_of(mesh: Mesh, upwards: bool) -> Arch | None:
    """The arch of a row of teeth; none if it shows no front.

    Parameters
    ----------
    mesh : of the row, at rest
    upwards : whether its roots are above its cutting edges, as those of the upper row are
    """
    low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
    axis = np.array([(low[0] + high[0]) / 2, low[2] + BEHIND])
    seen = np.arctan2(mesh.positions[:, 0] - axis[0], mesh.positions[:, 2] - axis[1])
    angles = np.linspace(np.quantile(seen, 0.05), np.quantile(seen, 0.95), DIRECTIONS)
    root = high[1] if upwards else low[1]
    edge = (low[1] - GUM / 2) if upwards else (high[1] + GUM / 2)
    levels = np.linspace(min(root, edge), max(root, edge), LEVELS)
    reach = _seen_from_outside(mesh, axis, angles, levels)
    if not (reach > -FAR).any(axis=1).all():
        return None
    # From the roots to beyond the cutting edges, where the row falls back.
    columns = reach[:, ::-1].copy() if upwards else reach.copy()
    for direction, start in enumerate((columns > -FAR).argmax(axis=1)):
        columns[direction, :start] = columns[direction, start]
    fall = ROUND * (levels[1] - levels[0])
    for k in range(1, LEVELS):
        columns[:, k] = np.maximum(columns[:, k], columns[:, k - 1] - fall)
    return _with_gum(axis, angles, levels, columns[:, ::-1] if upwards else columns, upwards)


def _seen_from_outside(mesh: Mesh, axis: FloatArray, angles: FloatArray, levels: FloatArray) -> FloatArray:
    """How far from the axis (D, L) the outermost surface is; minus `FAR` where there is none."""
    way = np.stack([np.sin(angles), np.zeros_like(angles), np.cos(angles)], axis=1)
    origins = np.zeros((len(angles), len(levels), 3))
    origins[..., 0], origins[..., 2] = axis
    origins += FAR * way[:, None]
    origins[..., 1] = levels
    tree = igl.AABB()
    tree.init(mesh.positions, mesh.triangles)
    back = np.broadcast_to(-way[:, None], origins.shape).reshape(-1, 3)
    met, distance, _ = tree.intersect_ray_first(
        mesh.positions, mesh.triangles, origins.reshape(-1, 3), np.ascontiguousarray(back)
    )
    return np.where(met >= 0, FAR - distance, -FAR).reshape(len(angles), len(levels))


def _with_gum(axis: FloatArray, angles: FloatArray, levels: FloatArray, reach: FloatArray, upwards: bool) -> Arch:
    """The arch with levels beyond the roots, where it stands out as far as at them."""
    step = levels[1] - levels[0]
    extra = int(np.ceil(GUM / step))
    more = step * np.arange(1, extra + 1)
    if upwards:
        levels = np.concatenate([levels, levels[-1] + more])
        reach = np.concatenate([reach, np.repeat(reach[:, -1:], extra, axis=1)], axis=1)
    else:
        levels = np.concatenate([levels[0] - more[::-1], levels])
        reach = np.concatenate([np.repeat(reach[:, :1], extra, axis=1), reach], axis=1)
    return Arch(axis, angles, levels, reach)
