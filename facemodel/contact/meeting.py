"""Where two lips meet: how far they are apart at every place that one has above the other, in width and depth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.contact.frame import Flat
from facemodel.contact.slit import SlitColumns
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

WIDTHS, DEPTHS = 41, 26
"""Places across and from back to front at which lips are compared: in steps of a millimetre and of half of one."""

ASIDE = 2.0
"""Millimetres beyond the outermost columns that lips are compared."""

ON = 12.0
"""Millimetres over which a lip goes on level beyond its ends, so that a short column beside a long one is no hole."""

NEXT = 0.6
"""Millimetres beyond its ends within which a lip still counts as being there: columns lie that far apart."""

FAR = 1e3
"""Millimetres; a lip that is not there is so far away."""

FLAT = 1e-4
"""Millimetres of depth below which a step of a column goes straight up."""


@dataclass(frozen=True, eq=False)
class Meeting:
    """Two lips as height fields over the same even grid of places.

    Attributes
    ----------
    at, lower_at : (I,) where the columns of both lips are along the slit, in increasing order
    left, back : the grid's first place
    step : (2,) from place to place
    upper, lower : (A, D) heights of the lips; one that is not there is `FAR` above or below
    overlap : (I,) how far the lips are in each other at the columns of the upper one; below zero where they are apart
    deepest : how far they are in each other anywhere
    """

    at: FloatArray
    lower_at: FloatArray
    left: float
    back: float
    step: FloatArray
    upper: FloatArray
    lower: FloatArray
    overlap: FloatArray
    deepest: float

    def between(self, along: FloatArray, depth: FloatArray, values: FloatArray) -> FloatArray:
        """What values (A, D) are at places (n,) along and deep in the slit; beyond the grid they go on as they are."""
        u = np.clip((along - self.left) / self.step[0], 0.0, values.shape[0] - 1)
        v = np.clip((depth - self.back) / self.step[1], 0.0, values.shape[1] - 1)
        i = np.minimum(u.astype(np.int64), values.shape[0] - 2)
        k = np.minimum(v.astype(np.int64), values.shape[1] - 2)
        s, t = u - i, v - k
        low = values[i, k] * (1 - s) + values[i + 1, k] * s
        return np.asarray(low * (1 - t) + (values[i, k + 1] * (1 - s) + values[i + 1, k + 1] * s) * t)


def meeting_of(columns: SlitColumns, frame: Flat, here: Float32Array) -> Meeting:
    """How two lips meet on posed points (n, 3)."""
    sides = [
        _Profile(frame.along(places), frame.depth(places), sign * frame.height(places))
        for places, sign in ((columns.upper.places(here), 1.0), (columns.lower.places(here), -1.0))
    ]
    left, right = _common([side.along for side in sides])
    across = np.linspace(left - ASIDE, right + ASIDE, WIDTHS)
    deep = np.linspace(*_common([side.depth for side in sides]), DEPTHS)
    step = np.array([across[1] - across[0], deep[1] - deep[0]])
    (upper, over), (lower, under) = (side.on_grid(across, deep) for side in sides)
    lower = -lower
    overlap = np.where(over & under, lower - upper, -FAR).max(axis=1)
    at, lower_at = (np.maximum.accumulate(side.along.mean(axis=1)) for side in sides)
    return Meeting(
        at, lower_at, across[0], deep[0], step, upper, lower, np.interp(at, across, overlap), float(overlap.max())
    )


def _common(values: list[FloatArray]) -> tuple[float, float]:
    """From where to where both reach, widened to something where they do not."""
    low, high = (float(f(g(each) for each in values)) for f, g in ((max, np.min), (min, np.max)))
    return low, max(high, low + 1.0)


@dataclass(frozen=True, eq=False)
class _Profile:
    """Columns (I, J) of a lip: where they are along and deep in the slit, and how high; a lower lip upside down."""

    along: FloatArray
    depth: FloatArray
    height: FloatArray

    def on_grid(self, across: FloatArray, deep: FloatArray) -> tuple[FloatArray, BoolArray]:
        """The lowest height (A, D) over an even grid, and where the lip is; a little beyond, it goes on as it is."""
        at, low = self._cut(deep)
        at = np.maximum.accumulate(at, axis=0)
        first, last = at[0], at[-1]
        shift = np.arange(len(deep)) * FAR
        asked = np.clip(across[:, None], first, last)
        filled, ends = (
            np.interp((asked + shift).T.ravel(), (at + shift).T.ravel(), each.T.ravel()).reshape(len(deep), -1).T
            for each in (low, self._beyond(deep))
        )
        aside = np.maximum(first - across[:, None], across[:, None] - last)
        there = (aside <= NEXT) & (ends <= NEXT)
        near = (aside < ON) & (ends < ON)
        return np.where(near, filled, FAR), np.asarray(there)

    def _beyond(self, deep: FloatArray) -> FloatArray:
        """How far (I, D) depths are beyond the ends of the columns; below zero within."""
        back, front = self.depth.min(axis=1)[:, None], self.depth.max(axis=1)[:, None]
        return np.asarray(np.maximum(back - deep, deep - front))

    def _cut(self, deep: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Where along the slit and how high (I, D) columns are at depths (D,), or at their ends, at their lowest.

        They go on level into the mouth from where the skin ends.
        """
        depth = np.hstack([self.depth[:, :1] - ON, self.depth])
        height, along = (np.hstack([each[:, :1], each]) for each in (self.height, self.along))
        asked = np.clip(deep, depth.min(axis=1)[:, None], depth.max(axis=1)[:, None])[:, None]
        one, other = depth[:, :-1, None], depth[:, 1:, None]
        wide = other - one
        share = (asked - one) / np.where(np.abs(wide) < FLAT, FLAT, wide)
        inside = np.clip(share, 0.0, 1.0)
        reached = height[:, :-1, None] + inside * (height[:, 1:] - height[:, :-1])[..., None]
        reached = np.where(np.abs(share - inside) < FLAT, reached, FAR)
        lowest: IntArray = reached.argmin(axis=1)
        rows = np.arange(len(lowest))[:, None]
        low = np.take_along_axis(reached, lowest[:, None], axis=1)[:, 0]
        part = np.take_along_axis(inside, lowest[:, None], axis=1)[:, 0]
        start, end = along[rows, lowest], along[rows, lowest + 1]
        return start + part * (end - start), low
