"""The front of a row of teeth as seen from the middle of its arch: how far out it stands in every direction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import igl
import numpy as np

from facemodel.compiled import compiled
from facemodel.mesh import Mesh
from fem.types import FloatArray

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

SMALLEST = 1e-6
"""Millimetres from the axis of an arch, at which there is no way out of it."""


@dataclass(frozen=True, eq=False)
class Arch:
    """A row of teeth on a grid of directions and levels.

    Attributes
    ----------
    axis : (2,) x and z of the upright axis that the arch is seen from
    halves : (D,) tangents of half the angle from the front, evenly spaced, increasing to the left
    levels : (L,) increasing height
    reach : (D, L) how far from the axis the front of teeth and gum stands
    """

    axis: FloatArray
    halves: FloatArray
    levels: FloatArray
    reach: FloatArray

    @property
    def grid(self) -> ArchGrid:
        """The same for `depth_in`."""
        turn, rise = self.halves[1] - self.halves[0], self.levels[1] - self.levels[0]
        return ArchGrid(self.axis, float(self.halves[0]), float(turn), float(self.levels[0]), float(rise), self.reach)


class ArchGrid(NamedTuple):
    """An arch as numbers.

    Attributes
    ----------
    axis, reach : see `Arch`
    half, level : the first of each
    turn, rise : steps between them
    """

    axis: FloatArray
    half: float
    turn: float
    level: float
    rise: float
    reach: FloatArray


@compiled
def depth_in(arch: ArchGrid, x: float, y: float, z: float) -> tuple[float, float, float]:
    """How deep a place is in teeth and gum, below zero outside, and the x and z of the way out.

    Beside the last teeth, and above and below its grid, an arch falls back.
    """
    right, front = x - arch.axis[0], z - arch.axis[1]
    away = max(np.sqrt(right * right + front * front), SMALLEST)
    directions, levels = arch.reach.shape
    # The tangent of half an angle needs no arc tangent; straight behind the axis it has no end.
    half = right / max(away + front, SMALLEST)
    u, v = (half - arch.half) / arch.turn, (y - arch.level) / arch.rise
    inside_u, inside_v = min(max(u, 0.0), directions - 1.0), min(max(v, 0.0), levels - 1.0)
    beside = 2 * abs(u - inside_u) * arch.turn * away + abs(v - inside_v) * arch.rise
    i, k = min(int(inside_u), directions - 2), min(int(inside_v), levels - 2)
    s, t = inside_u - i, inside_v - k
    low = arch.reach[i, k] * (1 - s) + arch.reach[i + 1, k] * s
    high = arch.reach[i, k + 1] * (1 - s) + arch.reach[i + 1, k + 1] * s
    reach = low * (1 - t) + high * t - ROUND * beside
    return reach - away, right / away, front / away


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
    first, last = np.tan(np.quantile(seen, [0.05, 0.95]) / 2)
    halves = np.linspace(first, last, DIRECTIONS)
    root = high[1] if upwards else low[1]
    edge = (low[1] - GUM / 2) if upwards else (high[1] + GUM / 2)
    levels = np.linspace(min(root, edge), max(root, edge), LEVELS)
    reach = _seen_from_outside(mesh, axis, 2 * np.arctan(halves), levels)
    if not (reach > -FAR).any(axis=1).all():
        return None
    # From the roots to beyond the cutting edges, where the row falls back.
    columns = reach[:, ::-1].copy() if upwards else reach.copy()
    for direction, start in enumerate((columns > -FAR).argmax(axis=1)):
        columns[direction, :start] = columns[direction, start]
    fall = ROUND * (levels[1] - levels[0])
    for k in range(1, LEVELS):
        columns[:, k] = np.maximum(columns[:, k], columns[:, k - 1] - fall)
    return _with_gum(axis, halves, levels, columns[:, ::-1] if upwards else columns, upwards)


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


def _with_gum(axis: FloatArray, halves: FloatArray, levels: FloatArray, reach: FloatArray, upwards: bool) -> Arch:
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
    return Arch(axis, halves, levels, reach)
