"""The edge of the lids: where the skin leaves the eyeball, as a closed line that moves with the skin."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Eye
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

NEAR = 1.6
"""Radii of the eyeball within which its lids lie."""
REACH, FOLD = 5, 0.8
"""Points to both sides that are compared, and how many millimetres farther out one may lie."""

FEWEST = 12
"""Points of a line that goes round an eye."""


@dataclass(frozen=True, eq=False)
class LidLine:
    """A closed line round an eye on the drawn skin.

    Attributes
    ----------
    start, stop : (n,) drawn points at the ends of the edges that the line crosses
    share : (n,) how far from ``start`` to ``stop``
    """

    start: IntArray
    stop: IntArray
    share: FloatArray

    @property
    def closed(self) -> bool:
        """Whether there are lids at all; a scan without openings has none."""
        return len(self.start) >= FEWEST

    def places(self, points: Float32Array) -> FloatArray:
        """The line (n, 3) on the posed skin ``points`` (P, 3), in order round the eye."""
        share = self.share[:, None]
        return np.asarray(points[self.start] * (1 - share) + points[self.stop] * share, dtype=np.float64)


def lid_line(display: DisplaySurface, eye: Eye, lift: float) -> LidLine:
    """Where the resting lids stand ``lift`` millimetres above the eyeball.

    Parameters
    ----------
    display : the drawn skin
    eye : the eyeball that the lids lie on
    lift : zero for the line at which the eye becomes visible, more for one farther out on the lids
    """
    offset = display.points - eye.centre
    radius = np.linalg.norm(offset, axis=1)
    near = (radius < NEAR * eye.radius) & (offset[:, 2] > 0.2 * eye.radius)
    triangles = display.triangles[near[display.triangles].all(axis=1)]
    edges = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    height = radius - eye.radius - lift
    low, high = np.sort(height[edges], axis=1).T
    crossed = edges[(low < 0) & (high >= 0)]
    a, b = height[crossed].T
    share = a / (a - b)
    if len(crossed) < FEWEST:
        return LidLine(crossed[:0, 0], crossed[:0, 1], share[:0])
    places = display.points[crossed[:, 0]] * (1 - share)[:, None] + display.points[crossed[:, 1]] * share[:, None]
    middle = (places.min(axis=0) + places.max(axis=0)) / 2
    order = np.argsort(np.arctan2(places[:, 1] - middle[1], places[:, 0] - middle[0]))
    order = order[_innermost(np.linalg.norm(places[order] - middle, axis=1))]
    return LidLine(crossed[order, 0], crossed[order, 1], share[order])


def _innermost(distance: FloatArray) -> BoolArray:
    """Which points of a closed line (n,) are not behind a nearer stretch of it: where the lid lies flat on the
    eyeball, the height is met more than once.
    """
    around = np.stack([np.roll(distance, k) for k in range(-REACH, REACH + 1)])
    return np.asarray(distance < around.min(axis=0) + FOLD)
