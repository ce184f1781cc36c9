"""Lay a sphincter as an ellipse on the skin, and drag its middle and half axes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Literal

import numpy as np

from facemodel.errors import MuscleError
from facemodel.face import Face
from facemodel.muscles import Muscle, Sphincter
from fem.types import FloatArray

Axis = Literal["long", "short"]

Sector = Literal["whole", "left", "right", "up", "down"]
"""How much of a ring there is: all of it, or the half towards the subject's left or right, or upward or downward."""

SECTORS: Mapping[Sector, tuple[float, float]] = {
    "whole": (0.0, 0.0),
    "left": (1.0, 0.0),
    "right": (-1.0, 0.0),
    "up": (0.0, 1.0),
    "down": (0.0, -1.0),
}
"""Where the halves lie, along the long and the short axis of a ring as it is laid."""

TOO_SHORT = 1e-6
"""Millimetres below which a drag has no direction."""


def laid_ring(face: Face, centre: FloatArray, tip: FloatArray, height: float) -> Sphincter:
    """A ring about a centre (3,) with its long half axis to a tip (3,) and a short one of some height.

    The ring lies as the skin does about its centre: its outward normal is that of the skin there.

    Raises
    ------
    MuscleError
        If the tip is at the centre or straight over it, or the height is not positive.
    """
    middle, long_axis = np.array(centre, dtype=np.float64), np.asarray(tip - centre, dtype=np.float64)
    normal = face.skin.normals[face.skin.tree.query(middle)[1]]
    long_axis = long_axis - (long_axis @ normal) * normal
    length = float(np.linalg.norm(long_axis))
    if length < TOO_SHORT or not height > 0:
        raise MuscleError("A ring needs a width and a height; drag its half axes apart.")
    # To the subject's left, so that the outward normal is the skin's with the short axis up.
    long_axis *= 1.0 if long_axis[0] >= 0 else -1.0
    return Sphincter(middle, long_axis, height * np.cross(normal, long_axis / length))


def ring_of(muscle: Muscle) -> Sphincter:
    """The ring of a muscle.

    Raises
    ------
    MuscleError
        If it has none.
    """
    if muscle.ring is None:
        raise MuscleError(f"“{muscle.key}” has no ring; draw an ellipse on the skin.")
    return muscle.ring


def frame_of(ring: Sphincter) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The half axes (3,) of a ring, and its outward normal as long as the short one."""
    out = np.cross(ring.long_axis, ring.short_axis)
    height = float(np.linalg.norm(ring.short_axis))
    return ring.long_axis, ring.short_axis, out * height / max(float(np.linalg.norm(out)), TOO_SHORT)


def with_centre(muscle: Muscle, point: FloatArray) -> Muscle:
    """A muscle with its ring about another centre (3,), in the same size and direction."""
    return replace(muscle, ring=replace(ring_of(muscle), centre=np.array(point, dtype=np.float64)))


def with_axis(muscle: Muscle, axis: Axis, tip: FloatArray) -> Muscle:
    """A muscle with the tip (3,) of one half axis of its ring elsewhere; the other one turns along.

    Raises
    ------
    MuscleError
        If it has no ring, or the tip is dragged to its centre.
    """
    ring = ring_of(muscle)
    new = np.asarray(tip - ring.centre, dtype=np.float64)
    dragged, other = (ring.long_axis, ring.short_axis) if axis == "long" else (ring.short_axis, ring.long_axis)
    if np.linalg.norm(new) < TOO_SHORT:
        raise MuscleError(f"The ring of “{muscle.key}” cannot be as thin as that; drag its tip away from its middle.")
    turned = _carried(dragged, new, other)
    if axis == "long":
        return replace(muscle, ring=replace(ring, long_axis=new, short_axis=turned))
    return replace(muscle, ring=replace(ring, long_axis=turned, short_axis=new))


def with_length(muscle: Muscle, axis: Axis, length: float) -> Muscle:
    """A muscle with one half axis of its ring of another length, millimetres, in the same direction.

    Raises
    ------
    MuscleError
        If it has no ring, or the length is not positive.
    """
    ring = ring_of(muscle)
    if not length > TOO_SHORT:
        raise MuscleError(f"The ring of “{muscle.key}” cannot be as thin as that; give its half axis a length.")
    old = ring.long_axis if axis == "long" else ring.short_axis
    return with_axis(muscle, axis, ring.centre + length / max(float(np.linalg.norm(old)), TOO_SHORT) * old)


def with_sector(muscle: Muscle, sector: Sector) -> Muscle:
    """A muscle with the whole of its ring, or one half of it."""
    ring = ring_of(muscle)
    along, up, _ = frame_of(ring)
    # A ring may be laid with its long axis to either side.
    left = along if along[0] >= 0 else -along
    share = SECTORS[sector]
    return replace(muscle, ring=replace(ring, sector=share[0] * _unit(left) + share[1] * _unit(up)))


def sector_of(muscle: Muscle) -> Sector:
    """How much of its ring a muscle is made of."""
    ring = ring_of(muscle)
    if not ring.sector.any():
        return "whole"
    alike = {name: float(_sector(muscle, name) @ ring.sector) for name in SECTORS}
    return max(alike, key=lambda name: alike[name])


def _sector(muscle: Muscle, name: Sector) -> FloatArray:
    return ring_of(with_sector(muscle, name)).sector


def _unit(vector: FloatArray) -> FloatArray:
    return np.asarray(vector / max(float(np.linalg.norm(vector)), TOO_SHORT))


def _carried(before: FloatArray, after: FloatArray, other: FloatArray) -> FloatArray:
    """Another half axis after the smallest turn that takes one half axis to where it is dragged.

    Half a turn is made about the ring's normal, so that the ring still faces outward.
    """
    a, b = before / np.linalg.norm(before), after / np.linalg.norm(after)
    axis, cosine = np.cross(a, b), float(a @ b)
    if cosine < -1 + TOO_SHORT:
        return np.negative(other)
    return np.asarray(other * cosine + np.cross(axis, other) + axis * (axis @ other) / (1 + cosine))
