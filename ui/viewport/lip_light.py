"""Light on the inside of the lips: the shade that they have where they rest on each other leaves them as they part.

Openness is found once, at rest; what a wide mouth rolls out was dark then, and would stay so.
"""

from __future__ import annotations

import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.smooth import smooth
from ui.viewport.complexion import has_features, openings, rings
from ui.viewport.look import at_points
from ui.viewport.surface import Surface

RINGS = 9
"""Edges from the opening of the mouth over which the lips roll in."""
LIGHT = 0.62
"""Openness of the inside of parted lips."""
SHUT, PARTED = 1.0, 12.0
"""Millimetres that lips are apart beyond their rest while the light comes in."""
STEP = 0.02
"""Change of the light that is seen."""


class LipLight:
    """Lightens the inside of the lips of a skin as they part.

    Parameters
    ----------
    face, display : as they are drawn; the lips of a bare scan are not known
    skin : whose colours have openness as their fourth component
    """

    def __init__(self, face: Face, display: DisplaySurface, skin: Surface) -> None:
        self._skin = skin
        self._light = 0.0
        self._lips = np.zeros(0, dtype=np.int64)
        if skin.colours is None or not has_features(face):
            return
        ring = rings(face.skin, openings(face)[0], RINGS) / RINGS
        rest = skin.colours[:, 3].astype(np.float64)
        gain = np.sqrt(at_points(face, display, 1 - ring)) * np.maximum(255 * LIGHT - rest, 0.0)
        self._lips = np.flatnonzero(gain > 0)
        self._rest, self._gain = rest[self._lips], gain[self._lips]

    def follow(self, parted: float) -> None:
        """Light lips that are apart by so many millimetres beyond their rest."""
        if not len(self._lips) or self._skin.colours is None:
            return
        light = float(smooth(np.array([parted]), SHUT, PARTED)[0])
        if (abs(light - self._light) < STEP and light not in (0.0, 1.0)) or light == self._light:
            return
        self._light = light
        self._skin.colours[self._lips, 3] = np.clip(self._rest + light * self._gain, 0, 255)
        self._skin.recoloured()
