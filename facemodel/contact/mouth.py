"""The mouth as a site of contact: lips before the teeth and on each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from facemodel.contact.apart import Lips
from facemodel.contact.drawn import DrawnSlit, drawn_slit
from facemodel.contact.frame import axes_between
from facemodel.contact.laying import COLUMNS, LEAST_SHARE, Reach, column_shares
from facemodel.contact.lips import Lip, LipPair
from facemodel.contact.spread import spread_of
from facemodel.contact.teeth import BeforeTeeth, Row
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.kinematics import Stance
from facemodel.openings import mouth_of
from facemodel.smooth import smooth_step
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

LIPS = Reach(whole=(2.0, 2.0), faded=(16.0, 16.0), kept=11.5, end=0.97, joined=0.9)
"""The red of a lip gives way as a whole; nose and chin stay, so that lips that are pressed get thinner."""

ROUNDED = 10
"""Power of the way to a corner with which the depth that is kept ends there: with a lower one lips get into each other
in pursed corners, with a higher one they are torn where they crumple."""

BESIDE = 1.0
"""Millimetres beyond the points that are kept over which a lip is still looked at."""

CORNER = (0.7, 0.95)
"""Share of half the mouth from which on lips come out of the teeth together, and from where on entirely so."""

FADING = 0.06
"""Share of the depth of what is kept over which it is less and less so."""

TURNS = 2
"""How often points come out of the teeth and of single triangles of the other lip in turns: each may undo the other."""

FAR = 0.2
"""Millimetres that a point comes out of a triangle from which on there is another turn: it takes that lip's triangles
along, and others may stand in them."""

SLACK = 0.1
"""Millimetres of the clearance before the teeth that points may lose in these turns."""

SMALLEST = 1e-6
"""Millimetres of that depth, where there is none."""


class Mouth:
    """Keeps the lips of a face before its teeth and out of each other.

    Parameters
    ----------
    pair : its lips
    rows : its teeth
    rest : (n, 3) points of the site at rest
    """

    def __init__(self, pair: LipPair, rows: Sequence[Row], rest: Float32Array) -> None:
        self._lips = Lips(pair, rest)
        self._teeth = BeforeTeeth((pair.upper, pair.lower), _corners(), rows, rest)

    def move(self, here: Float32Array, stance: Stance) -> None:
        """Keep the lips of posed points (n, 3) where they can be, in place."""
        rows = self._teeth.posed(stance)
        met, close = self._teeth.give_way(here, rows)
        if met:
            self._teeth.push(here, rows, close)
        deepest, reading = self._lips.part(here)
        if reading is None:
            close[:] = True  # lips that part go farther than points that come out one by one
            self._teeth.push(here, rows, close)
            reading = self._lips.read(here)
        near = self._lips.keep_apart(here, reading, deepest)
        far = FAR
        for _ in range(TURNS):
            if not self._teeth.push(here, rows, close, SLACK) and far < FAR:
                break
            far = self._lips.bring_out(here, reading.grid, near, deepest)
            if not far:
                break
        self._lips.bring_aside(here, near, deepest)


def _corners() -> FloatArray:
    """How far each column (I,) is in a corner, from 0 to 1."""
    return smooth_step((np.abs(np.linspace(-1, 1, COLUMNS)) - CORNER[0]) / (CORNER[1] - CORNER[0]))


def lay_lips(face: Face, display: DisplaySurface, reach: Reach = LIPS) -> tuple[IntArray, LipPair] | None:
    """The live points about the mouth and its lips; none on a face without the slit of a mouth."""
    opening = mouth_of(face)
    slit = None if opening is None else drawn_slit(face, display, opening)
    if slit is None:
        return None
    axes = axes_between(*slit.corners)
    ends = reach.end * axes.along(slit.corners)
    offsets = np.linspace(ends[0], ends[1], COLUMNS)
    alike, step = replace(reach, joined=1.0), offsets[1] - offsets[0]
    beyond = np.concatenate([offsets[:1] - step, offsets, offsets[-1:] + step])
    shares = [
        [
            slit.spread(lambda *at, side=side: column_shares(axes, offsets, reach, side, *at)),
            _folded(slit.spread(lambda *at, side=side: column_shares(axes, beyond, alike, side, *at))),
        ]
        for side in (0, 1)
    ]
    along = axes.along(slit.rest)
    within = np.clip(along / (reach.corner * ends[1] / reach.end), -1, 1)
    deep = reach.kept * np.sqrt(1 - within**ROUNDED)
    kept, shown, met = slit.away < deep, slit.away < deep + BESIDE, slit.away < reach.kept + BESIDE
    met &= np.abs(along) < ends[1] / reach.end
    moved = np.any([np.abs(share).max(axis=1) > LEAST_SHARE for _, share in shares], axis=0)
    rows = np.flatnonzero(moved | kept | met)
    hold = smooth_step((deep - slit.away) / np.maximum(FADING * deep, SMALLEST))
    nearest = np.abs(along[:, None] - offsets).argmin(axis=1)
    seen = shown, met, met & (np.abs(along) > CORNER[0] * ends[1] / reach.end)
    lips = [_lip(slit, display, side, rows, hold, seen, shares[side], nearest) for side in (0, 1)]
    return rows, LipPair(axes, lips[0], lips[1])


def _folded(shares: FloatArray) -> FloatArray:
    """Shares (L, I) of columns of which one more at each end (L, I + 2) goes as the last one: so do the corners."""
    folded = shares[:, 1:-1].copy()
    folded[:, 0] += shares[:, 0]
    folded[:, -1] += shares[:, -1]
    return folded


def _lip(
    slit: DrawnSlit,
    display: DisplaySurface,
    side: int,
    rows: IntArray,
    hold: FloatArray,
    seen: tuple[BoolArray, BoolArray, BoolArray],
    shares: Sequence[FloatArray],
    nearest: IntArray,
) -> Lip:
    """One side of a mouth, 0 the upper one, in numbers of its rows.

    Parameters
    ----------
    hold : (L,) how far live points are kept on their own side, of both sides
    seen : (L,) which the reliefs are of, which are met one by one, too, and those of them that are in the corners
    shares : (L, I) how much they go with the columns of this side where lips part, and where they go the same way
    nearest : (L,) which column is the nearest
    """
    number = np.full(len(slit.rest), -1)
    number[rows] = np.arange(len(rows))
    mine = slit.upper if side == 0 else ~slit.upper
    live = display.triangles[(display.triangles < display.moving).all(axis=1)] + slit.first
    edge = (slit.edges.upper if side == 0 else slit.edges.lower) + slit.first
    of_relief, met = (np.ascontiguousarray(number[live[(some & mine)[live].all(axis=1)]]) for some in seen[:2])
    rim = np.stack([edge[:-1], edge[1:]], axis=1)
    points = np.flatnonzero((hold > 0) & mine)
    return Lip(
        1.0 if side == 0 else -1.0,
        number[points],
        hold[points],
        int(np.searchsorted(points, slit.first)),
        nearest[points],
        of_relief,
        met,
        number[seen[2] & mine],
        np.ascontiguousarray(number[rim[(number[rim] >= 0).all(axis=1)]]),
        *(spread_of(np.where(np.abs(share) > LEAST_SHARE, share, 0.0)[rows]) for share in shares),
    )
