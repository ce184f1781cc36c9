"""Cut the lids of a face at rest into columns."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from facemodel.contact.columns import Columns, Sheet, trace
from facemodel.contact.drawn import DrawnSlit
from facemodel.contact.frame import Axes
from facemodel.contact.laying import COLUMNS, LEAST_SHARE, Reach, column_shares
from facemodel.contact.lid_columns import Lid, LidColumns, Round
from facemodel.contact.spread import spread_of
from facemodel.display import DisplaySurface
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

FEWEST = 7
"""Columns without which a slit is too crooked to be kept shut by them."""

SAMPLES = 14
"""Places on each column."""

PROFILE = 8.0
"""Millimetres that the columns run from the edge of a lid at most."""

AROUND = 15.0
"""Millimetres beyond half the slit's width about its middle that columns may run over."""


Edge = Callable[[Float32Array], IntArray]
"""Finds the last place (I,) of each column that counts on places (I, J, 3) at rest."""


def lid_columns(
    slit: DrawnSlit, display: DisplaySurface, about: Round, reach: Reach, also: BoolArray, edge: Edge
) -> tuple[IntArray, LidColumns] | None:
    """The columns of drawn lids and the live points (n,) that go with them; none if they cannot be cut into columns.

    Parameters
    ----------
    about : the eyeball that they turn about
    reach : how far the slit reaches
    also : (L,) further live points that belong to the site
    edge : finds where the columns end
    """
    axes = Axes(about.centre, about.axes)
    right, left = axes.along(slit.corners)
    offsets = (right + left) / 2 + reach.end * (left - right) / 2 * np.linspace(-1, 1, COLUMNS)
    sides = [_traced(slit, display, axes, upper, offsets) for upper in (True, False)]
    both = np.intersect1d(sides[0][1], sides[1][1])
    if len(both) < FEWEST:
        return None
    columns = [_chosen(made, np.searchsorted(kept, both)) for made, kept in sides]
    ends = [edge(made.places(slit.rest.astype(np.float32))) for made in columns]
    columns = [_ended(made, last) for made, last in zip(columns, ends, strict=True)]
    reach = reach.beyond(float(np.median(ends)) / (SAMPLES - 1) * PROFILE)
    shares = [
        slit.spread(lambda *at, side=side: column_shares(axes, offsets[both], reach, side, *at)) for side in (0, 1)
    ]
    moved = np.any([np.abs(share).max(axis=1) > LEAST_SHARE for share in shares], axis=0)
    read = np.zeros(len(slit.rest), dtype=np.bool_)
    for each in columns:
        read[np.unique(each.operator.indices)] = True
    rows = np.flatnonzero(moved | read | also)
    within = np.clip((axes.along(slit.rest[rows]) - (right + left) / 2) / (reach.corner * (left - right) / 2), -1, 1)
    near = slit.away[rows] < reach.kept * np.sqrt(1 - within**8)
    upper, lower = (
        _lid(sign, made, rows, share, np.flatnonzero(near & (slit.upper[rows] == (sign > 0))))
        for sign, made, share in zip((1.0, -1.0), columns, shares, strict=True)
    )
    return rows, LidColumns(about, upper, lower, len(both))


def _lid(sign: float, columns: Columns, rows: IntArray, shares: FloatArray, kept: IntArray) -> Lid:
    """One side in numbers of the rows of its site."""
    operator = columns.operator[:, rows]
    spread = spread_of(np.where(np.abs(shares) > LEAST_SHARE, shares, 0.0)[rows])
    return Lid(
        sign,
        operator.indptr.astype(np.int64),
        operator.indices.astype(np.int64),
        operator.data.astype(np.float64),
        spread,
        kept,
    )


def _traced(
    slit: DrawnSlit, display: DisplaySurface, axes: Axes, upper: bool, offsets: FloatArray
) -> tuple[Columns, IntArray]:
    """The columns of one side of a slit; about its corners they end where the other side begins."""
    points = slit.rest[slit.first :]
    triangles = display.triangles[(display.triangles < display.moving).all(axis=1)]
    middle, half = slit.corners.mean(axis=0), np.linalg.norm(slit.corners[1] - slit.corners[0]) / 2
    near = (np.linalg.norm(points - middle, axis=1) < half + AROUND) & (slit.upper[slit.first :] == upper)
    edge = slit.edges.upper if upper else slit.edges.lower
    sheet = Sheet(points, triangles[near[triangles].all(axis=1)], slit.first, edge, PROFILE, SAMPLES)
    return trace(sheet, [axes.along(points) - offset for offset in offsets], len(slit.rest))


def _chosen(columns: Columns, numbers: IntArray) -> Columns:
    rows = (numbers[:, None] * SAMPLES + np.arange(SAMPLES)).ravel()
    return Columns(columns.operator[rows], len(numbers))


def _ended(columns: Columns, last: IntArray) -> Columns:
    """Columns that stay at a last place from there on."""
    places = np.minimum(np.arange(SAMPLES), last[:, None]) + SAMPLES * np.arange(columns.count)[:, None]
    return Columns(columns.operator[places.ravel()], columns.count)
