"""Where the eyes look, by how far the irises stand from the middle between the corners of the lids."""

from __future__ import annotations

import numpy as np

from facemodel.animation.landmarks.lids import openness
from facemodel.animation.landmarks.places import irises
from fem.types import BoolArray, FloatArray

REACH = 0.35
"""The iris lies 10.5 mm before the centre of its eyeball, and from corner to corner the lids measure 30 mm."""

CORNERS = {"L": (263, 362), "R": (33, 133)}
"""Outer and inner corner of the lids in the mesh."""

HIDDEN = 0.5
"""Share of their opening at rest below which lids hide where the eye looks, and trackers guess."""


def gaze(points: FloatArray, rest: slice) -> dict[str, FloatArray]:
    """Channels of the eyes (N,) in degrees, from frames (N, 478, 3) without head motion and with y up.

    Both eyes look the same way: how far they converge is less than irises tremble.  While an eye is shut its gaze goes
    on from where it was to where it is next seen.

    Parameters
    ----------
    points : in any unit
    rest : the frames in which they look ahead
    """
    looks: list[FloatArray] = []
    for side, iris in irises().items():
        outer, inner = (points[:, corner] for corner in CORNERS[side])
        stand = points[:, iris] - (outer + inner) / 2
        reach = REACH * float(np.linalg.norm(outer[rest] - inner[rest], axis=-1).mean())
        went = np.clip((stand - stand[rest].mean(axis=0)) / reach, -1.0, 1.0)
        seen = openness(points, side, rest) >= HIDDEN
        looks.append(np.stack([_bridged(np.degrees(np.arcsin(went[:, axis])), seen) for axis in (0, 1)]))
    yaw, pitch = np.mean(looks, axis=0)
    return {"eyeL.yaw": yaw, "eyeL.pitch": pitch, "eyeR.yaw": yaw, "eyeR.pitch": pitch}


def _bridged(values: FloatArray, seen: BoolArray) -> FloatArray:
    if not seen.any():
        return np.zeros_like(values)
    frames = np.arange(len(values))
    return np.asarray(np.interp(frames, frames[seen], values[seen]))
