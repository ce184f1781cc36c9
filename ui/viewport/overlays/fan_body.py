"""The body of a muscle made of fibres: from a tendon on the bone over a belly to the skin."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter, median_filter

from facemodel.laying.places import ahead
from facemodel.mesh import Mesh
from facemodel.muscles import Muscle
from facemodel.muscles.curve import paths
from fem.types import FloatArray
from ui.viewport.overlays.lens import ACROSS, ROWS, grain_of, lens

STEPS = 24
"""Segments along a muscle."""

UNDER_SKIN = 1.0
"""Millimetres of skin over a muscle."""

OVER_BONE = 0.4
"""Millimetres that the belly of a muscle keeps from the bone it lies on."""

THICK, THIN = 1.7, 0.22
"""Millimetres of the outer half of a belly, and of the ends."""

BELLY, TENDON = 2.8, 1.1
"""Least half width of a muscle in its middle and at its ends: what is drawn of a fibre that has none of its own."""

SLOPE = 0.55
"""Thickness over half the width that a belly has at most: a cord is round, a sheet is flat."""

OUTSIDE = 25.0
"""Millimetres before a muscle from which skin and bone are looked for."""

MOST, DEEPEST = 9.0, 3.5
"""Millimetres that a muscle is lifted over bone, and pressed under skin, at most; what asks for more is a fold."""

AROUND = 40
"""Vertices of the skin about a place whose normals are taken together."""

EVEN = 3.0
"""Points along a muscle over which its direction is made even."""

SMOOTH = (1.2, 2.0)
"""Points across and along over which lifts are made even."""


def fan_body(muscle: Muscle, skin: Mesh, bones: tuple[Mesh, Mesh]) -> tuple[FloatArray, FloatArray]:
    """Points (rows, STEPS + 1, 3) of the body, and (rows, STEPS + 1, 2) millimetres along and across its fibres."""
    fibres = paths(muscle.fibres, ROWS, STEPS)
    tangent = _unit(np.gradient(fibres.mean(axis=0), axis=0))
    outward = _outward(fibres.mean(axis=0), tangent, skin)
    aside = _aside(fibres, np.cross(tangent, outward))
    swell = np.sin(np.pi * np.linspace(0, 1, STEPS + 1)) ** 0.8
    middles = _spread(fibres, aside, TENDON + (BELLY - TENDON) * swell)
    width = np.linalg.norm(middles[-1] - middles[0], axis=1) / 2
    thickness = THIN + (np.minimum(THICK, SLOPE * width) - THIN) * swell
    middles = middles + _lifts(middles, outward, thickness, (skin, *bones))[..., None] * outward
    body = lens(middles, thickness, outward)
    return body, grain_of(body, middles)


def _outward(middle: FloatArray, tangent: FloatArray, skin: Mesh) -> FloatArray:
    """Unit vectors (columns, 3) across the muscle as the skin over it lies at large; not as one fold of it does."""
    around = skin.tree.query(middle, k=min(AROUND, len(skin.positions)))[1]
    normal = gaussian_filter(skin.normals[around].mean(axis=1), (EVEN, 0.0), mode="nearest")
    return _unit(normal - np.einsum("jc,jc->j", normal, tangent)[:, None] * tangent)


def _aside(fibres: FloatArray, free: FloatArray) -> FloatArray:
    """Unit vectors (columns, 3) across the muscle in its own layer; along the skin, ``free``, where it is a cord."""
    own = fibres[-1] - fibres[0] if len(fibres) > 1 else np.zeros_like(free)
    own = np.einsum("jc,jc->j", own, free)[:, None] * free if _narrow(own) else own
    side = np.sign(np.einsum("jc,jc->", own, free)) or 1.0
    missing = np.maximum(2 * BELLY - np.linalg.norm(own, axis=1, keepdims=True), 0.0)
    return _unit(gaussian_filter(own + missing * side * free, (EVEN, 0.0), mode="nearest"))


def _narrow(own: FloatArray) -> bool:
    """Whether a muscle is a cord, which has no layer of its own."""
    return bool(np.linalg.norm(own, axis=1).max() < 2 * BELLY)


def _unit(vectors: FloatArray) -> FloatArray:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-9))


def _spread(fibres: FloatArray, aside: FloatArray, half: FloatArray) -> FloatArray:
    """The middle layer (ROWS, columns, 3): the fan itself, widened about its middle where it is narrower."""
    middle = fibres.mean(axis=0)
    if len(fibres) == 1:
        return np.asarray(middle + ACROSS[:, None, None] * half[:, None] * aside)
    edges = (fibres[0] + fibres[-1]) / 2
    fan = fibres - edges
    width = np.einsum("jc,jc->j", fibres[-1] - fibres[0], aside) / 2
    missing = np.sign(width) * np.maximum(half - np.abs(width), 0.0)
    order = np.interp(ACROSS, np.linspace(-1, 1, len(fibres)), np.arange(len(fibres)))
    low = np.minimum(order.astype(int), len(fibres) - 2)
    share = (order - low)[:, None, None]
    laid = fan[low] * (1 - share) + fan[low + 1] * share
    return np.asarray(edges + laid + ACROSS[:, None, None] * missing[:, None] * aside)


def _lifts(middles: FloatArray, outward: FloatArray, thickness: FloatArray, meshes: tuple[Mesh, ...]) -> FloatArray:
    """Millimetres (ROWS, columns) outward that keep a muscle under the first of the meshes and over the others."""
    ways = np.broadcast_to(outward, middles.shape).reshape(-1, 3)
    starts = middles.reshape(-1, 3) + OUTSIDE * ways
    skin, *bones = ((OUTSIDE - ahead(mesh, starts, -ways)).reshape(middles.shape[:2]) for mesh in meshes)
    inside = np.sin(np.pi * np.linspace(0, 1, middles.shape[1])) ** 0.5
    bone = np.maximum(*bones) + OVER_BONE + 0.6 * thickness
    over = np.clip(np.where(np.isfinite(bone), bone, 0.0), 0.0, MOST) * inside
    room = np.where(np.isfinite(skin), skin, MOST) - UNDER_SKIN - thickness
    under = np.clip(median_filter(room, 3, mode="nearest"), -DEEPEST, MOST)
    lifts = np.minimum(gaussian_filter(over, SMOOTH, mode="nearest"), under)
    even = gaussian_filter(lifts, SMOOTH, mode="nearest")
    return np.asarray(np.minimum(even, gaussian_filter(under, (2.5, 0.8), mode="nearest")))
