"""A picture of what a muscle does under one model: the moved skin, coloured by how far it went."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.eyeball import eyeball
from facemodel.face import Eye, Face
from facemodel.model_fields import ModelFields
from facemodel.muscles.muscle import Model
from facemodel.smooth import smooth
from facemodel.solution import Progress
from fem.types import FloatArray
from ui.viewport.colour_map import cividis
from ui.viewport.ray_picture import Painted, Standpoint, joined, ray_picture
from ui.viewport.surface import ByteArray

CLAY = (0.80, 0.71, 0.66)
"""Skin that does not move."""

COVER, FADE = 0.88, 0.12
"""How much of the skin the colours cover, and the share of the largest way below which they fade."""

SEEN = 0.12
"""Share of the largest way from which skin is to be in the picture."""

ROOM, LEAST = 1.25, 34.0
"""Height of the picture over that of what moves, and millimetres of half of it at least."""


@dataclass(frozen=True, eq=False)
class PictureAsked:
    """What is to be drawn.

    Attributes
    ----------
    face : whose eyes look out of the skin
    fields : of all models
    model : the one that is drawn
    at : from where
    size : width and height in pixels
    """

    face: Face
    fields: ModelFields
    model: Model
    at: Standpoint
    size: tuple[int, int]


def drawn(asked: PictureAsked, progress: Progress) -> ByteArray:
    """The picture (height, width, 4); raises what the progress raises."""
    fields = asked.fields
    way = fields.fields[asked.model].displacement.astype(np.float64)
    share = np.linalg.norm(way, axis=1) / max(fields.largest, 1e-9)
    cover = (COVER * smooth(share, 0.0, FADE))[:, None]
    colours = np.array(CLAY) * (1 - cover) + cividis(share) * cover
    skin = Painted(fields.display.points + way, fields.display.triangles, colours)
    eyes = [_ball(eye) for eye in asked.face.eyes]
    return ray_picture(joined(skin, *eyes), asked.at, asked.size, lambda: progress("Drawing", 0.5))


def _ball(eye: Eye) -> Painted:
    """An eyeball without its clear cornea."""
    ball = eyeball(eye)
    mesh, own = ball.opaque
    return Painted(mesh.positions, mesh.triangles, ball.colours[own, :3])


def standpoint(fields: ModelFields, towards: FloatArray, up: FloatArray, aspect: float) -> Standpoint:
    """Where all models are seen from alike: from where one looks, near enough for what moves under any of them.

    Parameters
    ----------
    towards : (3,) unit vector to the eye
    up : (3,) of the camera
    aspect : width of the pictures over their height
    """
    right = np.cross(up, towards)
    right /= max(float(np.linalg.norm(right)), 1e-9)
    upright = np.cross(towards, right)
    points = fields.display.points.astype(np.float64)
    size = np.max([np.linalg.norm(field.displacement, axis=1) for field in fields.fields.values()], axis=0)
    moving = points[size > SEEN * max(fields.largest, 1e-9)] if fields.largest > 0 else points
    across, along = moving @ right, moving @ upright
    middle = (across.max() + across.min()) / 2 * right + (along.max() + along.min()) / 2 * upright
    centre = middle + float((moving @ towards).mean()) * towards
    half = max(np.ptp(along) / 2, np.ptp(across) / 2 / aspect) * ROOM
    return Standpoint(centre, towards, upright, float(max(half, LEAST)))
