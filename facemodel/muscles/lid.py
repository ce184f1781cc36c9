"""The levator of the upper lid: it turns the tarsal plate about the eyeball, so that the lid glides on it."""

from __future__ import annotations

import numpy as np

from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from facemodel.muscles.fibre import lateral
from facemodel.muscles.muscle import Muscle
from fem.types import FloatArray


def lid_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Force per area (N, 3) on the skin, N/mm^2, of a lid that turns about the eyeball.

    The ring's centre is the eyeball's, its long axis spans the lid from canthus to canthus and its short
    axis goes from the middle of the fissure to the lid's margin and ends at the lid's fold.  The force is
    tangent to the eyeball, towards the fissure for a positive ``inward``; it is largest at the margin in
    the middle of the lid and fades to the canthi, to the fold and on the opposite lid.
    """
    ring = muscle.ring
    if ring is None:
        raise FaceError(f"Muscle “{muscle.key}” is a lid without a ring; give it a centre and two half axes.")
    a, b = np.linalg.norm(ring.long_axis), np.linalg.norm(ring.short_axis)
    along, up = ring.long_axis / a, ring.short_axis / b
    d = skin.positions - ring.centre
    u, v, depth = d @ along, d @ up, d @ np.cross(along, up)
    span = np.maximum(1 - (u / a) ** 2, 0.0)
    height = lateral(np.maximum(v, 0.0) / b) * (v > 0) * (depth > 0)
    swing = np.cross(along, d - u[:, None] * along)
    swing *= np.sign(swing @ up)[:, None] / np.maximum(np.linalg.norm(swing, axis=1, keepdims=True), 1e-9)
    return np.asarray(-muscle.strength * ring.inward * (span * height)[:, None] * swing)
