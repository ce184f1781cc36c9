"""The handles that move, turn and scale a skull: where they are in space, which one is meant, what a drag makes of it.

All of it is geometry of lines of sight, in millimetres of the head; how it is drawn is the viewport's business.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from scipy.spatial.transform import Rotation

from app.tools.pointer import Ray
from facemodel.face import Pose, Skull
from facemodel.skull.placement import LARGEST, SMALLEST, pivot_of, turned
from fem.types import FloatArray

Mode = Literal["move", "turn", "scale"]

ARM = 104.0
"""Pixels from the middle to the end of a handle."""

RING = 0.92
"""Radius of the rings as a share of the arms."""

START = 0.14
"""Share of an arm about the middle that belongs to the handle in the middle."""

EDGE_ON = 0.12
"""Cosine between the line of sight and a ring's axis below which the ring is seen from its edge."""

SIDES = 64
FREE = 3
"""Number of the handle in the middle: all axes at once."""

STEPS = {"move": 1.0, "turn": 5.0, "scale": 0.05}
"""Millimetres, degrees and shares that a drag with Ctrl goes in."""
FINE = 0.1
"""Share of the way that a drag with Shift goes."""


@dataclass(frozen=True)
class Part:
    """A handle: what it does, along which axis (0 to 2) or along all (`FREE`)."""

    mode: Mode
    axis: int


@dataclass(frozen=True, eq=False)
class Gizmo:
    """The handles about a skull.

    Attributes
    ----------
    mode : which of them
    centre : (3,) where they are
    axes : (3, 3) their directions, one per row
    arm : how far they reach, millimetres
    """

    mode: Mode
    centre: FloatArray
    axes: FloatArray
    arm: float

    def ring(self, axis: int) -> FloatArray:
        """Places (SIDES + 1, 3) on the ring about an axis, closed."""
        one, other = (self.axes[(axis + step) % 3] for step in (1, 2))
        turn = np.linspace(0.0, 2 * np.pi, SIDES + 1)[:, None]
        return np.asarray(self.centre + RING * self.arm * (np.cos(turn) * one + np.sin(turn) * other))

    def arm_of(self, axis: int) -> FloatArray:
        """Places (k, 3) along the arm of an axis."""
        return np.asarray(self.centre + np.linspace(START, 1.0, 12)[:, None] * self.arm * self.axes[axis])

    def part_under(self, ray: Ray, reach: float) -> Part | None:
        """The handle that a line of sight meets within some millimetres; the one in the middle comes first."""
        if self.mode != "turn" and float(ray.distance(self.centre)[0]) < max(START * self.arm, reach):
            return Part(self.mode, FREE)
        best, found = reach, None
        for axis in range(3):
            places = self._facing(self.ring(axis), ray) if self.mode == "turn" else self.arm_of(axis)
            away = float(_from_chain(ray, places)) if len(places) > 1 else np.inf
            if away < best:
                best, found = away, Part(self.mode, axis)
        return found

    def _facing(self, places: FloatArray, ray: Ray) -> FloatArray:
        """The half of a ring that is turned to the eye."""
        return places[(places - self.centre) @ ray.along < 0.15 * self.arm]


def gizmo_of(skull: Skull, mode: Mode, millimetres: Callable[[FloatArray], float], pose: Pose | None = None) -> Gizmo:
    """The handles of a skull in its pose, or in another one.

    Parameters
    ----------
    millimetres : width of a pixel at a place (3,)
    """
    lies = pose or skull.placement.pose
    centre = pivot_of(skull) + np.array(lies.shift)
    axes = turned(lies).T if mode == "scale" else np.eye(3)
    return Gizmo(mode, centre, axes, ARM * millimetres(centre))


@dataclass(frozen=True, eq=False)
class Pull:
    """A drag of a handle under way.

    Attributes
    ----------
    gizmo, part : what is held
    start : the pose when it was taken
    ray : the line of sight then
    """

    gizmo: Gizmo
    part: Part
    start: Pose
    ray: Ray

    def pose(self, ray: Ray, *, steps: bool = False, fine: bool = False) -> Pose:
        """The pose that the hand means with another line of sight; in round steps, or a tenth of the way."""
        if self.part.mode == "move":
            return self._moved(ray, steps, fine)
        return self._turned(ray, steps, fine) if self.part.mode == "turn" else self._scaled(ray, steps, fine)

    def _moved(self, ray: Ray, steps: bool, fine: bool) -> Pose:
        gizmo = self.gizmo
        if self.part.axis == FREE:
            way = _in_plane(ray, gizmo.centre, self.ray.along) - _in_plane(self.ray, gizmo.centre, self.ray.along)
        else:
            axis = gizmo.axes[self.part.axis]
            way = (_along(ray, gizmo.centre, axis) - _along(self.ray, gizmo.centre, axis)) * axis
        way = _stepped(way * (FINE if fine else 1.0), STEPS["move"] if steps else 0.0)
        return replace(self.start, shift=_triple(np.array(self.start.shift) + way))

    def _turned(self, ray: Ray, steps: bool, fine: bool) -> Pose:
        axis = self.gizmo.axes[self.part.axis]
        degrees = np.degrees(self._angle(ray, axis)) * (FINE if fine else 1.0)
        degrees = float(_stepped(np.array(degrees), STEPS["turn"] if steps else 0.0))
        before = Rotation.from_euler("xyz", self.start.turn, degrees=True)
        after = Rotation.from_rotvec(np.radians(degrees) * axis) * before
        return replace(self.start, turn=_near(after.as_euler("xyz", degrees=True)))

    def _angle(self, ray: Ray, axis: FloatArray) -> float:
        """How far, in radians, the pointer has gone round an axis."""
        centre = self.gizmo.centre
        if abs(self.ray.along @ axis) < EDGE_ON:
            across = np.cross(axis, self.ray.along)
            across /= np.linalg.norm(across)
            plane = self.ray.along
            way = _in_plane(ray, centre, plane) - _in_plane(self.ray, centre, plane)
            return float(-(way @ across) / (RING * self.gizmo.arm))
        one, other = (_in_plane(each, centre, axis) - centre for each in (self.ray, ray))
        return float(np.arctan2(np.cross(one, other) @ axis, one @ other))

    def _scaled(self, ray: Ray, steps: bool, fine: bool) -> Pose:
        gizmo = self.gizmo
        if self.part.axis == FREE:
            plane = self.ray.along
            way = _in_plane(ray, gizmo.centre, plane) - _in_plane(self.ray, gizmo.centre, plane)
            up = _up_of(plane)
            grown = 1.0 + float(way @ (up + np.cross(plane, up))) / (2 * gizmo.arm)
        else:
            axis = gizmo.axes[self.part.axis]
            before, now = (_along(each, gizmo.centre, axis) for each in (self.ray, ray))
            grown = now / before if abs(before) > START * gizmo.arm else 1.0
        grown = 1.0 + (grown - 1.0) * (FINE if fine else 1.0)
        scale = np.array(self.start.scale)
        which = slice(None) if self.part.axis == FREE else slice(self.part.axis, self.part.axis + 1)
        scale[which] = _stepped(scale[which] * grown, STEPS["scale"] if steps else 0.0)
        return replace(self.start, scale=_triple(np.clip(scale, SMALLEST, LARGEST)))


def _up_of(plane: FloatArray) -> FloatArray:
    """The direction (3,) in a plane facing the eye that points most to the crown."""
    up = np.array([0.0, 1.0, 0.0]) - plane[1] * plane
    size = np.linalg.norm(up)
    return np.asarray(up / size) if size > EDGE_ON else np.array([0.0, 0.0, -1.0])


def _from_chain(ray: Ray, places: FloatArray) -> float:
    """The least distance between a line of sight and a chain of places, closely sampled."""
    share = np.linspace(0.0, 1.0, 4)[:, None, None]
    return float(ray.distance(((1 - share) * places[:-1] + share * places[1:]).reshape(-1, 3)).min())


def _along(ray: Ray, origin: FloatArray, axis: FloatArray) -> float:
    """How far along an axis through a point the place lies that is nearest to a line of sight."""
    between = ray.origin - origin
    slant = float(ray.along @ axis)
    square = max(1.0 - slant**2, EDGE_ON**2)
    return float((between @ axis - slant * (between @ ray.along)) / square)


def _in_plane(ray: Ray, point: FloatArray, normal: FloatArray) -> FloatArray:
    """Where (3,) a line of sight meets the plane through a point."""
    slant = float(ray.along @ normal)
    if abs(slant) < 1e-6:
        return point
    return np.asarray(ray.origin + ((point - ray.origin) @ normal) / slant * ray.along)


def _stepped(values: FloatArray, step: float) -> FloatArray:
    return np.asarray(np.round(values / step) * step if step else values)


def _near(degrees: FloatArray) -> tuple[float, float, float]:
    """Angles without the dust of rounding."""
    return _triple(np.round(degrees, 6) + 0.0)


def _triple(values: FloatArray) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
