"""Rigid motions of head and eyes, from channels to matrices."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.face import Eye, Face
from fem.types import FloatArray

BEHIND, BELOW = 12.0, 22.0
"""Millimetres from the middle between the ears to the joint between skull and neck, about which a head nods."""


def head_pivot(face: Face) -> FloatArray:
    """The point (3,) about which the head turns; between the eyes where a face has no ears."""
    marks = face.landmarks
    if {"tragus_L", "tragus_R"} <= marks.keys():
        ears = face.skin.positions[[marks["tragus_L"], marks["tragus_R"]]]
    else:
        ears = np.array([eye.centre for eye in face.eyes])
    return np.asarray(ears.mean(axis=0) - [0.0, BELOW, BEHIND])


def turn(yaw: float, pitch: float, roll: float = 0.0) -> FloatArray:
    """Rotation (3, 3) by degrees: roll first, then pitch, then yaw.

    Yaw turns to the subject's left (from z to x), pitch up (from z to y), roll to the left shoulder (from y to x).
    """
    return np.asarray(Rotation.from_euler("YXZ", [yaw, -pitch, -roll], degrees=True).as_matrix())


def head_motion(face: Face, rigid: Mapping[str, float]) -> FloatArray:
    """Motion (4, 4) of the whole head; channels that are not named rest."""
    rotation = turn(*(rigid.get(f"head.{name}", 0.0) for name in ("yaw", "pitch", "roll")))
    shift = np.array([rigid.get(f"head.{axis}", 0.0) for axis in "xyz"])
    return _about(head_pivot(face), rotation, shift)


def eye_motion(eye: Eye, rigid: Mapping[str, float]) -> FloatArray:
    """Motion (4, 4) of an eyeball in the head, about its centre."""
    name = f"eye{eye.side}"
    rotation = turn(rigid.get(f"{name}.yaw", 0.0), rigid.get(f"{name}.pitch", 0.0))
    return _about(eye.centre, rotation, np.zeros(3))


def _about(pivot: FloatArray, rotation: FloatArray, shift: FloatArray) -> FloatArray:
    motion = np.eye(4)
    motion[:3, :3] = rotation
    motion[:3, 3] = pivot + shift - rotation @ pivot
    return motion
