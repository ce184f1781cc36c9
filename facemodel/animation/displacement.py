"""Expression displacement mapping (Choe 2001): a captured curve is bent to keys and keeps its fine motion.

The discrepancies d at the keys are fitted by a cubic B-spline with uniform knots, sum c_k B(t/h - k), of least norm:
with the values A_jk of its functions at the keys, c = A^T (A A^T)^-1 d.  Only functions that reach a key have a
coefficient, so the change is local, and a spline of knot spacing h holds next to nothing above the frequency 1/h.

Keys that stand closer than the knots can ask for more than such a spline can give.  What it leaves is fitted again with
knots half as far apart, and so on (Lee & Shin 1999), until every key is met; a single key never needs it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from facemodel.animation.curve import EMPTY, Curve
from fem.types import FloatArray, IntArray

SPACING = 0.25
"""Seconds between knots unless chosen: 8 knots at 30 frames a second, as in the paper's experiment."""

MET = 1e-9
"""How near a fit comes to its keys; a thousandth of what is promised."""

MOST_LEVELS = 30
"""Halvings of the knots; `SAME_TIME` between two keys is reached in 20 from any spacing below two seconds."""

WEAKEST = 0.4
"""Singular values below this share of the largest are left to the next level.  Keys nearer than a knot with different
values would else drive the coefficients, and the curve between them, far out: with 0.4 it stays within about one and a
half times the largest discrepancy, with 0.001 it leaves by a hundred times."""


@dataclass(frozen=True, eq=False)
class Displacement:
    """A layer over a captured curve, which it takes through its keys.

    Attributes
    ----------
    keys : where the curve is to be; only times and values count
    spacing : seconds between the knots; the change reaches up to `REACH` of them to either side of a key
    weight : 1 meets the keys, 0 does nothing
    muted : whether it is left out
    name : for people
    """

    keys: Curve = EMPTY
    spacing: float = SPACING
    weight: float = 1.0
    muted: bool = False
    name: str = ""

    @property
    def active(self) -> bool:
        """Whether it changes anything."""
        return not self.muted and self.weight != 0 and len(self.keys) > 0


REACH = 4
"""Knots: a cubic function spans four, and each that reaches a key counts."""


@dataclass(frozen=True, eq=False)
class Piece:
    """Uniform cubic B-splines side by side.

    Attributes
    ----------
    spacing : seconds between the knots
    first : the first function spans the knots first .. first + 4, counted from time 0
    coefficients : (n,) of as many functions, each one knot behind the other
    """

    spacing: float
    first: int
    coefficients: FloatArray


Spline = tuple[Piece, ...]
"""Pieces that are added up; nothing where none is."""


FEW_TIMES = 4
"""Up to so many times, all pieces are looked at together; with more, each only where it is."""


class Splines:
    """Many splines evaluated together.

    Parameters
    ----------
    splines : (C,) of them
    """

    def __init__(self, splines: Sequence[Spline]) -> None:
        self._count = len(splines)
        pieces = [(owner, piece) for owner, spline in enumerate(splines) for piece in spline]
        self._owner = np.array([owner for owner, _ in pieces], dtype=np.int64)
        self._spacing = np.array([piece.spacing for _, piece in pieces])
        self._first = np.array([piece.first for _, piece in pieces], dtype=np.int64)
        self._begin = self._first * self._spacing
        # Four zeros on either side of every piece stand for all that is outside of it.
        padded = [np.pad(piece.coefficients, REACH) for _, piece in pieces]
        self._lengths = np.array([len(part) for part in padded], dtype=np.int64)
        self._end = self._begin + (self._lengths - 2 * REACH + 3) * self._spacing
        self._offsets = (np.cumsum(self._lengths) - self._lengths).astype(np.int64)
        self._coefficients = np.concatenate(padded) if padded else np.zeros(0)

    def at(self, times: FloatArray) -> FloatArray:
        """Values (T, C) at times (T,)."""
        found = np.zeros((self._count, len(times)))
        if len(times) <= FEW_TIMES:
            np.add.at(found, self._owner, self._pieces_at(np.arange(len(self._owner)), times))
            return found.T
        for piece, owner in enumerate(self._owner.tolist()):
            near = (times >= self._begin[piece]) & (times <= self._end[piece])
            if near.any():
                found[owner, near] += self._pieces_at(np.array([piece]), times[near])[0]
        return found.T

    def _pieces_at(self, pieces: IntArray, times: FloatArray) -> FloatArray:
        """Values (n, T) of some pieces (n,)."""
        place = times[None, :] / self._spacing[pieces, None]
        knot = np.floor(place).astype(np.int64)
        # The functions that reach into a knot's interval begin at it and at the three knots before it.
        first, length, offset = (each[pieces, None] for each in (self._first, self._lengths, self._offsets))
        start = np.clip(knot - 3 - first + REACH, 0, length - REACH) + offset
        found = np.einsum("ltk,ltk->lt", self._coefficients[start[..., None] + np.arange(REACH)], basis(place - knot))
        return np.asarray(found)


def basis(share: FloatArray) -> FloatArray:
    """The four cubic functions (..., 4) at a share of a knot's interval, that which began first at the front."""
    t, rest = share, 1.0 - share
    return (
        np.stack(
            [
                rest**3,
                3.0 * t**3 - 6.0 * t**2 + 4.0,
                3.0 * rest**3 - 6.0 * rest**2 + 4.0,
                t**3,
            ],
            axis=-1,
        )
        / 6.0
    )


def spline_through(times: FloatArray, values: FloatArray, spacing: float) -> Spline:
    """The spline of least norm through values (K,) at increasing times (K,), with knots so many seconds apart."""
    left = values.astype(np.float64).copy()
    pieces: list[Piece] = []
    for level in range(MOST_LEVELS):
        step = spacing / 2**level
        for run in _runs(times, step):
            if np.abs(left[run]).max() > MET:
                piece, met = _fitted(times[run], left[run], step)
                pieces.append(piece)
                left[run] -= met
        if not len(left) or np.abs(left).max() <= MET:
            break
    return tuple(pieces)


def _runs(times: FloatArray, spacing: float) -> list[slice]:
    """Keys that share functions, run by run; what lies farther apart has nothing to do with each other."""
    if not len(times):
        return []
    knots = np.floor(times / spacing)
    ends = np.flatnonzero(np.diff(knots) >= REACH) + 1
    bounds = [0, *ends.tolist(), len(times)]
    return [slice(begin, end) for begin, end in pairwise(bounds)]


def _fitted(times: FloatArray, values: FloatArray, spacing: float) -> tuple[Piece, FloatArray]:
    """The piece of least norm for one run of keys, and what it comes to at them."""
    place = times / spacing
    knot = np.floor(place).astype(np.int64)
    weights = basis(place - knot)
    columns, index = np.unique((knot - 3)[:, None] + np.arange(REACH), return_inverse=True)
    system = np.zeros((len(times), len(columns)))
    system[np.arange(len(times))[:, None], index.reshape(-1, REACH)] = weights
    found = np.linalg.lstsq(system, values, rcond=WEAKEST)[0]
    coefficients = np.zeros(int(columns[-1] - columns[0]) + 1)
    coefficients[columns - columns[0]] = found
    return Piece(spacing, int(columns[0]), coefficients), system @ found


def regions(layer: Displacement) -> tuple[tuple[float, float], ...]:
    """Where a layer may change its curve: spans of seconds, in order, that do not touch."""
    if not len(layer.keys):
        return ()
    knot = np.floor(layer.keys.times / layer.spacing)
    spans = np.stack([knot - 3, knot + REACH], axis=1) * layer.spacing
    merged: list[tuple[float, float]] = []
    for begin, end in spans.tolist():
        if merged and begin <= merged[-1][1]:
            merged[-1] = (merged[-1][0], end)
        else:
            merged.append((begin, end))
    return tuple(merged)
