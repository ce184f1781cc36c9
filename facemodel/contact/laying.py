"""Lay the columns of a slit on a face at rest."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from facemodel.contact.columns import Columns, Sheet, trace
from facemodel.contact.drawn import DrawnSlit
from facemodel.contact.frame import Frame
from facemodel.contact.slit import Reach, SlitColumns
from facemodel.display import DisplaySurface
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

COLUMNS = 25
"""Enough that the bow of a lip is followed within a tenth of a millimetre."""

FEWEST = 7
"""Columns without which a slit is too crooked to be kept shut by them."""

SAMPLES = 14
"""Places on each column."""

LEAST_SHARE = 1e-4
"""Shares of a column's motion below this are no motion."""

AROUND = 15.0
"""Millimetres beyond half the slit's width about its middle that columns may run over."""


def slit_columns(
    slit: DrawnSlit, display: DisplaySurface, frame: Frame, reach: Reach, also: BoolArray, edge: Edge | None = None
) -> tuple[IntArray, SlitColumns] | None:
    """The columns of a drawn slit and the live points (n,) that go with them; none if it cannot be cut into columns.

    Parameters
    ----------
    reach : how far the slit reaches
    also : (L,) further live points that belong to the site
    edge : finds the last place (I,) of each column that counts on places (I, J, 3) at rest; without it all of them do
    """
    right, left = frame.along(slit.corners)
    offsets = (right + left) / 2 + reach.end * (left - right) / 2 * np.linspace(-1, 1, COLUMNS)
    sides = [_traced(slit, display, frame, reach, upper, offsets) for upper in (True, False)]
    both = np.intersect1d(sides[0][1], sides[1][1])
    if len(both) < FEWEST:
        return None
    columns = [_chosen(made, np.searchsorted(kept, both)) for made, kept in sides]
    if edge is not None:
        ends = [edge(made.places(slit.rest.astype(np.float32))) for made in columns]
        columns = [_ended(made, last) for made, last in zip(columns, ends, strict=True)]
        reach = reach.beyond(float(np.median(ends)) / (SAMPLES - 1) * reach.profile)
    upper, lower = (
        slit.spread(lambda *at, side=side: column_shares(frame, offsets[both], reach, side, *at)) for side in (0, 1)
    )
    moved = (np.abs(upper).max(axis=1) > LEAST_SHARE) | (np.abs(lower).max(axis=1) > LEAST_SHARE)
    read = np.zeros(len(slit.rest), dtype=np.bool_)
    for each in columns:
        read[np.unique(each.operator.indices)] = True
    rows = np.flatnonzero(moved | read | also)
    reaching = reach.corner * (left - right) / 2
    within = np.clip((frame.along(slit.rest[rows]) - (right + left) / 2) / reaching, -1, 1)
    near = slit.away[rows] < reach.kept * np.sqrt(1 - within**8)
    return rows, SlitColumns(
        frame,
        Columns(columns[0].operator[:, rows], columns[0].count),
        Columns(columns[1].operator[:, rows], columns[1].count),
        upper[rows].astype(np.float32),
        lower[rows].astype(np.float32),
        np.flatnonzero(near & slit.upper[rows]),
        np.flatnonzero(near & ~slit.upper[rows]),
    )


def _traced(
    slit: DrawnSlit, display: DisplaySurface, frame: Frame, reach: Reach, upper: bool, offsets: FloatArray
) -> tuple[Columns, IntArray]:
    """The columns of one side of a slit; about its corners they end where the other side begins."""
    points = slit.rest[slit.first :]
    triangles = display.triangles[(display.triangles < display.moving).all(axis=1)]
    middle, half = slit.corners.mean(axis=0), np.linalg.norm(slit.corners[1] - slit.corners[0]) / 2
    near = (np.linalg.norm(points - middle, axis=1) < half + AROUND) & (slit.upper[slit.first :] == upper)
    edge = slit.edges.upper if upper else slit.edges.lower
    sheet = Sheet(points, triangles[near[triangles].all(axis=1)], slit.first, edge, reach.profile, SAMPLES)
    return trace(sheet, [frame.along(points) - offset for offset in offsets], len(slit.rest))


def _chosen(columns: Columns, numbers: IntArray) -> Columns:
    rows = (numbers[:, None] * SAMPLES + np.arange(SAMPLES)).ravel()
    return Columns(columns.operator[rows], len(numbers))


Edge = Callable[[Float32Array], IntArray]


def _ended(columns: Columns, last: IntArray) -> Columns:
    """Columns that stay at a last place from there on."""
    places = np.minimum(np.arange(SAMPLES), last[:, None]) + SAMPLES * np.arange(columns.count)[:, None]
    return Columns(columns.operator[places.ravel()], columns.count)


def column_shares(
    frame: Frame,
    offsets: FloatArray,
    reach: Reach,
    side: int,
    places: FloatArray,
    upper: BoolArray,
    away: FloatArray,
) -> FloatArray:
    """How much (n, I) places go with each column of one side, 0 the upper one: a cubic spline along the slit."""
    step = (offsets[-1] - offsets[0]) / (len(offsets) - 1)
    at = np.abs((frame.along(places)[:, None] - offsets) / step)
    along = np.where(at < 1, 2 / 3 - at**2 + at**3 / 2, np.maximum(2 - at, 0.0) ** 3 / 6)
    t = np.clip((reach.faded[side] - away) / (reach.faded[side] - reach.whole[side]), 0.0, 1.0)
    mine = upper if side == 0 else ~upper
    share = t * t * (3 - 2 * t) * mine
    if reach.joined < 1:
        middle, half = (offsets[0] + offsets[-1]) / 2, (offsets[-1] - offsets[0]) / 2 / reach.end
        t = np.clip((1 - np.abs(frame.along(places) - middle) / half) / (1 - reach.joined), 0.0, 1.0)
        share = share * t * t * (3 - 2 * t)
    return np.asarray(along * share[:, None])
