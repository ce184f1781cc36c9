"""Lids follow the gaze a little, close the eye for good once they nearly do, and rest on each other when they meet."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.ball import near_eyeball
from facemodel.contact.drawn import drawn_slit
from facemodel.contact.frame import axes_between
from facemodel.contact.laying import Reach
from facemodel.contact.lid_columns import (
    LidColumns,
    Round,
    Spared,
    gap_of,
    keep_lids_apart,
    part_lids,
    read_lids,
    spared_at,
)
from facemodel.contact.lid_laying import lid_columns
from facemodel.display import DisplaySurface
from facemodel.face import Eye, Face
from facemodel.kinematics import Stance
from facemodel.openings import lids_of
from facemodel.smooth import smooth_share
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

LIDS = Reach(whole=(1.0, 0.5), faded=(9.0, 6.0), kept=2.0, end=0.96)
"""The margin of a lid goes as a whole, however thick it is; the upper lid moves up to its fold, the lower one less."""

CLOSING, CLOSED = 0.55, 0.86
"""Share of the resting opening that a pose closes in the middle, from which on lids close more than the sum of fields
says and from which on they are shut: a lid that comes so low falls onto the other one along all of its length."""

MIDDLE = 0.6
"""Columns whose resting opening is at least this share of the widest tell how far an eye is closed."""

UPPER_SHARE = 0.85
"""What the upper lid does of all closing and giving way; the lower one hardly moves when an eye closes."""

UPPER_FOLLOWS, LOWER_FOLLOWS = 0.5, 0.25
"""How far each lid goes with an eye that looks up or down, as a share of the eye's own way."""

NEARLY = 1.0
"""Millimetres between lids from which on they are made to meet exactly, the more so the nearer they are."""


class _AtRest(NamedTuple):
    """How the lids of an eye rest.

    Attributes
    ----------
    open : (I,) how far apart they are where they come nearest to each other
    wide : (I,) which columns tell how far an eye is closed
    bow : (I,) how far each goes with the gaze: lids are grown fast at their corners
    spared : how far they are in each other
    """

    open: FloatArray
    wide: BoolArray
    bow: FloatArray
    spared: Spared


class Lids:
    """Moves the lids of one eye.

    Parameters
    ----------
    columns : of the slit between the lids
    eye : behind them
    number : of the eye in its face
    rest : (n, 3) points of the site at rest
    """

    def __init__(self, columns: LidColumns, eye: Eye, number: int, rest: Float32Array) -> None:
        self._columns, self._number = columns, number
        self._radius = eye.radius
        apart = gap_of(read_lids(rest, columns, False))
        bow = 1 - np.linspace(-1, 1, columns.columns) ** 4
        spared = spared_at(rest, columns, read_lids(rest, columns, True))
        self._rest = _AtRest(apart, apart >= MIDDLE * apart.max(), bow, spared)

    def move(self, here: Float32Array, stance: Stance) -> None:
        """Move the lids of posed points (n, 3), in place."""
        _move(here, self._columns, self._rest, self._radius * np.radians(stance.posture.eyes[self._number][1]))


@compiled
def _move(here: Float32Array, columns: LidColumns, rest: _AtRest, gaze: float) -> None:
    """Move lids with an eyeball that turns up by so many millimetres, and close those that nearly are."""
    shut = smooth_share((_closure(here, columns, rest) - CLOSING) / (CLOSED - CLOSING))
    edges = read_lids(here, columns, True)
    way = rest.bow * (gaze * (1 - shut))
    followed = gap_of(edges) + (UPPER_FOLLOWS - LOWER_FOLLOWS) * way
    # Lids that close stop where they meet; what rests in each other stays so.
    wanted = np.maximum(followed, -rest.spared.columns) * np.where(followed > 0, 1 - shut, 1.0)
    change = wanted - followed
    if way.any() or change.any():
        up = UPPER_FOLLOWS * way + UPPER_SHARE * change
        down = -LOWER_FOLLOWS * way + (1 - UPPER_SHARE) * change
        part_lids(here, columns, edges, up, down)
        _finish(here, columns, rest.spared, wanted)


@compiled
def _closure(here: Float32Array, columns: LidColumns, rest: _AtRest) -> float:
    """How far the middle of an eye is closed on posed points (n, 3): 0 as at rest, 1 shut, more if lids overlap."""
    left = gap_of(read_lids(here, columns, False)) / rest.open
    return float(1 - np.median(left[rest.wide]))


@compiled
def _finish(here: Float32Array, columns: LidColumns, spared: Spared, wanted: FloatArray) -> None:
    """Take away what the spread from column to column has smoothed over where lids nearly meet, in place."""
    edges = read_lids(here, columns, True)
    nearly = np.minimum(np.maximum((NEARLY - wanted) / NEARLY, 0.0), 1.0)
    change = nearly * (wanted - gap_of(edges))
    if change.any():
        part_lids(here, columns, edges, UPPER_SHARE * change, (1 - UPPER_SHARE) * change)
        keep_lids_apart(here, columns, read_lids(here, columns, True), spared)


def lay_lids(face: Face, display: DisplaySurface, eye: Eye) -> tuple[IntArray, LidColumns] | None:
    """The live points about an eye and the columns of its lids; none on a face whose lids are not open or not known."""
    lids = lids_of(face, eye)
    slit = None if lids is None else drawn_slit(face, display, lids)
    if slit is None:
        return None
    about = Round(eye.centre, eye.radius, axes_between(*slit.corners).axes)

    def edge(places: Float32Array) -> IntArray:
        """Where the margin of a lid turns into its front: the place that stands out most, before the lid draws back."""
        forward, up = (places @ about.axes[axis] for axis in (2, 1))
        level = slit.corners.mean(axis=0) @ about.axes[1]
        return np.asarray((forward - np.abs(up - level)).argmax(axis=1))

    return lid_columns(slit, display, about, LIDS, near_eyeball(eye, slit.rest), edge)
