"""The horizontal and the upward tangent of the skin, and grain as an angle between them.

The grain is a line without arrow: 10 and 190 degrees are the same.  Means and mixtures of lines are taken of the unit
vectors at twice the angle, which are the same for both.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.types import FloatArray

UP = np.array([0.0, 1.0, 0.0])
LEFT = np.array([1.0, 0.0, 0.0])

LEVEL = 0.05
"""Sine between the skin's normal and straight up below which no tangent is horizontal for a reason: on crown and under
the chin the subject's left takes its place."""


@dataclass(frozen=True, eq=False)
class TangentFrames:
    """Orthonormal tangents at every vertex.

    Attributes
    ----------
    level : (N, 3) horizontal, to the subject's left on the front of the face
    rising : (N, 3) upward, perpendicular to it
    """

    level: FloatArray
    rising: FloatArray

    def at(self, vertices: NDArray[np.int64]) -> TangentFrames:
        """The frames of some vertices."""
        return TangentFrames(self.level[vertices], self.rising[vertices])


def tangent_frames(normals: FloatArray) -> TangentFrames:
    """Frames of unit normals (N, 3)."""
    level = np.cross(UP, normals)
    flat = np.linalg.norm(level, axis=1) < LEVEL
    level[flat] = LEFT - normals[flat] * normals[flat, :1]
    level /= np.maximum(np.linalg.norm(level, axis=1, keepdims=True), np.finfo(float).tiny)
    return TangentFrames(level, np.cross(normals, level))


def doubled(directions: FloatArray, frames: TangentFrames) -> NDArray[np.complex128]:
    """Directions (N, 3) as complex numbers (N,) at twice their angle and with their tangential length squared."""
    across = np.einsum("ij,ij->i", directions, frames.level)
    up = np.einsum("ij,ij->i", directions, frames.rising)
    return np.asarray((across + 1j * up) ** 2)


def angle_of(lines: NDArray[np.complex128]) -> FloatArray:
    """Angle (N,) in degrees from -90 up to 90 of lines as `doubled` gives them; 0 for those without direction."""
    degrees = np.degrees(np.angle(lines)) / 2
    return np.where(degrees >= 90.0, degrees - 180.0, degrees)


def line_at(degrees: FloatArray) -> NDArray[np.complex128]:
    """Lines (N,) at angles (N,)."""
    return np.asarray(np.exp(2j * np.radians(degrees)))


def direction_at(degrees: FloatArray, frames: TangentFrames) -> FloatArray:
    """Unit tangents (N, 3) at angles (N,) in degrees."""
    turn = np.radians(degrees)[:, None]
    return np.asarray(np.cos(turn) * frames.level + np.sin(turn) * frames.rising)


def turned(degrees: FloatArray, towards: FloatArray, share: FloatArray) -> FloatArray:
    """Angles (N,) turned by a share of the way to other angles, the short way round; from -90 up to 90."""
    way = (towards - degrees + 90.0) % 180.0 - 90.0
    return wrapped(degrees + share * way)


def wrapped(degrees: FloatArray) -> FloatArray:
    """The same lines with angles from -90 up to 90."""
    inside = (degrees >= -90.0) & (degrees < 90.0)
    turned_back = (degrees + 90.0) % 180.0 - 90.0
    # Just below -90 the remainder rounds up to the whole half turn.
    return np.where(inside, degrees, np.where(turned_back >= 90.0, -90.0, turned_back))
