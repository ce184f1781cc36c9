"""Seat the teeth of a head behind its lips: those of the base mesh end above the lips' line, edge to edge."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from facemodel.face import Face, Part
from facemodel.jaw.opening import incisal_edge
from facemodel.smooth import smooth_step
from fem.types import FloatArray

SHOWN = 2.2
"""Millimetres of the upper incisors that are seen below an upper lip at rest: 1 to 3 on adults."""

OVERBITE = 1.0
"""Millimetres that upper incisors hang over the lower ones: less than the 2 of most adults, since each takes as much
from what a jaw opens between the incisors."""

OVERJET = 1.6
"""Millimetres that the edges of upper incisors lie before those of the lower ones, some 2 on adults.  What thin lips
are in each other and in the teeth over random mixes of all units is least here, and grows to either side."""

HANGING = (2.0, 12.0)
"""Millimetres behind the edge of the incisors to which the upper row hangs over the lower one all the way, and from
where on not at all: canines do in part, molars meet."""

AHEAD = (0.0, 5.0)
"""The same for how far it lies before the lower one: incisors alone, since thin lips rest on the canines."""


def with_seated_teeth(face: Face) -> Face:
    """A face whose upper incisors show under its resting lips, and lie over and before the lower ones.

    The lower row and the tongue in it come down as they are, and so does the upper row as far as its molars; its front
    laps over the lower one.  Seated teeth stay where they are.
    """
    parts = {part.name: part for part in face.parts}
    upper, lower = (parts[f"teeth-{row}"] for row in ("upper", "lower"))
    line = face.skin.positions[[face.landmarks["upper_lip_mid"], face.landmarks["lower_lip_mid"]]].mean(axis=0)
    hanging, standing = _edge(upper), _edge(lower)
    down = line[1] - SHOWN + OVERBITE - standing[1]
    drop, ahead = standing[1] - OVERBITE - hanging[1], standing[2] + OVERJET - hanging[2]
    behind = hanging[2] - upper.mesh.positions[:, 2]
    lap = np.stack([np.zeros(len(behind)), drop * _share(behind, HANGING), ahead * _share(behind, AHEAD)], axis=1)
    whole = np.array([0.0, down, 0.0])
    seated = {upper.name: whole + lap, lower.name: whole, "tongue": whole}
    return replace(face, parts=tuple(_moved(part, seated.get(part.name)) for part in face.parts))


def _edge(row: Part) -> FloatArray:
    return np.asarray(row.mesh.positions[incisal_edge(row)] * [0.0, 1.0, 1.0])


def _share(behind: FloatArray, ends: tuple[float, float]) -> FloatArray:
    return 1 - smooth_step((behind - ends[0]) / (ends[1] - ends[0]))


def _moved(part: Part, way: FloatArray | None) -> Part:
    return part if way is None else replace(part, mesh=part.mesh.moved(part.mesh.positions + way))
