"""What a face looks like, computed once per face: colours, openness and fine detail of its skin."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import numpy as np

from app.differences import same_head
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.smooth import smooth
from fem.types import FloatArray
from ui.viewport.complexion import Palette, complexion, has_features, near, openings, palette_of
from ui.viewport.detail import Detail, skin_detail
from ui.viewport.furrows import Furrows, furrows
from ui.viewport.occlusion import openness
from ui.viewport.surface import ByteArray

NECK_FADE, NECK_DARK = 55.0, 0.45
"""Millimetres over which the neck rises out of the dark, and its openness at the rim."""
UNDER_CHIN = 17.0
"""Millimetres below the chin over which that dark sets in."""
CONTRAST = 1.35
"""Exponent on the openness: rays spread over a hemisphere tell too gently what the eye sees as a hollow."""
NOSTRIL = 4.6
"""Radius of a nostril in millimetres; the mesh has a dent there, life a hole that no light comes out of."""
CORNER_DARK, CORNER_REACH = 0.65, 2.4
"""Share of the light that the corners of the mouth lack, and about how many millimetres around them: they dent the skin
less than in life, and would shine."""
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
    furrows : where it furrows, if the features are known
    detail : the picture of brows, pores and lines, if the features are known
    """

    palette: Palette
    colours: FloatArray
    open: FloatArray
    furrows: Furrows | None
    detail: Detail | None


_known: deque[tuple[Face, Look]] = deque(maxlen=KEPT)


def look_of(face: Face) -> Look:
    """The look of a face; one whose features are unknown has one colour and no detail.

    It is remembered, and the same for all paint on one head.
    """
    for known, look in tuple(_known):
        if same_head(known, face):
            return look
    look = _look(face)
    _known.append((face, look))
    return look


def _look(face: Face) -> Look:
    palette = palette_of(face)
    if has_features(face):
        lines = furrows(face)
        return Look(palette, complexion(face).colours, _shade(face, face.skin), lines, skin_detail(face, lines.lines))
    plain = np.broadcast_to(palette.skin, face.skin.positions.shape)
    return Look(palette, plain, openness(face.skin, face.skin) ** CONTRAST, None, None)


def _shade(face: Face, skin: Mesh) -> FloatArray:
    """Openness (N,) with dark nostrils and a neck that rises out of the dark."""
    position = skin.positions
    open_ = openness(skin, _closed(face)) ** CONTRAST
    open_ = (open_ + open_[face.mirror]) / 2  # halves the grain of the rays, and faces are even-sided enough for shade
    nostril = _nostrils(face, open_)
    rim = position[skin.boundary_loops[-1]]
    normal = np.linalg.svd(rim - rim.mean(axis=0))[2][2]
    rise = np.abs((position - rim.mean(axis=0)) @ normal)
    chin = position[face.landmarks["menton"], 1]
    below = smooth(position[:, 1], chin, chin - UNDER_CHIN)
    dim = (1 - NECK_DARK) * smooth(rise, NECK_FADE, 0.0) * below
    corners = CORNER_DARK * near(face, ("mouth_corner_L", "mouth_corner_R"), CORNER_REACH)
    return np.asarray(open_ * (1 - 0.92 * nostril) * (1 - dim) * (1 - corners))


def _nostrils(face: Face, open_: FloatArray) -> FloatArray:
    """How far each vertex (N,) lies inside a nostril: around the darkest place under each wing of the nose."""
    position, normal = face.skin.positions, face.skin.normals
    tip, foot = position[face.landmarks["nose_tip"]], position[face.landmarks["subnasale"]]
    inside = np.zeros(len(position))
    for side in "LR":
        wing = position[face.landmarks[f"ala_{side}"]]
        share = position[:, 0] / wing[0]
        under = (share > 0.3) & (share < 0.95) & (normal[:, 1] < -0.5) & (position[:, 2] > wing[2])
        under &= (position[:, 1] > foot[1] - 4) & (position[:, 1] < tip[1] + 4)
        if under.any():
            middle = position[np.where(under, open_, np.inf).argmin()]
            distance = np.linalg.norm(position - middle, axis=1)
            inside = np.maximum(inside, smooth(distance, NOSTRIL, 0.35 * NOSTRIL))
    return inside * smooth(-normal[:, 1], 0.3, 0.7)


def _closed(face: Face) -> Mesh:
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
