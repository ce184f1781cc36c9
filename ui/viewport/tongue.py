"""A tongue that comes out of the mouth as it is drawn; the jaw's motion is given to its actor."""

from __future__ import annotations

import numpy as np

from facemodel.face import Face, Part
from facemodel.motions import TongueMotion
from facemodel.tongue import tongue_places
from ui.viewport.parts import rounded
from ui.viewport.surface import Surface

IN_THE_LIGHT = 6.0
"""Millimetres by which a tongue has come out when its tip is as bright as the lips."""

BRIGHT = 215
"""Openness of what lies before the lips, of 255."""


class Tongue:
    """Bends what is drawn of a tongue.

    Parameters
    ----------
    face, part : the tongue and whose it is
    surface : as it is drawn at rest
    """

    def __init__(self, face: Face, part: Part, surface: Surface) -> None:
        self._face, self._part, self._surface = face, part, surface
        self._colours = None if surface.colours is None else surface.colours.copy()
        self._front = float(part.mesh.positions[:, 2].max())
        self._motion = TongueMotion()

    def move(self, motion: TongueMotion) -> None:
        """Draw it as a motion has it."""
        if motion == self._motion:
            return
        self._motion = motion
        mesh = rounded(self._part.mesh.moved(tongue_places(self._face, self._part, motion)))
        self._surface.points[:] = mesh.positions
        self._surface.normals[:] = mesh.normals
        self._surface.moved()
        colours = self._surface.colours
        if colours is not None and self._colours is not None:
            outside = np.clip((mesh.positions[:, 2] - self._front) / IN_THE_LIGHT, 0.0, 1.0)
            own = self._colours[:, 3].astype(np.float64)
            colours[:, 3] = (own + outside * np.maximum(BRIGHT - own, 0.0)).astype(np.uint8)
            self._surface.recoloured()
