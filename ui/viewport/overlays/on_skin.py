"""Where places of the face at rest are on the posed one."""

from __future__ import annotations

import numpy as np

from fem.types import FloatArray
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.supports import points_of_vertices


class OnSkin:
    """Moves places along with the skin that is nearest to them.

    Parameters
    ----------
    drawn : the face as it is posed
    """

    def __init__(self, drawn: Drawn) -> None:
        self._face = drawn.project.face
        display, posed = drawn.figure.posed.basis.display, drawn.figure.posed.points
        self._moved = any(drawn.expression.values())
        self._shift = (posed - display.points).astype(np.float64) if self._moved else np.zeros((0, 3))
        self._points = points_of_vertices(self._face, display) if self._moved else np.zeros(0, np.int64)

    def shift(self, places: FloatArray) -> FloatArray:
        """How far (..., 3) the skin nearest to places (..., 3) has gone."""
        if not self._moved:
            return np.zeros_like(places)
        vertices = self._face.skin.tree.query(places)[1]
        return np.asarray(self._shift[self._points[vertices]])

    def carried(self, places: FloatArray) -> FloatArray:
        """Places (..., 3) of the resting skin on the posed one."""
        return np.asarray(places + self.shift(places))
