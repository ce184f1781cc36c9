"""Eyes and head of a pose: rigid motions, summed over the action units that ask for them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import astuple, dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.actions import ActionUnit, Expression
from facemodel.face import Eye, Face
from facemodel.jaw.motion import hinge_frame
from facemodel.motions import EyeMotion, HeadMotion
from fem.types import FloatArray

WIDEST_TURN = 50.0
"""Degrees to either side that an eye turns at most."""

HIGHEST, LOWEST = 40.0, -50.0
"""Degrees up and down that an eye turns at most."""

BELOW_HINGE, BEHIND_HINGE = 30.0, 18.0
"""Millimetres from the condyles to the middle of the upper neck, about which a head turns, nods and tilts."""


@dataclass(frozen=True, eq=False)
class Rig:
    """What sliders do to eyes and head.

    Attributes
    ----------
    eyes : by field name, at activation 1
    head : by field name, at activation 1
    """

    eyes: dict[str, EyeMotion]
    head: dict[str, HeadMotion]

    def gaze(self, expression: Expression) -> EyeMotion:
        """How the eyes are turned in an expression."""
        return EyeMotion(*_summed(expression, self.eyes, 3))

    def bearing(self, expression: Expression) -> HeadMotion:
        """How the head is held in an expression."""
        return HeadMotion(*_summed(expression, self.head, 4))


@dataclass(frozen=True, eq=False)
class Stance:
    """How the rigid parts of a head stand in a pose.

    Attributes
    ----------
    jaw : (4, 4) motion of the mandible within the head
    gaze, bearing : how the eyes are turned and how the head is held
    eyes : (4, 4) motion of each eyeball within the head, in the order of the face
    head : (4, 4) motion of the head with all that belongs to it
    """

    jaw: FloatArray
    gaze: EyeMotion
    bearing: HeadMotion
    eyes: tuple[FloatArray, ...]
    head: FloatArray


def stance_of(face: Face, rig: Rig, expression: Expression, jaw: FloatArray) -> Stance:
    """How the rigid parts of a face stand in an expression, with its jaw moved by (4, 4)."""
    gaze, bearing = rig.gaze(expression), rig.bearing(expression)
    eyes = tuple(eye_motion(eye, gaze) if gaze else np.eye(4) for eye in face.eyes)
    return Stance(jaw, gaze, bearing, eyes, head_motion(face, bearing) if bearing else np.eye(4))


STILL = Rig({}, {})
"""Eyes that look ahead on a head that is held upright."""


def rig_of(units: Iterable[ActionUnit]) -> Rig:
    """The rig that some action units drive."""
    eyes: dict[str, EyeMotion] = {}
    head: dict[str, HeadMotion] = {}
    for unit in units:
        for number, name in enumerate(unit.fields):
            if unit.eyes:
                eyes[name] = unit.eyes.mirrored if number else unit.eyes
            if unit.head:
                head[name] = unit.head.mirrored if number else unit.head
    return Rig(eyes, head)


def _summed(expression: Expression, table: dict[str, EyeMotion] | dict[str, HeadMotion], size: int) -> list[float]:
    total = np.zeros(size)
    for name, motion in table.items():
        weight = expression.get(name, 0.0)
        if weight:
            total += weight * np.array(astuple(motion))
    return [float(value) for value in total]


def eye_motion(eye: Eye, gaze: EyeMotion) -> FloatArray:
    """Rigid motion (4, 4) of an eyeball: it turns about its centre as far as an eye can, first up, then aside."""
    outward = 1.0 if eye.side == "L" else -1.0
    aside = float(np.clip(gaze.turn + outward * gaze.spread, -WIDEST_TURN, WIDEST_TURN))
    lift = float(np.clip(gaze.lift, LOWEST, HIGHEST))
    return _about(eye.centre, Rotation.from_euler("YX", [aside, -lift], degrees=True))


def head_motion(face: Face, bearing: HeadMotion) -> FloatArray:
    """Rigid motion (4, 4) of a head with all that belongs to it."""
    middle, frame = hinge_frame(face.skull.jaw)
    pivot = middle - BELOW_HINGE * frame[1] - BEHIND_HINGE * frame[2]
    angles = [bearing.turn, -bearing.lift, -bearing.tilt]
    motion = _about(pivot, Rotation.from_euler("YXZ", angles, degrees=True))
    motion[2, 3] += bearing.forward
    return motion


def _about(point: FloatArray, turn: Rotation) -> FloatArray:
    motion = np.eye(4)
    motion[:3, :3] = turn.as_matrix()
    motion[:3, 3] = point - motion[:3, :3] @ point
    return motion
