"""A sphincter: a ring of muscle grown together with the skin only, which closes on itself."""

from __future__ import annotations

import numpy as np

from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from facemodel.muscles.fibre import lateral
from facemodel.muscles.muscle import Muscle
from fem.types import FloatArray

SEAM = 6.0
"""Millimetres over which the two halves of a ring take over from each other at the midline."""


def half(offset: FloatArray, sector: FloatArray, seam: float) -> FloatArray:
    """Share (N,) of the half ring that lies towards ``sector``; the halves to both sides add up to one."""
    if not sector.any():
        return np.ones(len(offset))
    across = np.clip(offset @ sector / np.linalg.norm(sector) / seam, -1, 1)
    return np.asarray((1 + np.sin(np.pi / 2 * across)) / 2)


def sphincter_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Force per area (N, 3) on the skin, N/mm^2, of a ring of fibres.

    In the plane of the ring the force points at its line of closure (a segment on the long axis, ``focus``
    of it long) and is largest on the ring; it fades over the muscle's width to both sides.  A share
    ``forward`` acts along the ring's outward normal, which purses lips.
    """
    ring = muscle.ring
    if ring is None:
        raise FaceError(f"Muscle “{muscle.key}” is a sphincter without a ring; give it a centre and two half axes.")
    a, b = np.linalg.norm(ring.long_axis), np.linalg.norm(ring.short_axis)
    along, up = ring.long_axis / a, ring.short_axis / b
    outward = np.cross(along, up)
    d = skin.positions - ring.centre
    u, v, depth = d @ along, d @ up, d @ outward
    closure = np.clip(u, -ring.focus * a, ring.focus * a)
    inward = (closure - u)[:, None] * along - v[:, None] * up
    distance = np.linalg.norm(inward, axis=1)
    radius = np.hypot(u / a, v / b)
    off_ring = np.abs(radius - 1) * distance / np.maximum(radius, 1e-9)
    weight = lateral(off_ring / muscle.width) * lateral(np.abs(depth) / (a + muscle.width))
    weight = weight * half(d, ring.sector, SEAM)
    direction = ring.inward * inward / np.maximum(distance, 1e-9)[:, None] + ring.forward * outward
    return np.asarray(muscle.strength * weight[:, None] * direction)
