"""Lips rest on each other: where a pose puts them into each other, both give way, and the skin around with them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from facemodel.contact.drawn import drawn_slit
from facemodel.contact.frame import Flat, axes_between
from facemodel.contact.laying import slit_columns
from facemodel.contact.meeting import Meeting, meeting_of
from facemodel.contact.slit import Reach, SlitColumns
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.kinematics import Stance
from facemodel.openings import mouth_of
from fem.types import Float32Array, FloatArray, IntArray

LIPS = Reach(profile=12.0, whole=(2.0, 2.0), faded=(16.0, 16.0), kept=12.0, end=0.97, joined=0.9)
"""The red of a lip gives way as a whole; nose and chin stay, so that lips that are pressed get thinner."""

SHARE = 0.5
"""What the upper lip gives way; the lower one takes the rest."""

FLATTENED = 0.25
"""Share of an overlap in which lips flatten against each other rather than give way: they are soft."""

SOFT = 0.6
"""Millimetres that they flatten at most: more than that would crumple a lip that stands steeply on the other one."""

ROUNDS = 3
"""How often lips may give way to each other: where they have moved to they may meet other parts of each other."""

LEFT = 0.1
"""Millimetres that lips may still be in each other before they are parted once more, where they have moved to."""


SKIN = 0.05
"""Millimetres between each lip and the face between them: what is drawn is flat from point to point."""

PRESSED = 2.0
"""Millimetres of overlap from which on nothing is left to be as it is at rest: pressed lips lie flat on each other."""


class LipColumns:
    """The columns of a mouth, and how its lips are kept apart in width and depth.

    Attributes
    ----------
    columns : of the slit
    frame : its axes
    """

    def __init__(self, columns: SlitColumns, frame: Flat) -> None:
        self.columns, self.frame = columns, frame

    def meeting(self, here: Float32Array) -> Meeting:
        """How the lips of posed points (n, 3) meet."""
        return meeting_of(self.columns, self.frame, here)

    def keep_apart(self, here: Float32Array, meeting: Meeting, spared: Sequence[FloatArray] | None = None) -> None:
        """Bring what is still beyond the face between the lips back onto it, in place.

        Where the lips are apart each may go up to the other one.

        Parameters
        ----------
        spared : how far the points of the upper and of the lower lip may be beyond it; nothing if not given
        """
        for kept, sign, beyond in self._beyond(here, meeting):
            number = 0 if sign > 0 else 1
            too_far = beyond if spared is None else beyond - spared[number]
            if (too_far > 0).any():
                side = here[kept]
                self.frame.lift(side, (sign * np.maximum(too_far, 0.0)).astype(np.float32))
                here[kept] = side

    def spared(self, rest: Float32Array) -> tuple[FloatArray, FloatArray]:
        """How far the points of both lips are beyond the face between them at rest (n, 3)."""
        upper, lower = (np.maximum(beyond, 0.0) for _, _, beyond in self._beyond(rest, self.meeting(rest)))
        return upper, lower

    def _beyond(self, here: Float32Array, meeting: Meeting) -> Iterator[tuple[IntArray, float, FloatArray]]:
        """For each lip its kept points, the way out, and how far they are on the wrong side."""
        apart, middle = meeting.upper > meeting.lower, (meeting.upper + meeting.lower) / 2
        floor = np.where(apart, meeting.lower, middle) + SKIN
        ceiling = np.where(apart, meeting.upper, middle) - SKIN
        sides = ((self.columns.upper_kept, 1.0, floor), (self.columns.lower_kept, -1.0, ceiling))
        for kept, sign, limit in sides:
            side = here[kept]
            line = meeting.between(self.frame.along(side), self.frame.depth(side), limit)
            yield kept, sign, sign * (line - self.frame.height(side))


class Lips:
    """Keeps the lips of a face from going through each other.

    Parameters
    ----------
    mouth : of the face
    rest : (n, 3) points of the site at rest
    """

    def __init__(self, mouth: LipColumns, rest: Float32Array) -> None:
        self._mouth = mouth
        self._resting = np.maximum(mouth.meeting(rest).overlap, 0.0)
        self._spared = mouth.spared(rest)

    def move(self, here: Float32Array, stance: Stance) -> None:
        """Part the lips of posed points (n, 3), in place."""
        meeting = self._mouth.meeting(here)
        overlap = np.maximum(meeting.overlap - self._resting, 0.0)
        if not overlap.any():
            return
        meeting = self._give_way(here, meeting, np.minimum(FLATTENED * overlap, SOFT))
        still = 1 - min(float(overlap.max()) / PRESSED, 1.0)
        spared = [still * each for each in self._spared]
        for _ in range(ROUNDS):
            self._mouth.keep_apart(here, meeting, spared)
            meeting = self._mouth.meeting(here)
            if meeting.deepest - still * self._resting.max() < LEFT:
                break

    def _give_way(self, here: Float32Array, meeting: Meeting, soft: FloatArray) -> Meeting:
        """Part lips, in place, until no more than is soft (I,) of each column is left, and say how they meet then."""
        for _ in range(ROUNDS):
            way = np.maximum(meeting.overlap - self._resting - soft, 0.0)
            if way.max() < LEFT:
                break
            self._mouth.columns.part(here, meeting, SHARE * way, (1 - SHARE) * way)
            meeting = self._mouth.meeting(here)
        return meeting


def lay_lips(face: Face, display: DisplaySurface, reach: Reach = LIPS) -> tuple[IntArray, LipColumns] | None:
    """The live points about the mouth and its columns; none on a face without the slit of a mouth."""
    mouth = mouth_of(face)
    slit = None if mouth is None else drawn_slit(face, display, mouth)
    if slit is None:
        return None
    right, left = slit.corners
    frame = Flat((right + left) / 2, axes_between(right, left))
    laid = slit_columns(slit, display, frame, reach, np.zeros(len(slit.rest), dtype=np.bool_))
    return None if laid is None else (laid[0], LipColumns(laid[1], frame))
