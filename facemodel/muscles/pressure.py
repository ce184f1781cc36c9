"""Breath behind the cheek: a pressure on the inside of the skin, which no muscle pulls."""

from __future__ import annotations

import numpy as np

from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from facemodel.muscles.fibre import lateral
from facemodel.muscles.muscle import Muscle
from fem.types import FloatArray


def pressure_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Force per area (N, 3) on the skin, N/mm^2, of a pressure from within.

    It acts along the skin's own normal, evenly within the ellipse of the ring, and fades over the muscle's width past
    it and with the distance from its plane.
    """
    ring = muscle.ring
    if ring is None:
        raise FaceError(f"Muscle “{muscle.key}” is a pressure without a ring; give it a centre and two half axes.")
    a, b = np.linalg.norm(ring.long_axis), np.linalg.norm(ring.short_axis)
    along, up = ring.long_axis / a, ring.short_axis / b
    d = skin.positions - ring.centre
    u, v, depth = d @ along, d @ up, d @ np.cross(along, up)
    radius = np.hypot(u / a, v / b)
    distance = np.hypot(u, v)
    beyond = np.maximum(radius - 1.0, 0.0) * distance / np.maximum(radius, 1e-9)
    weight = lateral(beyond / muscle.width) * lateral(np.abs(depth) / (min(a, b) + muscle.width))
    return np.asarray(muscle.strength * ring.inward * weight[:, None] * skin.normals)
