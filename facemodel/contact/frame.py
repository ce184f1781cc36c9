"""The axes of a slit of the skin: from its right to its left corner, up and forward."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from fem.types import Float32Array, FloatArray


class Axes(NamedTuple):
    """Coordinates along, above and before the middle of a slit.

    Attributes
    ----------
    middle : (3,) between its corners
    axes : (3, 3) unit vectors to its left corner, up and forward
    """

    middle: FloatArray
    axes: FloatArray

    def along(self, points: Float32Array | FloatArray) -> FloatArray:
        """Millimetres towards the left corner, of points (..., 3)."""
        return np.asarray((points - self.middle) @ self.axes[0])


def axes_between(right: FloatArray, left: FloatArray) -> Axes:
    """The axes of a slit between two corners (3,), which look as nearly forward as can be."""
    along = (left - right) / np.linalg.norm(left - right)
    forward = np.array([0.0, 0.0, 1.0]) - along[2] * along
    forward /= np.linalg.norm(forward)
    return Axes((right + left) / 2, np.stack([along, np.cross(forward, along), forward]))
