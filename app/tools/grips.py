"""Where a hand takes hold of muscles: how near the pointer is to a handle, and where it drags it."""

from __future__ import annotations

import numpy as np

from app.tools.pointer import Pointer
from facemodel.laying.handles import Handle
from facemodel.muscles import Muscle
from fem.types import FloatArray

ON_SKIN = ("attachment", "centre", "long", "short", "radius", "reach")
"""Handles that lie on the skin: they are dragged over it, and back to where it is seen after a change of expression."""

SAMPLES = 24
"""Places along a piece of fibre of which the one under the pointer is taken."""


def handle_distance(pointer: Pointer, handle: Handle) -> float:
    """Millimetres between the pointer and a handle: over the face at rest for those on the skin, else as it is seen."""
    ways = []
    if handle.part in ON_SKIN and pointer.skin is not None:
        ways.append(float(np.linalg.norm(handle.point - pointer.skin.position)))
    if handle.part == "origin" and pointer.skull is not None:
        ways.append(float(np.linalg.norm(handle.point - pointer.skull.position)))
    if pointer.ray is not None:
        ways.append(float(pointer.ray.distance(handle.point)[0]))
    return min(ways, default=float("inf"))


def dragged_to(handle: Handle, pointer: Pointer, free: bool = False) -> FloatArray | None:
    """Where (3,) the pointer drags a handle: along bone or skin if it is of them, else in a plane facing the eye.

    A handle that is dragged freely is of nothing.
    """
    if free:
        return in_plane(pointer, handle.point)
    if handle.part == "origin":
        return None if pointer.skull is None else pointer.skull.position
    if handle.part == "attachment":
        return None if pointer.skin is None else pointer.skin.position
    if handle.part in ON_SKIN and pointer.skin is not None:
        return pointer.skin.position
    return in_plane(pointer, handle.point)


def in_plane(pointer: Pointer, through: FloatArray) -> FloatArray | None:
    """Where (3,) the line of sight meets the plane through a point that faces the eye."""
    ray = pointer.ray
    if ray is None:
        return None
    return np.asarray(ray.origin + ((through - ray.origin) @ ray.along) * ray.along)


def place_on_fibre(muscle: Muscle, pointer: Pointer) -> tuple[int, FloatArray]:
    """Which central fibre of a muscle the pointer is nearest to, and the place (3,) on it."""
    share = np.linspace(0.0, 1.0, SAMPLES)[1:-1, None, None]
    best, number, point = np.inf, 0, muscle.fibres[0].attachment
    for k, fibre in enumerate(muscle.fibres):
        places = ((1 - share) * fibre.points[:-1] + share * fibre.points[1:]).reshape(-1, 3)
        away = pointer.ray.distance(places) if pointer.ray is not None else np.full(len(places), np.inf)
        if away.min() < best:
            best, number, point = float(away.min()), k, places[int(np.argmin(away))]
    return number, point
