"""How far a slit of the skin reaches, and how much the points about it go with each of its columns."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from facemodel.contact.frame import Axes
from fem.types import BoolArray, FloatArray

COLUMNS = 25
"""Enough that the bow of a lip is followed within a tenth of a millimetre."""

LEAST_SHARE = 1e-4
"""Shares of a column's motion below this are no motion."""


@dataclass(frozen=True)
class Reach:
    """How far a slit reaches, millimetres from its edge, or from where its columns end if they do not run all the way.

    Attributes
    ----------
    whole, faded : up to where the skin goes with the edge, and from where on it stays, above and below
    kept : up to where a point is kept on its own side
    end : share of half the slit at which the outermost columns lie; in the corner itself both sides are one
    corner : share of it at which no point is kept any more; fewer are the nearer they are
    joined : share of it from which on less and less goes with a column; nothing at the corner, which is of both sides
    """

    whole: tuple[float, float]
    faded: tuple[float, float]
    kept: float
    end: float
    corner: float = 1.0
    joined: float = 1.0

    def beyond(self, margin: float) -> Reach:
        """The same from the edge of the slit, if the columns end so many millimetres from it."""
        (above, below), (high, low) = self.whole, self.faded
        whole, faded = (above + margin, below + margin), (high + margin, low + margin)
        return replace(self, whole=whole, faded=faded, kept=self.kept + margin)


def column_shares(
    axes: Axes,
    offsets: FloatArray,
    reach: Reach,
    side: int,
    places: FloatArray,
    upper: BoolArray,
    away: FloatArray,
) -> FloatArray:
    """How much (n, I) places go with each column of one side, 0 the upper one: a cubic spline along the slit."""
    step = (offsets[-1] - offsets[0]) / (len(offsets) - 1)
    at = np.abs((axes.along(places)[:, None] - offsets) / step)
    along = np.where(at < 1, 2 / 3 - at**2 + at**3 / 2, np.maximum(2 - at, 0.0) ** 3 / 6)
    t = np.clip((reach.faded[side] - away) / (reach.faded[side] - reach.whole[side]), 0.0, 1.0)
    mine = upper if side == 0 else ~upper
    share = t * t * (3 - 2 * t) * mine
    if reach.joined < 1:
        middle, half = (offsets[0] + offsets[-1]) / 2, (offsets[-1] - offsets[0]) / 2 / reach.end
        t = np.clip((1 - np.abs(axes.along(places) - middle) / half) / (1 - reach.joined), 0.0, 1.0)
        share = share * t * t * (3 - 2 * t)
    return np.asarray(along * share[:, None])
