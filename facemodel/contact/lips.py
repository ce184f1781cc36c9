"""Lips rest on each other: where a pose puts them into each other, both give way, and the skin around with them."""

from __future__ import annotations

import numpy as np

from facemodel.contact.drawn import drawn_slit
from facemodel.contact.frame import Flat, axes_between
from facemodel.contact.laying import slit_columns
from facemodel.contact.slit import Reach, SlitColumns
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.kinematics import Stance
from facemodel.openings import mouth_of
from fem.types import Float32Array, IntArray

LIPS = Reach(profile=10.0, whole=(2.0, 2.0), faded=(16.0, 16.0), kept=9.0)
"""The red of a lip gives way as a whole; nose and chin stay, so that lips that are pressed get thinner."""

SHARE = 0.5
"""What the upper lip gives way; the lower one takes the rest."""

FLATTENED = 0.25
"""Share of an overlap in which lips flatten against each other rather than give way: they are soft."""


class Lips:
    """Keeps the lips of a face from going through each other.

    Attributes
    ----------
    columns : of the mouth
    """

    def __init__(self, columns: SlitColumns, rest: Float32Array) -> None:
        self.columns = columns
        self._spared = columns.spared(rest, columns.read(rest))

    def move(self, here: Float32Array, stance: Stance) -> None:
        """Part the lips of posed points (n, 3), in place."""
        reading = self.columns.read(here)
        overlap = np.maximum(-reading.gap - self._spared.columns, 0.0)
        if not overlap.any():
            return
        way = (1 - FLATTENED) * overlap
        self.columns.part(here, reading, SHARE * way, (1 - SHARE) * way)
        self.columns.keep_apart(here, reading, (1 - SHARE) * reading.upper + SHARE * reading.lower, self._spared)


def lay_lips(face: Face, display: DisplaySurface) -> tuple[IntArray, SlitColumns] | None:
    """The live points about the mouth and its columns; none on a face without the slit of a mouth."""
    mouth = mouth_of(face)
    slit = None if mouth is None else drawn_slit(face, display, mouth)
    if slit is None:
        return None
    right, left = slit.corners
    frame = Flat((right + left) / 2, axes_between(right, left))
    return slit_columns(slit, display, frame, LIPS, np.zeros(len(slit.rest), dtype=np.bool_))
