"""The tongue as it comes out of the mouth: along the floor, over the lower teeth and lip, and down before them."""

from __future__ import annotations

import numpy as np

from facemodel.face import Face, Part
from facemodel.motions import TongueMotion
from facemodel.smooth import smooth_step
from fem.types import FloatArray

ROOTED = 0.15
"""Share of the tongue's length from its back that never moves: it is grown to the hyoid bone."""

OVER_TEETH = 1.5
"""Millimetres between the edges of the lower teeth and the tongue that lies over them."""

CLIMB = 22.0
"""Millimetres behind the lower incisors from which on a tongue that comes out rises over them."""

FLAT = 0.85
"""Thickness of the tongue between the teeth, as a share of its thickness at rest."""

LEVEL = 3.0
"""Millimetres that the tongue goes on level before the teeth, before it bends down."""

POINTED = 0.3
"""Share of the tongue's length over which it narrows towards the tip, which at rest is hidden behind the teeth."""

NARROW = 0.5
"""How much of its width the very tip loses."""

DOMED = 2.5
"""Millimetres by which the middle of the upper side stands above its edges before the teeth."""

READY = 8.0
"""Millimetres by which the tip comes forward until it has risen over the teeth."""


def tongue_places(face: Face, part: Part, motion: TongueMotion) -> FloatArray:
    """The tongue (n, 3) that comes out, with the mandible at rest.

    Parameters
    ----------
    face : whose lower teeth it goes over; without any it goes straight on
    part : the tongue at rest
    motion : how far it comes out and how its tip is bent
    """
    rest = part.mesh.positions
    back, tip = float(rest[:, 2].min()), float(rest[:, 2].max())
    share = np.clip(((rest[:, 2] - back) / (tip - back) - ROOTED) / (1 - ROOTED), 0.0, 1.0)
    moved = rest.copy()
    moved[:, 2] += motion.out * share**1.5
    edge, front = _lower_edge(face, rest)
    out = min(max(motion.out, 0.0) / READY, 1.0)
    climbed = smooth_step((moved[:, 2] - (front - CLIMB)) / CLIMB) * out
    middle = _middle(rest)
    thin = 1 - (1 - FLAT) * climbed
    rise = np.maximum(edge + OVER_TEETH + FLAT * (middle - _underside(rest)) - middle, 0.0)
    moved[:, 1] = middle + thin * (rest[:, 1] - middle) + climbed * rise
    ahead = np.clip((share - (1 - POINTED)) / POINTED, 0.0, 1.0)
    moved[:, 0] *= 1 - NARROW * out * ahead**3
    edge_of = np.maximum(np.abs(rest[:, 0]).max() * (1 - 0.5 * share), 1.0)
    dome = np.maximum(1 - (rest[:, 0] / edge_of) ** 2, 0.0) * (rest[:, 1] > middle)
    moved[:, 1] += DOMED * climbed * dome
    beyond = np.maximum(moved[:, 2] - front - LEVEL, 0.0)
    angle = np.radians(motion.lift) * np.minimum(beyond / READY, 1.0)
    moved[:, 1] += np.sin(angle) * beyond
    moved[:, 2] -= (1 - np.cos(angle)) * beyond
    return moved


def _lower_edge(face: Face, rest: FloatArray) -> tuple[float, float]:
    """Height of the edge of the lower incisors, and how far forward it is."""
    for part in face.parts:
        if part.kind == "teeth" and part.carrier == "jaw":
            teeth = part.mesh.positions
            incisors = teeth[teeth[:, 2] > teeth[:, 2].max() - CLIMB / 2]
            return float(incisors[:, 1].max()), float(incisors[:, 2].max())
    return float(rest[:, 1].min()), float(rest[:, 2].max())


def _middle(rest: FloatArray) -> FloatArray:
    """Height (n,) halfway through the tongue at every place of it, as a smooth curve from back to tip."""
    curve = np.polynomial.Polynomial.fit(rest[:, 2], rest[:, 1], 3)
    return np.asarray(curve(rest[:, 2]))


def _underside(rest: FloatArray) -> FloatArray:
    """Height (n,) of the tongue's underside along that curve."""
    middle = _middle(rest)
    return np.asarray(middle + np.minimum(rest[:, 1] - middle, 0.0).min())
