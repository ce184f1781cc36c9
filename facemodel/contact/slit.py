"""The two sides of a slit meet: how far they are apart in every column, and how the skin around goes with them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from facemodel.contact.columns import Columns
from facemodel.contact.frame import Frame
from fem.types import Float32Array, FloatArray, IntArray


@dataclass(frozen=True)
class Reach:
    """How far a slit reaches, millimetres from its edge, or from where its columns end if they do not run all the way.

    Attributes
    ----------
    profile : how far the columns run at most, from its edge
    whole, faded : up to where the skin goes with the edge, and from where on it stays, above and below
    kept : up to where a point is kept on its own side
    end : share of half the slit at which the outermost columns lie; in the corner itself both sides are one
    corner : share of it at which no point is kept any more; fewer are the nearer they are
    joined : share of it from which on less and less goes with a column; nothing at the corner, which is of both sides
    """

    profile: float
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


class Standing(Protocol):
    """Where the columns of both sides are along a slit."""

    @property
    def at(self) -> FloatArray:
        """Those of the upper side (I,), in increasing order."""
        ...

    @property
    def lower_at(self) -> FloatArray:
        """Those of the lower side (I,), in increasing order."""
        ...


@dataclass(frozen=True, eq=False)
class Reading:
    """How the sides of a slit stand in a pose.

    Attributes
    ----------
    at : (I,) where the columns of the upper side are along the slit, in increasing order
    upper : (I,) height of its lowest place
    lower : (I,) height of the highest place of the lower side below it
    lower_at : (I,) where the columns of the lower side are, in increasing order
    """

    at: FloatArray
    upper: FloatArray
    lower: FloatArray
    lower_at: FloatArray

    @property
    def gap(self) -> FloatArray:
        """How far (I,) the sides are apart; below zero where they are in each other."""
        return self.upper - self.lower


@dataclass(frozen=True, eq=False)
class SlitColumns:
    """The columns of a slit and what goes with them, on the n points of a site.

    Attributes
    ----------
    frame : which way the sides part
    upper, lower : profiles of both sides
    upper_spread, lower_spread : (n, I) how much every point goes with each column
    upper_kept, lower_kept : points that are kept on their own side
    """

    frame: Frame
    upper: Columns
    lower: Columns
    upper_spread: Float32Array
    lower_spread: Float32Array
    upper_kept: IntArray
    lower_kept: IntArray

    def read(self, here: Float32Array) -> Reading:
        """How the sides stand on posed points (n, 3) where they come nearest to each other."""
        at, upper = self._extreme(self.upper.places(here), 1.0)
        lower_at, lower = self._extreme(self.lower.places(here), -1.0)
        return Reading(at, upper, np.interp(at, lower_at, lower), lower_at)

    def read_ends(self, here: Float32Array) -> Reading:
        """How the sides stand on posed points (n, 3) where their columns end."""
        upper, lower = self.upper.places(here)[:, -1], self.lower.places(here)[:, -1]
        at, lower_at = (np.maximum.accumulate(self.frame.along(each)) for each in (upper, lower))
        return Reading(at, self.frame.height(upper), np.interp(at, lower_at, self.frame.height(lower)), lower_at)

    def _extreme(self, places: Float32Array, sign: float) -> tuple[FloatArray, FloatArray]:
        """Where each column is at its lowest (sign 1) or highest (sign -1), in order along the slit, and how high."""
        height = sign * self.frame.height(places)
        lowest = height.argmin(axis=1)[:, None]
        at = np.take_along_axis(self.frame.along(places), lowest, axis=1)[:, 0]
        return np.maximum.accumulate(at), sign * np.take_along_axis(height, lowest, axis=1)[:, 0]

    def part(self, here: Float32Array, reading: Standing, up: FloatArray, down: FloatArray) -> None:
        """Move the upper side up and the lower one down by millimetres (I,) at the upper side's columns, in place."""
        below = np.interp(reading.lower_at, reading.at, down)
        by = self.upper_spread @ up.astype(np.float32) - self.lower_spread @ below.astype(np.float32)
        self.frame.lift(here, by)

    def keep_apart(self, here: Float32Array, reading: Reading, between: FloatArray, spared: Spared) -> None:
        """Bring what is still beyond the line between the sides back onto it, in place.

        Where the sides are apart each may go up to the other one.

        Parameters
        ----------
        between : (I,) height of that line at the columns of the upper side
        spared : how far points may be beyond it, as they are at rest
        """
        free = np.maximum(reading.gap, 0.0) / 2
        for kept, sign, allowed in ((self.upper_kept, 1.0, spared.upper), (self.lower_kept, -1.0, spared.lower)):
            side = here[kept]
            beyond = self._beyond(side, sign, reading, between - sign * free) - allowed
            if (beyond > 0).any():
                self.frame.lift(side, (sign * np.maximum(beyond, 0.0)).astype(np.float32))
                here[kept] = side

    def spared(self, rest: Float32Array, reading: Reading) -> Spared:
        """How far the points of both sides are beyond the line between them at rest (n, 3)."""
        between, free = (reading.upper + reading.lower) / 2, np.maximum(reading.gap, 0.0) / 2
        upper, lower = (
            np.maximum(self._beyond(rest[kept], sign, reading, between - sign * free), 0.0)
            for kept, sign in ((self.upper_kept, 1.0), (self.lower_kept, -1.0))
        )
        return Spared(upper, lower, np.maximum(-reading.gap, 0.0))

    def _beyond(self, side: Float32Array, sign: float, reading: Reading, line: FloatArray) -> FloatArray:
        """How far points are on the wrong side of a line; less than nothing where they are on the right one."""
        height = np.interp(self.frame.along(side), reading.at, line)
        return sign * (height - self.frame.height(side))


@dataclass(frozen=True, eq=False)
class Spared:
    """How far the sides of a slit are in each other at rest, which is left as it is, millimetres.

    Attributes
    ----------
    upper, lower : of each point that is kept on its side
    columns : (I,) of the columns
    """

    upper: FloatArray
    lower: FloatArray
    columns: FloatArray
