"""Eyes, head and tongue of a pose: motions, summed over the action units and the channels that ask for them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import astuple, dataclass, replace
from functools import cached_property, lru_cache
from types import MappingProxyType

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.actions import ActionUnit, Expression
from facemodel.face import Eye, Face
from facemodel.jaw.motion import hinge_frame
from facemodel.motions import EyeMotion, HeadMotion, TongueMotion
from fem.types import FloatArray

WIDEST_TURN = 50.0
"""Degrees to either side that an eye turns at most."""

HIGHEST, LOWEST = 40.0, -50.0
"""Degrees up and down that an eye turns at most."""

BELOW_HINGE, BEHIND_HINGE = 30.0, 18.0
"""Millimetres from the condyles to the middle of the upper neck, about which a head turns, nods and tilts."""

Rigid = Mapping[str, float]
"""Degrees and millimetres of head and eyes by channel, see `facemodel.animation.channels`; those not named rest."""

NO_TURN: Rigid = MappingProxyType({})
"""Every channel rests."""


@dataclass(frozen=True)
class Posture:
    """How eyes, head and tongue are held, in all.

    Attributes
    ----------
    eyes : of the face, in its order: degrees to the subject's left and upwards
    head : its turns, and how far it is forward
    shift : millimetres by which it goes to the subject's left, up and forward besides
    tongue : how far it is out
    """

    eyes: tuple[tuple[float, float], ...]
    head: HeadMotion
    shift: tuple[float, float, float]
    tongue: TongueMotion


@dataclass(frozen=True, eq=False)
class Rig:
    """What sliders do to eyes, head and tongue.

    Attributes
    ----------
    eyes : by field name, at activation 1
    head : by field name, at activation 1
    tongue : by field name, at activation 1
    """

    eyes: dict[str, EyeMotion]
    head: dict[str, HeadMotion]
    tongue: dict[str, TongueMotion]

    @cached_property
    def names(self) -> frozenset[str]:
        """All fields that move eyes, head or tongue."""
        return frozenset({*self.eyes, *self.head, *self.tongue})

    def posture(self, face: Face, expression: Expression, rigid: Rigid = NO_TURN) -> Posture:
        """How eyes and head are held in an expression, and by channels beside it.

        As long as nothing of that changes it is the very same object.
        """
        asked = {name: weight for name, weight in expression.items() if weight and name in self.names}
        return _posture(self, face, frozenset(asked.items()), frozenset(rigid.items()))


_Amounts = frozenset[tuple[str, float]]


@lru_cache(maxsize=8)
def _posture(
    rig: Rig, face: Face, asked: tuple[tuple[str, float], ...], turned: tuple[tuple[str, float], ...]
) -> Posture:
    expression, rigid = dict(asked), dict(turned)
    gaze = EyeMotion(*_summed(expression, rig.eyes, 3))
    held = HeadMotion(*_summed(expression, rig.head, 4))
    tongue = TongueMotion(*_summed(expression, rig.tongue, 2))
    yaw, pitch, roll = (rigid.get(f"head.{name}", 0.0) for name in ("yaw", "pitch", "roll"))
    across, up, forward = (rigid.get(f"head.{axis}", 0.0) for axis in "xyz")
    head = replace(held, turn=held.turn + yaw, lift=held.lift + pitch, tilt=held.tilt + roll)
    return Posture(tuple(_look(eye, gaze, rigid) for eye in face.eyes), head, (across, up, forward), tongue)


@dataclass(frozen=True, eq=False)
class Stance:
    """How the rigid parts of a head stand in a pose.

    Attributes
    ----------
    jaw : (4, 4) motion of the mandible within the head
    posture : how eyes and head are held
    eyes : (4, 4) motion of each eyeball within the head, in the order of the face
    head : (4, 4) motion of the head with all that belongs to it
    """

    jaw: FloatArray
    posture: Posture
    eyes: tuple[FloatArray, ...]
    head: FloatArray


def stance_of(face: Face, posture: Posture, jaw: FloatArray) -> Stance:
    """How the rigid parts of a face stand in a posture, with its jaw moved by (4, 4)."""
    return Stance(jaw, posture, *_eyes_and_head(face, posture))


@lru_cache(maxsize=8)
def _eyes_and_head(face: Face, posture: Posture) -> tuple[tuple[FloatArray, ...], FloatArray]:
    eyes = tuple(_turned(eye, look) for eye, look in zip(face.eyes, posture.eyes, strict=True))
    head = _held(face, posture)
    for motion in (*eyes, head):
        motion.setflags(write=False)
    return eyes, head


STILL = Rig({}, {}, {})
"""Eyes that look ahead on a head that is held upright."""


def rig_of(units: Iterable[ActionUnit]) -> Rig:
    """The rig that some action units drive."""
    eyes: dict[str, EyeMotion] = {}
    head: dict[str, HeadMotion] = {}
    tongue: dict[str, TongueMotion] = {}
    for unit in units:
        for number, name in enumerate(unit.fields):
            if unit.eyes:
                eyes[name] = unit.eyes.mirrored if number else unit.eyes
            if unit.head:
                head[name] = unit.head.mirrored if number else unit.head
            if unit.tongue:
                tongue[name] = unit.tongue
    return Rig(eyes, head, tongue)


def _summed(
    expression: Expression, table: Mapping[str, EyeMotion | HeadMotion | TongueMotion], size: int
) -> list[float]:
    total = np.zeros(size)
    for name, motion in table.items():
        weight = expression.get(name, 0.0)
        if weight:
            total += weight * np.array(astuple(motion))
    return [float(value) for value in total]


def _look(eye: Eye, gaze: EyeMotion, rigid: Rigid) -> tuple[float, float]:
    """Degrees to the left and upwards in which an eye looks, as far as it can."""
    outward = 1.0 if eye.side == "L" else -1.0
    aside = gaze.turn + outward * gaze.spread + rigid.get(f"eye{eye.side}.yaw", 0.0)
    lift = gaze.lift + rigid.get(f"eye{eye.side}.pitch", 0.0)
    return float(np.clip(aside, -WIDEST_TURN, WIDEST_TURN)), float(np.clip(lift, LOWEST, HIGHEST))


def _turned(eye: Eye, look: tuple[float, float]) -> FloatArray:
    """Rigid motion (4, 4) of an eyeball: it turns about its centre, first up, then aside."""
    aside, lift = look
    if not (aside or lift):
        return np.eye(4)
    return _about(eye.centre, Rotation.from_euler("YX", [aside, -lift], degrees=True))


def neck_joint(face: Face) -> FloatArray:
    """The point (3,) about which a head turns, nods and tilts."""
    middle, frame = hinge_frame(face.skull.jaw)
    return np.asarray(middle - BELOW_HINGE * frame[1] - BEHIND_HINGE * frame[2])


def _held(face: Face, posture: Posture) -> FloatArray:
    """Rigid motion (4, 4) of a head with all that belongs to it."""
    head = posture.head
    if not (head or any(posture.shift)):
        return np.eye(4)
    motion = _about(neck_joint(face), Rotation.from_euler("YXZ", [head.turn, -head.lift, -head.tilt], degrees=True))
    motion[:3, 3] += posture.shift
    motion[2, 3] += head.forward
    return motion


def _about(point: FloatArray, turn: Rotation) -> FloatArray:
    motion = np.eye(4)
    motion[:3, :3] = turn.as_matrix()
    motion[:3, 3] = point - motion[:3, :3] @ point
    return motion
