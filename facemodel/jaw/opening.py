"""How wide a mouth is open: the way between the edges of the incisors, as it is measured on people."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from facemodel.errors import FaceError
from facemodel.face import Face, Part
from facemodel.jaw.motion import jaw_motion
from facemodel.skull.placement import carried
from fem.types import Float32Array, FloatArray

BESIDE, BEHIND = 6.0, 6.0
"""Millimetres from the midline, and behind the foremost place of a row of teeth, within which its incisors lie."""


def incisal_edge(row: Part) -> int:
    """The point of a row of teeth where the edge of its incisors is."""
    rest = row.mesh.positions
    front = np.flatnonzero((np.abs(rest[:, 0]) < BESIDE) & (rest[:, 2] > rest[:, 2].max() - BEHIND))
    height = rest[front, 1] if row.carrier == "jaw" else -rest[front, 1]
    return int(front[height.argmax()])


def incisors_apart(face: Face, places: Callable[[Part], FloatArray | Float32Array]) -> float:
    """Millimetres between the edges of the upper and the lower incisors.

    Parameters
    ----------
    face : with two rows of teeth
    places : where (n, 3) the points of one of them are

    Raises
    ------
    FaceError
        If the face has not one upper and one lower row of teeth.
    """
    rows = [part for part in face.parts if part.kind == "teeth"]
    if len(rows) != 2:
        raise FaceError(f"“{face.title}” has {len(rows)} rows of teeth; how wide it opens is told by two.")
    one, other = (np.asarray(places(row))[incisal_edge(row)] for row in rows)
    return float(np.linalg.norm(one - other))


def opened(face: Face, degrees: float, slide: float) -> float:
    """Millimetres between the incisors when the jaw turns by so many degrees and slides forward on the way."""
    motion = jaw_motion(face.skull.jaw, degrees, slide)

    def places(row: Part) -> FloatArray:
        rest = row.mesh.positions
        return carried(rest, motion) if row.carrier == "jaw" else rest

    return incisors_apart(face, places)
