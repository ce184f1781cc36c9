"""Arrows on the skin, as long on the screen at every zoom."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from fem.types import FloatArray, IntArray
from ui.viewport.shading import MATTE, apply
from ui.viewport.surface import Surface

LONGEST = 0.085
"""Length of the largest arrow over the height of the picture."""
SIDES = 5
SHAFT, HEAD, HEAD_SHARE = 0.0007, 0.0028, 0.26
"""Radius of shaft and head over the height of the picture, and the head's share of the length."""


class ArrowField:
    """A number of arrows in one actor.

    Attributes
    ----------
    actor : the VTK side

    Parameters
    ----------
    colour : of all of them
    most : arrows that there is room for; of more, the longest are drawn
    """

    def __init__(self, colour: tuple[float, float, float], most: int) -> None:
        self._most = most
        self._ring, triangles = _arrow()
        shape = (most * len(self._ring), 3)
        faces = (triangles[None] + len(self._ring) * np.arange(most)[:, None, None]).reshape(-1, 3)
        self._surface = Surface(np.zeros(shape, np.float32), np.zeros(shape, np.float32), faces)
        self.actor: vtkActor = self._surface.actor
        self.actor.GetProperty().SetColor(*colour)
        self.actor.PickableOff()
        apply(self.actor, MATTE)

    def show(self, places: FloatArray, vectors: FloatArray, height: float) -> None:
        """Draw arrows from places (n, 3) along vectors (n, 3); the height of the picture in millimetres scales them."""
        size = np.linalg.norm(vectors, axis=1)
        chosen = np.argsort(-size, kind="stable")[: self._most]
        chosen = chosen[size[chosen] > 0]
        points = self._surface.points.reshape(self._most, -1, 3)
        points[:] = places[chosen[0]] if len(chosen) else 0.0
        self.actor.SetVisibility(len(chosen) > 0)
        if len(chosen):
            along = vectors[chosen] / size[chosen, None]
            length = height * LONGEST * np.sqrt(size[chosen] / size[chosen[0]])
            points[: len(chosen)], normals = _arrows(self._ring, places[chosen], along, length, height)
            self._surface.normals.reshape(self._most, -1, 3)[: len(chosen)] = normals
        self._surface.moved()

    def hide(self) -> None:
        """Draw none."""
        self.actor.VisibilityOff()


def _arrow() -> tuple[FloatArray, IntArray]:
    """An arrow along +z: rows of (x, y, z, radius kind), kinds 0 shaft, 1 head, 2 tip."""
    turn = 2 * np.pi * np.arange(SIDES) / SIDES
    circle = np.stack([np.cos(turn), np.sin(turn)], axis=1)

    def ring(z: float, kind: int) -> FloatArray:
        return np.column_stack([circle, np.full(SIDES, z), np.full(SIDES, kind)])

    rows = [ring(0, 0), ring(1 - HEAD_SHARE, 0), ring(1 - HEAD_SHARE, 1), ring(1, 2)]
    triangles = []
    for k in range(3):
        a = k * SIDES + np.arange(SIDES)
        b = k * SIDES + (np.arange(SIDES) + 1) % SIDES
        triangles += [np.stack([a, b, b + SIDES], 1), np.stack([a, b + SIDES, a + SIDES], 1)]
    return np.concatenate(rows), np.concatenate(triangles)


def _arrows(
    ring: FloatArray, place: FloatArray, along: FloatArray, length: FloatArray, height: float
) -> tuple[FloatArray, FloatArray]:
    """Points and normals (n, R, 3) of arrows."""
    helper = np.where(np.abs(along[:, :1]) < 0.9, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    first = np.cross(along, helper)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(along, first)
    radius = height * np.array([SHAFT, HEAD, 0.0])[ring[:, 3].astype(int)]
    out = first[:, None] * ring[None, :, :1] + second[:, None] * ring[None, :, 1:2]
    points = place[:, None] + out * radius[None, :, None] + along[:, None] * (ring[:, 2] * length[:, None])[..., None]
    return points, out
