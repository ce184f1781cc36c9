"""Ready ways to go from one key to the next."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from facemodel.animation.curve import BEZIER, Curve
from facemodel.animation.editing.keys import Places


@dataclass(frozen=True)
class Ease:
    """A course from (0, 0) to (1, 1) as a Bezier curve.

    Attributes
    ----------
    title : for people
    leaves, arrives : its inner points, shares of time and of value
    """

    title: str
    leaves: tuple[float, float]
    arrives: tuple[float, float]

    @property
    def passes(self) -> bool:
        """Whether it goes beyond one of its ends."""
        return not all(0.0 <= value <= 1.0 for value in (self.leaves[1], self.arrives[1]))


EASES: Mapping[str, Ease] = {
    "even": Ease("Even", (1 / 3, 1 / 3), (2 / 3, 2 / 3)),
    "in": Ease("Ease in", (0.42, 0.0), (1.0, 1.0)),
    "out": Ease("Ease out", (0.0, 0.0), (0.58, 1.0)),
    "in-out": Ease("Ease in and out", (0.42, 0.0), (0.58, 1.0)),
    "slow-in": Ease("Slow in", (0.7, 0.0), (0.84, 0.0)),
    "fast-in": Ease("Fast in, soft landing", (0.16, 1.0), (0.3, 1.0)),
    "sharp": Ease("Wait, then quickly", (0.9, 0.0), (0.1, 1.0)),
    "anticipate": Ease("Draw back first", (0.36, 0.0), (0.66, -0.56)),
    "overshoot": Ease("Go beyond and settle", (0.34, 1.56), (0.64, 1.0)),
}
"""By name.  Those that go beyond their ends let their curve do so."""


def eased(curve: Curve, places: Places, ease: Ease) -> Curve:
    """A curve that goes on from some keys with an ease; the last key of a curve has nowhere to go."""
    rows = np.asarray(places, dtype=np.int64)
    rows = rows[rows + 1 < len(curve)]
    steps = np.stack([curve.times[rows + 1] - curve.times[rows], curve.values[rows + 1] - curve.values[rows]], axis=1)
    handles, shapes = curve.handles.copy(), curve.shapes.copy()
    weighted, broken = curve.weighted.copy(), curve.broken.copy()
    handles[rows, 2:] = steps * ease.leaves
    handles[rows + 1, :2] = steps * (np.array(ease.arrives) - 1.0)
    shapes[rows] = BEZIER
    for flags in (weighted, broken):
        flags[rows] = flags[rows + 1] = True
    return replace(
        curve,
        shapes=shapes,
        handles=handles,
        weighted=weighted,
        broken=broken,
        overshoot=curve.overshoot or (ease.passes and len(rows) > 0),
    )
