"""Lay a sphincter as an ellipse on the skin, and drag its middle and half axes."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from facemodel.errors import MuscleError
from facemodel.face import Face
from facemodel.muscles import Muscle, Sphincter
from fem.types import FloatArray

Axis = Literal["long", "short"]

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


def _carried(before: FloatArray, after: FloatArray, other: FloatArray) -> FloatArray:
    """Another half axis after the smallest turn that takes one half axis to where it is dragged.

    Half a turn is made about the ring's normal, so that the ring still faces outward.
    """
    a, b = before / np.linalg.norm(before), after / np.linalg.norm(after)
    axis, cosine = np.cross(a, b), float(a @ b)
    if cosine < -1 + TOO_SHORT:
        return np.negative(other)
    return np.asarray(other * cosine + np.cross(axis, other) + axis * (axis @ other) / (1 + cosine))
