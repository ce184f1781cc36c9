"""In which direction the two sides of a slit part: straight up for lips, round the eyeball for lids."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from fem.types import Float32Array, FloatArray

Points = Float32Array | FloatArray


class Frame(Protocol):
    """Coordinates along and across a slit."""

    def along(self, points: Points) -> FloatArray:
        """Millimetres from the middle of the slit towards its left corner, of points (..., 3)."""
        ...

    def height(self, points: Points) -> FloatArray:
        """Millimetres upwards, of points (..., 3)."""
        ...

    def lift(self, points: Float32Array, by: Float32Array) -> None:
        """Move points (n, 3) upwards by millimetres (n,), in place."""
        ...


@dataclass(frozen=True, eq=False)
class Flat:
    """Up is the same everywhere.

    Attributes
    ----------
    middle : (3,) of the slit
    axes : (3, 3) unit vectors to its left corner, up and forward
    """

    middle: FloatArray
    axes: FloatArray

    def along(self, points: Points) -> FloatArray:
        """See `Frame`."""
        return np.asarray((points - self.middle) @ self.axes[0])

    def height(self, points: Points) -> FloatArray:
        """See `Frame`."""
        return np.asarray((points - self.middle) @ self.axes[1])

    def depth(self, points: Points) -> FloatArray:
        """Millimetres forward, of points (..., 3)."""
        return np.asarray((points - self.middle) @ self.axes[2])

    def lift(self, points: Float32Array, by: Float32Array) -> None:
        """See `Frame`."""
        points += by[:, None] * self.axes[1].astype(np.float32)


@dataclass(frozen=True, eq=False)
class Round:
    """Things go up round an eyeball, about the axis through its centre from corner to corner.

    Attributes
    ----------
    centre : (3,) of the eyeball
    radius : of it, millimetres
    axes : (3, 3) unit vectors to the left corner, up and forward
    """

    centre: FloatArray
    radius: float
    axes: FloatArray

    def along(self, points: Points) -> FloatArray:
        """See `Frame`."""
        return np.asarray((points - self.centre) @ self.axes[0])

    def height(self, points: Points) -> FloatArray:
        """See `Frame`; millimetres on the eyeball, so that a lid's margin, which points at its centre, is level."""
        offset = points - self.centre
        return np.asarray(self.radius * np.arctan2(offset @ self.axes[1], offset @ self.axes[2]))

    def lift(self, points: Float32Array, by: Float32Array) -> None:
        """See `Frame`; each point keeps its distance from the axis."""
        up, forward = self.axes[1].astype(np.float32), self.axes[2].astype(np.float32)
        offset = points - self.centre.astype(np.float32)
        high, far = offset @ up, offset @ forward
        angle = by / np.float32(self.radius)
        sine, cosine = np.sin(angle), np.cos(angle)
        points += ((cosine - 1) * high + sine * far)[:, None] * up
        points += ((cosine - 1) * far - sine * high)[:, None] * forward


def axes_between(right: FloatArray, left: FloatArray) -> FloatArray:
    """Axes (3, 3) of a slit between two corners (3,): to the left one, up, and as nearly forward as can be."""
    along = (left - right) / np.linalg.norm(left - right)
    forward = np.array([0.0, 0.0, 1.0]) - along[2] * along
    forward /= np.linalg.norm(forward)
    return np.stack([along, np.cross(forward, along), forward])
