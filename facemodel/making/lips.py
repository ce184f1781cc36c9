"""Close the lips of a head at rest: those of the base mesh gape beside the middle or run through each other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.ndimage import maximum_filter1d

from facemodel.chart import make_chart
from facemodel.contact.contact import live_at_rest
from facemodel.contact.laying import COLUMNS
from facemodel.contact.lips import LipPair
from facemodel.contact.mouth import LIPS, lay_lips
from facemodel.face import Face
from facemodel.making.corners import with_smooth_corners
from facemodel.sampling import ELEMENTS, display_surface, head_surface, points_of_vertices
from fem.types import Float32Array, FloatArray

TOUCH = 0.05
"""Millimetres between lips that rest on each other: what is drawn of them may round by so much."""

ROUNDS = 10
"""Each takes away what the smooth surface through the moved vertices makes of the last one."""

FLATTENED = 0.2
"""Share of what lips are in each other by which they flatten rather than part: they are soft."""

TOGETHER = 3
"""Neighbouring columns that part as the one of them which is deepest in the other lip does, if one is at all: they
share vertices, and lips that close beside it would put it back there."""

APART = 8.0
"""Millimetres; lips farther apart than that at rest are not one above the other."""

DENSITY = 3
"""Segments per edge of an element on which the lips are compared, as they are drawn."""


CLOSING = replace(LIPS, end=0.93, corner=0.93, joined=1.0)
"""The skin of the corners is left as it is: closed by force it would be drawn out, and with it the chart."""


def with_closed_lips(face: Face) -> Face:
    """A face whose lips touch from corner to corner; a face without the slit of a mouth stays as it is.

    Both lips move alike, the skin between nose and chin smoothly with them, and the lining of the mouth as it is
    carried.  Where the corners are squeezed by it they are smoothed again.
    """
    for _ in range(ROUNDS):
        display = display_surface(face, head_surface(face, ELEMENTS["hct12"]), DENSITY)
        laid = lay_lips(face, display, CLOSING)
        if laid is None:
            return face
        rows, mouth = laid
        live = live_at_rest(face, display)
        here = live[rows]
        lacking = TOUCH + _gone_through(mouth, here)
        beside = maximum_filter1d(lacking, TOGETHER)
        lacking = np.where(beside > TOUCH, beside, lacking)
        # In the very corner both lips are one.
        way = (1 - np.linspace(-1, 1, len(lacking)) ** 16) * np.where(lacking > 0, 1 - FLATTENED, 1.0) * lacking
        mouth.part(here, way / 2, way / 2)
        mouth.keep_apart(here, *(np.zeros(len(lip.kept)) for lip in (mouth.upper, mouth.lower)))
        live[rows] = here
        number = points_of_vertices(face, display)
        face = _moved(face, live, np.where(number < display.moving, number, -1))
        face = replace(face, skin=with_smooth_corners(face.skin, face.landmarks))
    return replace(face, chart=make_chart(face.skin))


def _gone_through(mouth: LipPair, here: Float32Array) -> FloatArray:
    """How far the lips are in each other at most in each column (I,); below zero where they are apart.

    A column of which nothing is above or below the other lip stays where it is.
    """
    most = np.full(COLUMNS, -np.inf)
    for lip, overlap in zip((mouth.upper, mouth.lower), mouth.overlaps(here), strict=True):
        np.maximum.at(most, lip.column, overlap)
    return np.where(most > -APART, most, -TOUCH)


def _moved(face: Face, live: Float32Array, number: np.typing.NDArray[np.int64]) -> Face:
    """The face with carried parts and those vertices at live points that are one of the skin, by its number, not -1."""
    parts, start = [], 0
    for part in face.parts:
        if part.carrier == "skin":
            count = len(part.mesh.positions)
            part = replace(part, mesh=part.mesh.moved(live[start : start + count].astype(np.float64)))
            start += count
        parts.append(part)
    positions = face.skin.positions.copy()
    positions[number >= 0] = live[start + number[number >= 0]]
    return replace(face, skin=face.skin.moved(positions), parts=tuple(parts))
