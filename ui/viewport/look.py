"""What a face looks like, computed once per face: colours, openness and fine detail of its skin."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.mesh import Mesh
from fem.types import FloatArray
from ui.viewport.complexion import Palette, complexion, openings, palette_of, smooth
from ui.viewport.detail import Detail, skin_detail
from ui.viewport.occlusion import openness
from ui.viewport.surface import ByteArray

NECK_FADE = 55.0
"""Millimetres over which the neck rises out of the dark."""
NOSTRIL = 9.0
"""Millimetres around a nostril's opening within which what is turned to the bone is inside it."""
KEPT = 4
"""Faces whose look is remembered, so that a new solution of a face costs nothing here."""


@dataclass(frozen=True, eq=False)
class Look:
    """The look of a resting face, by skin vertex.

    Attributes
    ----------
    palette : colours of its owner
    colours : (N, 3) sRGB 0..1
    open : (N,) share of the light from all around that arrives, 0..1
    detail : the picture of brows, pores and lip lines
    """

    palette: Palette
    colours: FloatArray
    open: FloatArray
    detail: Detail


@lru_cache(maxsize=KEPT)
def look_of(face: Face) -> Look:
    """The look of a face."""
    skin = face.skin
    return Look(palette_of(face), complexion(face).colours, _shade(face, skin), skin_detail(face))


def _shade(face: Face, skin: Mesh) -> FloatArray:
    """Openness with the neck fading down, and lids and lips not blackened by their own closeness."""
    blockers = _with_eyes(face)
    open_ = openness(skin, blockers)
    rim = skin.boundary_loops[-1]
    plane = skin.positions[rim]
    normal = np.linalg.svd(plane - plane.mean(axis=0))[2][2]
    rise = np.abs((skin.positions - plane.mean(axis=0)) @ normal)
    below = smooth(skin.positions[:, 1], skin.positions[face.landmarks["menton"], 1], plane[:, 1].max())
    fade = 0.45 + 0.55 * smooth(rise, 0.0, NECK_FADE)
    return np.asarray(open_ * (1 - below * (1 - fade)))


def _with_eyes(face: Face) -> Mesh:
    """The skin with its mouth and eyes closed by fans, so that light does not leak in through them."""
    positions, triangles = [face.skin.positions], [face.skin.triangles]
    for k, loop in enumerate(openings(face)):
        centre = len(face.skin.positions) + k
        positions.append(face.skin.positions[loop].mean(axis=0, keepdims=True))
        triangles.append(np.stack([np.roll(loop, -1), loop, np.full(len(loop), centre)], axis=1))
    return Mesh(np.concatenate(positions), np.concatenate(triangles))


def at_points(face: Face, display: DisplaySurface, values: FloatArray) -> FloatArray:
    """Values (N, ...) of the skin vertices at the drawn points (P, ...)."""
    corners = face.skin.triangles[display.elements]
    return np.asarray(np.einsum("pk,pk...->p...", display.barycentric, values[corners]))


def bytes_of(values: FloatArray) -> ByteArray:
    """Colours 0..1 as bytes in C order."""
    return np.ascontiguousarray(np.clip(values * 255 + 0.5, 0, 255), dtype=np.uint8)
