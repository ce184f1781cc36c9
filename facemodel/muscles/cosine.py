"""The cosine pseudo-muscles of Hung and Huang 1995, which displace vertices and know no forces."""

from __future__ import annotations

import numpy as np

from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from facemodel.muscles.muscle import Cosine, Muscle
from facemodel.muscles.sphincter import SEAM, half
from fem.types import FloatArray

SHARE = 0.3
"""Part of the way to the point of attraction at full contraction: a living muscle shortens by about a third."""

FOLDS = 2 / np.pi
"""Radii that the point of application may go before the skin behind it folds over: the cosine is steepest, pi / 2R,
half way out."""

FACTORS = (0.4, 0.4, 0.0)
"""K of a ring in its plane and along its normal."""


def cosine_of(muscle: Muscle) -> Cosine:
    """Bounding box and factors of a muscle.

    By default the box holds the whole radius, as the authors advise, and no fibre goes so far that skin folds.
    """
    if muscle.cosine is not None:
        return muscle.cosine
    longest = max((float(np.linalg.norm(f.origin - f.attachment)) for f in muscle.fibres), default=0.0)
    share = min(SHARE, FOLDS * radius(muscle) / longest) if longest > 0 else SHARE
    return Cosine(np.full(3, radius(muscle)), share, np.array(FACTORS))


def radius(muscle: Muscle) -> float:
    """R in millimetres: the width of a linear pseudo-muscle, the long half axis and the width of a ring."""
    if muscle.model != "cosine_ring" or muscle.ring is None:
        return float(muscle.width)
    return float(np.linalg.norm(muscle.ring.long_axis) + muscle.width)


def cosine_displacements(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Displacement (N, 3) of the skin's vertices, millimetres, of linear pseudo-muscles.

    P' = P + (1 + cos(pi |Po - P| / R)) / 2 (Pd - Po) t for every vertex in the bounding box: Po is the point of
    application (the attachment), Pd the point of attraction (the origin), R the radius (the muscle's width).
    The authors warn of singularities where R is much smaller than the box: the cosine rises again past R.
    Here it is zero from R on, which is meant.  Their t = 1 takes Po all the way; full contraction is
    t = `Cosine.share`.  Several central fibres are averaged.
    """
    how = cosine_of(muscle)
    total = np.zeros_like(skin.positions)
    for fibre in muscle.fibres:
        away = skin.positions - fibre.attachment
        weight = _cosine(away, muscle.width, how.box)
        total += weight[:, None] * (fibre.origin - fibre.attachment)
    return np.asarray(how.share / max(len(muscle.fibres), 1) * total)


def cosine_ring_displacements(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Displacement (N, 3) of the skin's vertices, millimetres, of a sphincter pseudo-muscle.

    P' = P + K (1 + cos(pi |Po - P| / R)) / 2 (Pd - P) t, with Po and Pd the centre of the ring, R as `radius`
    says, and K one factor for each axis of the ring, so that it can contract along one and expand along
    another; a half ring takes its share.  The published formula has P - Pd and says that a positive K means
    contraction, which contradict each other; the sign is turned so that it does.
    """
    ring = muscle.ring
    if ring is None:
        raise FaceError(f"Muscle “{muscle.key}” is a pseudo-sphincter without a ring; give it centre and half axes.")
    how = cosine_of(muscle)
    along, up = (axis / np.linalg.norm(axis) for axis in (ring.long_axis, ring.short_axis))
    frame = np.stack([along, up, np.cross(along, up)])
    away = skin.positions - ring.centre
    weight = _cosine(away, radius(muscle), how.box) * half(away, ring.sector, SEAM)
    return np.asarray(-weight[:, None] * ((away @ frame.T) * how.factors @ frame))


def _cosine(away: FloatArray, reach: float, box: FloatArray) -> FloatArray:
    """Weight (N,) at offsets (N, 3) from the point of application."""
    distance = np.minimum(np.linalg.norm(away, axis=1) / reach, 1.0)
    return np.asarray((1 + np.cos(np.pi * distance)) / 2 * (np.abs(away) <= box).all(axis=1))
