"""How a curve runs between its keys: every segment as one cubic, whatever its shape.

A segment from the key at t0 to the one at t1 is a planar Bezier curve.  Its abscissa, as a share u of the segment, is
x(s) = 3 p s (1-s)^2 + 3 q s^2 (1-s) + s^3 with 0 <= p, q <= 1, which never turns back, and its ordinate is
a s^3 + b s^2 + c s + d.  With p = 1/3 and q = 2/3, as in all segments but weighted ones, s is u itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from facemodel.animation.curve import BEZIER, LINEAR, SAME_TIME, SMOOTH, STEP, Curve
from fem.types import BoolArray, FloatArray

THIRD = 1.0 / 3.0

NEWTON_STEPS = 40
"""Bracketed steps; far more than the ten that take any share to its last bit."""

LEVEL = 1e-12
"""Per second; a slower change than that takes thirty thousand years."""

SHARE_TOLERANCE = 1e-13
"""Of a segment: rounding in x(s) is a few units of 1e-16, times the steepest slope of s(u) that keys can make."""


@dataclass(frozen=True, eq=False)
class Segments:
    """The pieces of one or several curves: of each, the wait before its first key, the segments, the rest behind.

    Attributes
    ----------
    begin, length : (S,) seconds; the length of a waiting piece is 1
    cubic : (S, 4) coefficients a, b, c, d of the ordinate
    inner : (S, 2) abscissae p, q of the inner points
    """

    begin: FloatArray
    length: FloatArray
    cubic: FloatArray
    inner: FloatArray

    def values(self, pieces: np.ndarray, times: FloatArray) -> FloatArray:
        """Ordinates of some pieces (any shape) at times that broadcast against them."""
        share = (times - self.begin[pieces]) / self.length[pieces]
        inner = self.inner[pieces]
        bent = inner[..., 0] != THIRD
        bent |= inner[..., 1] != 1.0 - THIRD
        if bent.any():
            share = share.copy()
            share[bent] = parameter(share[bent], inner[bent])
        a, b, c, d = np.moveaxis(self.cubic[pieces], -1, 0)
        return np.asarray(((a * share + b) * share + c) * share + d)


def parameter(share: FloatArray, inner: FloatArray) -> FloatArray:
    """The s (n,) for which x(s) is a given share (n,), with inner points (n, 2); Newton's steps kept in a bracket."""
    p, q = inner.T
    low, high = np.zeros_like(share), np.ones_like(share)
    s = share.copy()
    for _ in range(NEWTON_STEPS):
        rest = 1.0 - s
        off = 3.0 * s * rest * (rest * p + s * q) + s**3 - share
        found = np.abs(off) <= SHARE_TOLERANCE
        if found.all():
            break
        low, high = np.where(off < 0, s, low), np.where(off > 0, s, high)
        slope = 3.0 * (rest**2 * p + 2.0 * s * rest * (q - p) + s**2 * (1.0 - q))
        with np.errstate(divide="ignore", invalid="ignore"):
            there = s - off / slope
        s = np.where(found, s, np.where((there > low) & (there < high), there, (low + high) / 2.0))
    return s


_known: WeakKeyDictionary[Curve, Segments] = WeakKeyDictionary()


def segments(curve: Curve) -> Segments:
    """The pieces of a curve of K keys, K + 1 of them; made once for each curve."""
    found = _known.get(curve)
    if found is None:
        found = _known[curve] = _segments(curve)
    return found


def joined(parts: list[Segments]) -> Segments:
    """The pieces of several curves one behind the other."""
    names = ("begin", "length", "cubic", "inner")
    return Segments(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


def slopes(curve: Curve) -> FloatArray:
    """Slope (K,) of smooth segments at every key, after Fritsch and Butland: they never pass beyond the keys.

    Between two secants the harmonic mean, level where they have different signs; level also at the ends and
    beside a step, since the curve waits there.
    """
    count = len(curve)
    found = np.zeros(count)
    if count < 3:
        return found
    steps = np.diff(curve.times)
    secants = np.diff(curve.values) / steps
    before, after = secants[:-1], secants[1:]
    first, second = 2.0 * steps[1:] + steps[:-1], steps[1:] + 2.0 * steps[:-1]
    waits = (curve.shapes[:-2] == STEP) | (curve.shapes[1:-1] == STEP)
    level = np.minimum(np.abs(before), np.abs(after)) < LEVEL
    rising = (np.sign(before) == np.sign(after)) & ~level & ~waits
    bound = first[rising] / before[rising] + second[rising] / after[rising]
    found[1:-1][rising] = (first + second)[rising] / bound
    return found


def _segments(curve: Curve) -> Segments:
    count = len(curve)
    begin, length = np.zeros(count + 1), np.ones(count + 1)
    cubic, inner = np.zeros((count + 1, 4)), np.tile([THIRD, 1.0 - THIRD], (count + 1, 1))
    if not count:
        return Segments(begin, length, cubic, inner)
    cubic[0, 3], cubic[-1, 3] = curve.values[0], curve.values[-1]
    begin[1:] = curve.times
    if count > 1:
        length[1:-1] = np.diff(curve.times)
        points, inner[1:-1] = _inner_points(curve)
        cubic[1:-1] = _polynomials(points)
    return Segments(begin, length, cubic, inner)


def _inner_points(curve: Curve) -> tuple[FloatArray, FloatArray]:
    """Ordinates (K-1, 4) of the four points of every segment, and abscissae (K-1, 2) of the inner ones as shares."""
    left, right = curve.values[:-1], curve.values[1:]
    steps = np.diff(curve.times)
    shapes = curve.shapes[:-1]
    inner = np.tile([THIRD, 1.0 - THIRD], (len(steps), 1))
    rise = slopes(curve) * THIRD
    ahead = np.where(shapes == LINEAR, (right - left) * THIRD, np.where(shapes == SMOOTH, rise[:-1] * steps, 0.0))
    behind = np.where(shapes == LINEAR, (right - left) * THIRD, np.where(shapes == SMOOTH, rise[1:] * steps, 0.0))
    bent = shapes == BEZIER
    if bent.any():
        leaving, arriving = _handles(curve, bent)
        ahead[bent], behind[bent] = leaving[bent, 1], -arriving[bent, 1]
        inner[bent] = np.stack([leaving[bent, 0], 1.0 + arriving[bent, 0]], axis=1)
    ends = np.where(shapes == STEP, left, right)
    points = np.stack([left, left + ahead, ends - behind, ends], axis=1)
    return points, inner


def _handles(curve: Curve, bent: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Inner points of Bezier segments seen from their keys: (K-1, 2) share and value ahead, and behind."""
    steps = np.diff(curve.times)
    leaving = _sides(curve.handles[:-1, 2:], steps, curve.weighted[:-1])
    arriving = _sides(curve.handles[1:, :2] * [-1.0, 1.0], steps, curve.weighted[1:])
    if not curve.overshoot:
        ahead, behind = np.ones(len(curve)), np.ones(len(curve))
        ahead[:-1] = np.where(bent, _fitting(curve.values[:-1], leaving[:, 1], curve.values), 1.0)
        behind[1:] = np.where(bent, _fitting(curve.values[1:], arriving[:, 1], curve.values), 1.0)
        both = np.minimum(ahead, behind)
        leaving[:, 1] *= np.where(curve.broken, ahead, both)[:-1]
        arriving[:, 1] *= np.where(curve.broken, behind, both)[1:]
    arriving[:, 0] *= -1.0
    return leaving, arriving


def _sides(handles: FloatArray, steps: FloatArray, weighted: BoolArray) -> FloatArray:
    """Handles (n, 2) of one side as a share of the segment and a value; no longer than the segment."""
    reach = np.maximum(handles[:, 0], 0.0)
    slope = np.divide(handles[:, 1], reach, out=np.zeros_like(reach), where=reach > SAME_TIME)
    shorter = np.divide(steps, reach, out=np.ones_like(reach), where=reach > steps)
    share = np.where(weighted, np.minimum(reach / steps, 1.0), THIRD)
    return np.stack([share, np.where(weighted, handles[:, 1] * shorter, slope * steps * THIRD)], axis=1)


def _fitting(values: FloatArray, rises: FloatArray, all_values: FloatArray) -> FloatArray:
    """By how much (n,) handles have to be levelled so that they end between the lowest and the highest key."""
    room = np.where(rises > 0, all_values.max() - values, values - all_values.min())
    size = np.abs(rises)
    return np.asarray(np.divide(room, size, out=np.ones_like(size), where=size > room))


def _polynomials(points: FloatArray) -> FloatArray:
    """Coefficients (n, 4) of the cubics with Bezier ordinates (n, 4), highest power first."""
    v0, v1, v2, v3 = points.T
    return np.stack([v3 - v0 + 3.0 * (v1 - v2), 3.0 * (v0 - 2.0 * v1 + v2), 3.0 * (v1 - v0), v0], axis=1)
