"""The front of a row of teeth as seen from the middle of its arch: how far out it stands in every direction."""

from __future__ import annotations

from typing import NamedTuple

import igl
import numpy as np
from scipy.ndimage import map_coordinates, maximum_filter

from facemodel.compiled import compiled
from facemodel.contact.grid import beside, between
from facemodel.mesh import Mesh
from fem.types import FloatArray

BEHIND = 10.0
"""Millimetres from the back of a row to the axis from which it is seen: from there every tooth shows its front."""

DIRECTIONS, LEVELS = 128, 42
"""How finely the front is kept, along the arch and upwards: steps of about one millimetre and half of one."""

FINER = 3
"""How many times as finely it is looked at: between two places that are kept the bulge of a tooth would be missed."""

GUM = 12.0
"""Millimetres beyond its roots over which a row goes on as gum."""

ROUND = 2.0
"""How far out a row stands beyond its cutting edge less than at it, as a share of how far beyond: lips slip over it."""

FAR = 200.0
"""Millimetres from the axis: outside of every head."""

SMALLEST = 1e-6
"""Millimetres from the axis of an arch, at which there is no way out of it."""


class Arch(NamedTuple):
    """A row of teeth on a grid of directions and levels.

    Attributes
    ----------
    axis : (2,) x and z of the upright axis that the arch is seen from
    half, turn : tangent of half the angle of the first direction, from the front to the left, and steps of it
    level, rise : the lowest height, and steps upwards
    reach : (D, L) how far from the axis the front of teeth and gum stands
    """

    axis: FloatArray
    half: float
    turn: float
    level: float
    rise: float
    reach: FloatArray


@compiled
def depth_in(arch: Arch, x: float, y: float, z: float) -> tuple[float, float, float]:
    """How deep a place is in teeth and gum, below zero outside, and the x and z of the way out.

    Beside the last teeth, and above and below its grid, an arch falls back.  The way out is as long as the place is
    away from the axis: the few places that are inside make it a unit vector.
    """
    right, front = x - arch.axis[0], z - arch.axis[1]
    away = max(np.sqrt(right * right + front * front), SMALLEST)
    directions, levels = arch.reach.shape
    # The tangent of half an angle needs no arc tangent; straight behind the axis it has no end.
    half = right / max(away + front, SMALLEST)
    per_turn, per_rise = 1 / arch.turn, 1 / arch.rise
    u, v = (half - arch.half) * per_turn, (y - arch.level) * per_rise
    off = 2 * beside(u, directions) * arch.turn * away + beside(v, levels) * arch.rise
    return between(arch.reach, u, v) - ROUND * off - away, right, front


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
    halves = np.linspace(first, last, FINER * (DIRECTIONS - 1) + 1)
    root = high[1] if upwards else low[1]
    edge = (low[1] - GUM / 2) if upwards else (high[1] + GUM / 2)
    levels = np.linspace(min(root, edge), max(root, edge), FINER * (LEVELS - 1) + 1)
    reach = _seen_from_outside(mesh, axis, 2 * np.arctan(halves), levels)
    if not (reach > -FAR).any(axis=1).all():
        return None
    # From the roots to beyond the cutting edges, where the row falls back.
    columns = reach[:, ::-1].copy() if upwards else reach.copy()
    for direction, start in enumerate((columns > -FAR).argmax(axis=1)):
        columns[direction, :start] = columns[direction, start]
    fall = ROUND * (levels[1] - levels[0])
    for k in range(1, len(levels)):
        columns[:, k] = np.maximum(columns[:, k], columns[:, k - 1] - fall)
    reach = _over(columns[:, ::-1] if upwards else columns)
    return _with_gum(axis, halves[::FINER], levels[::FINER], reach, upwards)


def _over(fine: FloatArray) -> FloatArray:
    """Every `FINER`-th value of a grid both ways, raised so far that none of the others stands out between them."""
    chosen = fine[::FINER, ::FINER]
    along, up = (np.linspace(0, count - 1, FINER * (count - 1) + 1) for count in chosen.shape)
    missed = np.maximum(fine - map_coordinates(chosen, np.meshgrid(along, up, indexing="ij"), order=1), 0.0)
    return np.asarray(chosen + maximum_filter(missed, 2 * FINER - 1)[::FINER, ::FINER])


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
    turn = halves[1] - halves[0]
    return Arch(axis, float(halves[0]), float(turn), float(levels[0]), float(step), reach)
