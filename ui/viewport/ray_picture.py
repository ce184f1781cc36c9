"""Small pictures of a surface without a graphics card, so that they can be taken away from the window's thread."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import igl
import numpy as np

from fem.types import FloatArray, IntArray
from ui.viewport.lights import FILL, GROUND, KEY, RIM, SKY, Lamp
from ui.viewport.surface import ByteArray

FINER = 2
"""Rays for each pixel, along and across, that are averaged."""

AT_ONCE = 1500
"""Rays that are followed before other threads of the program get a turn: a few milliseconds."""

Turn = Callable[[], None]
"""Called between the parts of a picture; what it raises ends it."""


@dataclass(frozen=True, eq=False)
class Standpoint:
    """Where a parallel picture is taken from.

    Attributes
    ----------
    centre : (3,) what is in its middle
    towards, up : (3,) unit vectors to the eye, and upward in the picture
    half_height : millimetres from the middle to the upper edge
    """

    centre: FloatArray
    towards: FloatArray
    up: FloatArray
    half_height: float

    @property
    def right(self) -> FloatArray:
        """Unit vector (3,) to the right of the picture."""
        return np.cross(self.up, self.towards)


@dataclass(frozen=True, eq=False)
class Painted:
    """A surface with colours.

    Attributes
    ----------
    points : (n, 3) millimetres
    triangles : (t, 3)
    colours : (n, 3) sRGB 0 to 1
    """

    points: FloatArray
    triangles: IntArray
    colours: FloatArray


def joined(*surfaces: Painted) -> Painted:
    """Several surfaces as one."""
    first = np.cumsum([0, *(len(each.points) for each in surfaces)])
    return Painted(
        np.concatenate([each.points for each in surfaces]),
        np.concatenate([each.triangles + start for each, start in zip(surfaces, first, strict=False)]),
        np.concatenate([each.colours for each in surfaces]),
    )


def ray_picture(surface: Painted, at: Standpoint, size: tuple[int, int], turn: Turn = lambda: None) -> ByteArray:
    """A picture (height, width, 4) of a surface, clear where there is none.

    Parameters
    ----------
    surface : what is seen
    at : from where
    size : width and height in pixels
    turn : called every few milliseconds; other threads run meanwhile
    """
    width, height = (FINER * side for side in size)
    step = 2 * at.half_height / height
    across = (np.arange(width) - (width - 1) / 2) * step
    upward = ((height - 1) / 2 - np.arange(height)) * step
    near = _within(surface, at, float(np.abs(across).max()) + step)
    if not len(near):
        return np.zeros((size[1], size[0], 4), dtype=np.uint8)
    far = float(((surface.points - at.centre) @ at.towards).max()) + 1.0
    starts = at.centre + far * at.towards + upward[:, None, None] * at.up + across[:, None] * at.right
    points = np.ascontiguousarray(surface.points, dtype=np.float64)
    met, shares = _hits(points, near, starts.reshape(-1, 3), -at.towards, turn)
    seen = met >= 0
    corners, share = near[met[seen]], shares[seen]
    normals = _normals(points, near)
    normal = np.einsum("pk,pkc->pc", share, normals[corners])
    colour = np.einsum("pk,pkc->pc", share, surface.colours[corners])
    fine = np.zeros((height * width, 4))
    fine[seen] = np.column_stack([_lit(normal, colour, at), np.ones(len(share))])
    fine[:, :3] *= fine[:, 3:]
    mean = fine.reshape(size[1], FINER, size[0], FINER, 4).mean(axis=(1, 3))
    mean[..., :3] /= np.maximum(mean[..., 3:], 1e-6)
    return np.ascontiguousarray(np.clip(255 * mean + 0.5, 0, 255), dtype=np.uint8)


def _within(surface: Painted, at: Standpoint, half_width: float) -> IntArray:
    """The triangles (m, 3) that may be seen in a picture."""
    offset = surface.points - at.centre
    inside = (np.abs(offset @ at.right) < half_width + 8.0) & (np.abs(offset @ at.up) < at.half_height + 8.0)
    return np.ascontiguousarray(surface.triangles[inside[surface.triangles].any(axis=1)], dtype=np.int64)


def _hits(
    points: FloatArray, triangles: IntArray, starts: FloatArray, along: FloatArray, turn: Turn
) -> tuple[IntArray, FloatArray]:
    """The triangle (n,) that each ray meets first, -1 for none, and the shares (n, 3) of its corners."""
    tree = igl.AABB()
    tree.init(points, triangles)
    met = np.full(len(starts), -1, dtype=np.int64)
    shares = np.zeros((len(starts), 3))
    for first in range(0, len(starts), AT_ONCE):
        rays = np.ascontiguousarray(starts[first : first + AT_ONCE])
        ways = np.ascontiguousarray(np.broadcast_to(along, rays.shape))
        found, _, inner = tree.intersect_ray_first(points, triangles, rays, ways)
        found = np.reshape(found, -1)
        # The shares of a ray that meets nothing are memory that nobody wrote.
        hit = np.flatnonzero(found >= 0)
        inner = np.reshape(inner, (len(rays), -1))[hit, :2]
        met[first : first + len(rays)] = found
        shares[first + hit] = np.column_stack([1 - inner.sum(axis=1), inner])
        # Who waits for the interpreter gets it while this thread sleeps.
        time.sleep(0)
        turn()
    return met, shares


def _normals(points: FloatArray, triangles: IntArray) -> FloatArray:
    """Unit normals (n, 3) of the corners of some triangles."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    face = np.cross(b - a, c - a)
    total = np.stack(
        [np.bincount(triangles.ravel(), np.repeat(face[:, axis], 3), len(points)) for axis in range(3)], axis=1
    )
    return np.asarray(total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12))


def _lit(normal: FloatArray, colour: FloatArray, at: Standpoint) -> FloatArray:
    """Colours (n, 3) under the lamps of the viewport, which stand where the eye is."""
    frame = np.stack([at.right, at.up, at.towards])
    turned = normal @ frame.T
    turned /= np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-9)
    around = np.array(GROUND) + (0.5 + 0.5 * turned[:, 1:2]) * (np.array(SKY) - np.array(GROUND))
    light = around + sum(_from(lamp, turned) for lamp in (KEY, FILL, RIM))
    seen = colour**2 * light
    return np.clip(np.sqrt(seen * (1 + 0.12 * seen) / (1 + 0.42 * seen)), 0, 1)


def _from(lamp: Lamp, normal: FloatArray) -> FloatArray:
    return np.maximum(normal @ np.array(lamp.direction), 0.0)[:, None] * np.array(lamp.colour)
