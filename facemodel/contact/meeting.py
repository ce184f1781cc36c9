"""Where two lips meet: how far they are apart at every place that one has above the other, in width and depth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.contact.frame import Flat
from facemodel.contact.slit import Reading, SlitColumns
from fem.types import Float32Array, FloatArray, IntArray

DEPTHS = 12
"""Places from the back to the front at which lips are compared in every column: steps of half a millimetre."""

SHALLOWEST = 0.05
"""Millimetres; lips that are over each other for less than this meet by their lowest and highest places."""


@dataclass(frozen=True, eq=False)
class Meeting:
    """Two lips as height fields over the same places.

    Attributes
    ----------
    at : (I,) where the columns are along the slit, in increasing order
    lower_at : (I,) the same of the columns of the lower lip
    back, front : (I,) depths between which one lip is above the other
    upper, lower : (I, K) heights of the lips there, at depths that are evenly spaced
    """

    at: FloatArray
    lower_at: FloatArray
    back: FloatArray
    front: FloatArray
    upper: FloatArray
    lower: FloatArray

    @property
    def gap(self) -> FloatArray:
        """How far (I,) the lips are apart where they are nearest in each column; below zero if in each other."""
        return np.asarray((self.upper - self.lower).min(axis=1))

    @property
    def reading(self) -> Reading:
        """The lips where they are nearest in each column."""
        nearest = (self.upper - self.lower).argmin(axis=1)[:, None]
        upper, lower = (np.take_along_axis(each, nearest, axis=1)[:, 0] for each in (self.upper, self.lower))
        return Reading(self.at, upper, lower, self.lower_at)

    def between(self, along: FloatArray, depth: FloatArray, values: FloatArray) -> FloatArray:
        """What values (I, K) are at places (n,) along and deep in the slit; at its ends they go on as they are."""
        column = np.interp(along, self.at, np.arange(len(self.at)))
        back, front = np.interp(along, self.at, self.back), np.interp(along, self.at, self.front)
        step = np.clip((depth - back) / np.maximum(front - back, SHALLOWEST), 0.0, 1.0) * (values.shape[1] - 1)
        i = np.minimum(column.astype(np.int64), len(self.at) - 2)
        k = np.minimum(step.astype(np.int64), values.shape[1] - 2)
        s, t = column - i, step - k
        low = values[i, k] * (1 - s) + values[i + 1, k] * s
        return np.asarray(low * (1 - t) + (values[i, k + 1] * (1 - s) + values[i + 1, k + 1] * s) * t)


def meeting_of(columns: SlitColumns, frame: Flat, here: Float32Array) -> Meeting:
    """How two lips meet on posed points (n, 3)."""
    upper, below = columns.upper.places(here), columns.lower.places(here)
    at, lower_at = (np.maximum.accumulate(frame.along(each).mean(axis=1)) for each in (upper, below))
    lower = _across(below, np.interp(at, lower_at, np.arange(len(lower_at))))
    depths, heights = [frame.depth(upper), frame.depth(lower)], [frame.height(upper), frame.height(lower)]
    back = np.maximum(depths[0].min(axis=1), depths[1].min(axis=1))
    front = np.minimum(depths[0].max(axis=1), depths[1].max(axis=1))
    there = back[:, None] + np.linspace(0.02, 0.98, DEPTHS) * (front - back)[:, None]
    low = -_highest(depths[0], -heights[0], there)
    high = _highest(depths[1], heights[1], there)
    apart = front - back < SHALLOWEST
    low[apart] = heights[0][apart].min(axis=1, keepdims=True)
    high[apart] = heights[1][apart].max(axis=1, keepdims=True)
    return Meeting(at, lower_at, back, np.maximum(front, back), low, high)


def _across(places: Float32Array, column: FloatArray) -> Float32Array:
    """Places (I, J, 3) between columns (I,) that need not be whole numbers."""
    i: IntArray = np.minimum(column.astype(np.int64), len(places) - 2)
    share = (column - i)[:, None, None].astype(np.float32)
    return np.asarray(places[i] * (1 - share) + places[i + 1] * share)


def _highest(depth: FloatArray, height: FloatArray, there: FloatArray) -> FloatArray:
    """The highest (I, K) that chains of places (I, J) reach at some depths (I, K)."""
    one, other = depth[:, :-1, None], depth[:, 1:, None]
    wide = np.where(np.abs(other - one) < FLAT, FLAT, other - one)
    share = (there[:, None] - one) / wide
    reached = height[:, :-1, None] + np.clip(share, 0.0, 1.0) * (height[:, 1:] - height[:, :-1])[..., None]
    met = (share >= 0) & (share <= 1)
    found = np.where(met, reached, -np.inf).max(axis=1)
    return np.asarray(np.where(np.isfinite(found), found, height.max(axis=1, keepdims=True)))


FLAT = 1e-4
"""Millimetres of depth below which a step of a column goes straight up."""
