"""The pose of a skull in words: what a drag has done so far."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from app.tools.gizmo import FREE, Part
from facemodel.face import Pose

NAMES = "xyz"
"""Axes of the head: to the subject's left, up, forward."""


def told(start: Pose, pose: Pose, part: Part) -> str:
    """What a drag of a handle has changed."""
    axes = range(3) if part.axis == FREE else (part.axis,)
    if part.mode == "move":
        way = np.subtract(pose.shift, start.shift)
        return "  ".join(f"{NAMES[axis]} {way[axis]:+.1f}" for axis in axes) + " mm"
    if part.mode == "scale":
        grown = np.divide(pose.scale, start.scale)
        if part.axis == FREE:
            return f"{100 * float(grown.mean()):.1f} %"
        return f"{NAMES[part.axis]} {100 * grown[part.axis]:.1f} %"
    return f"{NAMES[part.axis]} {_turned(start, pose, part.axis):+.1f}°"


def _turned(start: Pose, pose: Pose, axis: int) -> float:
    """Degrees about an axis of the head between two poses that differ by a turn about it."""
    before, after = (Rotation.from_euler("xyz", each.turn, degrees=True) for each in (start, pose))
    return float((after * before.inv()).as_rotvec(degrees=True)[axis])
