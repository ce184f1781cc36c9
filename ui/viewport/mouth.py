"""Light in the mouth: closed lips keep it out, and teeth behind a narrow slit are dark."""

from __future__ import annotations

import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.openings import mouth_of
from facemodel.sampling import points_of_vertices
from facemodel.smooth import smooth
from fem.types import Float32Array, FloatArray
from ui.viewport.surface import ByteArray, Surface

SHUT, OPEN = 0.4, 5.0
"""Millimetres that lips part beyond their rest at which the mouth is dark, and at which it is as light as can be."""
LEAST = 0.10
"""Share of the light that finds its way between lips that rest on each other."""
STEP = 0.02
"""Change of the light that is seen."""


class MouthLight:
    """Shades what lies in the mouth of a face by how far its lips are apart.

    Parameters
    ----------
    face, display : as they are drawn; without the slit of a mouth all stays as light as it is
    inside : what is shaded
    """

    def __init__(self, face: Face, display: DisplaySurface, inside: list[Surface]) -> None:
        mouth = mouth_of(face)
        number = points_of_vertices(face, display)
        self._lips = None if mouth is None else (number[mouth.upper[1:-1]], number[mouth.lower[1:-1]])
        lit = [(surface, surface.colours) for surface in inside if surface.colours is not None]
        self._inside: list[tuple[Surface, ByteArray, ByteArray]] = [(s, c, c[:, 3].copy()) for s, c in lit]
        self._rest = 0.0
        self._light = 1.0
        self._rest = self.parted(display.points)

    def parted(self, points: Float32Array) -> float:
        """How far the lips of a posed skin (P, 3) are apart in their middle, beyond their rest; millimetres."""
        if self._lips is None:
            return OPEN
        upper, lower = (points[chain].astype(np.float64) for chain in self._lips)
        middle = upper[len(upper) // 2, 0] + np.array([-8.0, -4.0, 0.0, 4.0, 8.0])
        return float(np.mean(_height(upper, middle) - _height(lower, middle)) - self._rest)

    def follow(self, parted: float) -> None:
        """Shade a mouth whose lips are so many millimetres apart."""
        light = LEAST + (1 - LEAST) * float(smooth(np.array([parted]), SHUT, OPEN)[0])
        if self._lips is None or abs(light - self._light) < STEP:
            return
        self._light = light
        for surface, colours, openness in self._inside:
            colours[:, 3] = np.clip(light * openness, 0, 255)
            surface.recoloured()


def _height(lip: FloatArray, at: FloatArray) -> FloatArray:
    order = np.argsort(lip[:, 0])
    return np.interp(at, lip[order, 0], lip[order, 1])
