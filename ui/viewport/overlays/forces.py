"""The force field of the expression in hand: thin arrows on the skin, as long on the screen at every zoom."""

from __future__ import annotations

import numpy as np

from fem.types import FloatArray, IntArray
from ui.viewport.muscle_fields import FieldForces
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.overlays.supports import points_of_vertices
from ui.viewport.shading import MATTE, apply
from ui.viewport.surface import Surface

LONGEST = 0.085
"""Length of the largest arrow over the height of the picture."""
WEAKEST = 0.05
"""Share of the largest force below which no arrow is drawn."""
MOST = 700
"""Arrows drawn at most; of more, the strongest."""
SIDES = 5
SHAFT, HEAD, HEAD_SHARE = 0.0007, 0.0028, 0.26
"""Radius of shaft and head over the height of the picture, and the head's share of the length."""
LIFT = 0.4
"""Millimetres above the skin."""
COLOUR = (0.95, 0.52, 0.36)


class ForcesOverlay(Overlay):
    """Arrows along the force on every skin vertex."""

    def build(self, drawn: Drawn) -> None:
        """Make room for the arrows."""
        face, figure = drawn.project.face, drawn.figure
        self._at = points_of_vertices(face, figure.posed.basis.display)
        self._forces = FieldForces(drawn.project)
        ring, triangles = _arrow()
        self._ring = ring
        shape = (MOST * len(ring), 3)
        faces = (triangles[None] + len(ring) * np.arange(MOST)[:, None, None]).reshape(-1, 3)
        self._surface = Surface(np.zeros(shape, np.float32), np.zeros(shape, np.float32), faces)
        self._surface.actor.GetProperty().SetColor(*COLOUR)
        apply(self._surface.actor, MATTE)
        self.add(self._surface.actor)

    def follow(self, drawn: Drawn) -> None:
        """Draw the forces of the expression on the posed skin."""
        force = self._forces.of(drawn.expression)
        size = np.linalg.norm(force, axis=1)
        top = float(size.max(initial=0.0))
        chosen = np.flatnonzero(size > WEAKEST * top) if top > 0 else np.zeros(0, dtype=np.int64)
        chosen = chosen[np.argsort(-size[chosen], kind="stable")[:MOST]]
        points = self._surface.points.reshape(MOST, -1, 3)
        points[:] = drawn.figure.posed.points[0]
        if len(chosen):
            height = 2 * drawn.half_height
            place = drawn.figure.posed.points[self._at[chosen]] + LIFT * drawn.figure.posed.normals[self._at[chosen]]
            along = force[chosen] / size[chosen, None]
            length = height * LONGEST * np.sqrt(size[chosen] / top)
            points[: len(chosen)], normals = _arrows(self._ring, place, along, length, height)
            self._surface.normals.reshape(MOST, -1, 3)[: len(chosen)] = normals
        self._surface.moved()


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
