"""The mouth sphincter of Choe, Lee and Ko 2001, eq. 2, with the profiles sigma and tau that a person edits."""

from __future__ import annotations

import numpy as np

from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from facemodel.muscles.fibre import lateral
from facemodel.muscles.muscle import Muscle
from facemodel.muscles.profile import Profile, Profiles
from facemodel.muscles.sphincter import SEAM, half
from fem.types import FloatArray

PROFILES = Profiles(
    sigma=Profile((0.0, 0.5, 1.0, 1.7), (0.0, 0.4, 1.0, 0.0)),
    tau=Profile((0.0, 0.5, 1.0, 1.7), (0.5, 0.9, 0.9, 0.0)),
)
"""The paper shows its profiles as pictures only.  Ours pull most on the ring and not at all in its middle, where there
is no direction, and purse lips as far as `Sphincter.forward` does in the shipped atlas."""


def mouth_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Force per area (N, 3) on the skin, N/mm^2, of orbicularis oris.

    f_ij = a_i f_i sigma(s) d_ij, and a_i f_i tau(s) for its third component, with the elliptic distance
    s = sqrt((l_x / g)^2 + (l_y / h)^2) (eq. 2): g and h are the half axes of the ring and f_i is the strength.
    The influenced area ends at the last knot of a profile.

    The unit vector d_ij to the centre is taken in the plane of the ellipse, since its third component is
    replaced.  Beyond the paper, which picks the vertices of the mouth by hand, the force fades with the
    distance from that plane, so that it never reaches the back of the head, and a ring may be a half one.
    """
    ring = muscle.ring
    if ring is None:
        raise FaceError(f"Muscle “{muscle.key}” is a mouth without a ring; give it a centre and two half axes.")
    profiles = muscle.profiles or PROFILES
    g, h = np.linalg.norm(ring.long_axis), np.linalg.norm(ring.short_axis)
    along, up = ring.long_axis / g, ring.short_axis / h
    outward = np.cross(along, up)
    d = skin.positions - ring.centre
    x, y, depth = d @ along, d @ up, d @ outward
    s = np.hypot(x / g, y / h)
    centrally = -(x[:, None] * along + y[:, None] * up) / np.maximum(np.hypot(x, y), 1e-9)[:, None]
    weight = half(d, ring.sector, SEAM) * lateral(np.abs(depth) / (g + muscle.width))
    force = profiles.sigma(s)[:, None] * centrally + profiles.tau(s)[:, None] * outward
    return np.asarray(muscle.strength * weight[:, None] * force)
