"""Head, jaw and eyes as rigid parts that turn about a pivot, for formats with nodes or bones."""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.face import Face
from facemodel.kinematics import Stance, neck_joint
from fem.types import FloatArray

HEAD, JAW = "head", "jaw"
SIDES = {"L": "left", "R": "right"}

STILL = 1e-9
"""Millimetres, and components of a quaternion, within which a joint does not move."""


@dataclass(frozen=True, eq=False)
class Joint:
    """A rigid part over time.

    Attributes
    ----------
    name : ``head``, ``jaw``, ``eyeball-left``, ``eyeball-right``
    parent : name of the joint that carries it; empty for the head
    pivot : (3,) what it turns about at rest, millimetres in the coordinates of the head
    places : (T, 3) where the pivot is, in the coordinates of the head as it is carried
    turns : (T, 4) unit quaternions x, y, z, w; neighbours are on the same side, so that they can be interpolated
    """

    name: str
    parent: str
    pivot: FloatArray
    places: FloatArray
    turns: FloatArray

    @property
    def shifts(self) -> bool:
        """Whether its pivot moves."""
        return bool(np.ptp(self.places, axis=0).max(initial=0.0) > STILL)

    @property
    def rotates(self) -> bool:
        """Whether it turns."""
        return bool(np.ptp(self.turns, axis=0).max(initial=0.0) > STILL)


def eye_joint(side: str) -> str:
    """The name of the joint of an eye, ``L`` or ``R``."""
    return f"eyeball-{SIDES[side]}"


def joint_of(name: str, jaw_parts: Set[str]) -> str:
    """The joint that carries a mesh rigidly; empty for one that the skin or the skull carries."""
    layer, _, side = name.partition("-")
    if layer in ("eye", "cornea") and side in SIDES.values():
        return f"eyeball-{side}"
    return JAW if name in jaw_parts else ""


def jaw_pivot(face: Face) -> FloatArray:
    """The point (3,) midway between the condyles."""
    return np.asarray(face.skull.jaw.axis.mean(axis=0))


def joints_of(face: Face, stances: Sequence[Stance]) -> tuple[Joint, ...]:
    """The joints of a face in some frames.

    Parameters
    ----------
    face : whose they are
    stances : how jaw, eyes and head stand, one for each frame
    """
    head = _joint(HEAD, "", neck_joint(face), [stance.head for stance in stances])
    jaw = _joint(JAW, HEAD, jaw_pivot(face), [stance.jaw for stance in stances])
    eyes = (
        _joint(eye_joint(eye.side), HEAD, eye.centre, [stance.eyes[number] for stance in stances])
        for number, eye in enumerate(face.eyes)
    )
    return (head, jaw, *eyes)


def _joint(name: str, parent: str, pivot: FloatArray, motions: Sequence[FloatArray]) -> Joint:
    moved = np.stack(motions)
    places = moved[:, :3, :3] @ pivot + moved[:, :3, 3]
    turns = Rotation.from_matrix(moved[:, :3, :3]).as_quat(canonical=True)
    for frame in range(1, len(turns)):
        if turns[frame] @ turns[frame - 1] < 0:
            turns[frame] *= -1
    return Joint(name, parent, pivot, places, turns)
