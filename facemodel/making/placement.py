"""Place points of muscles by words: a landmark of the left side and an offset, snapped to skin or bone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from facemodel.face import Skull
from facemodel.mesh import Mesh
from fem.types import FloatArray

SCALE_FROM = ("eye_outer_L", "eye_outer_R")
SCALE_WIDTH = 87.0
"""Millimetres between the outer canthi for which the offsets are written; other heads scale them."""


@dataclass(frozen=True)
class Spot:
    """A place said in words: offset (lateral, up, forward) in millimetres from a landmark of the left side."""

    landmark: str
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)


class Placement:
    """One head, on which spots become points.

    Parameters
    ----------
    skin : the skin at rest
    skull : the bone under it
    landmarks : skin vertices by name
    """

    def __init__(self, skin: Mesh, skull: Skull, landmarks: Mapping[str, int]) -> None:
        self._skin = skin
        self._skull = skull
        self._landmarks = landmarks
        left, right = (skin.positions[landmarks[name]] for name in SCALE_FROM)
        self.scale = float(np.linalg.norm(left - right)) / SCALE_WIDTH

    def point(self, spot: Spot, side: str) -> FloatArray:
        """The spot itself (3,), not snapped; ``side`` ``R`` mirrors the offset."""
        sign = -1.0 if side == "R" else 1.0
        name = spot.landmark if spot.landmark in self._landmarks else f"{spot.landmark}_{'R' if side == 'R' else 'L'}"
        offset = np.array(spot.offset) * [sign, 1.0, 1.0] * self.scale
        return np.asarray(self._skin.positions[self._landmarks[name]] + offset)

    def on_skin(self, spot: Spot, side: str) -> FloatArray:
        """The nearest skin vertex to a spot (3,)."""
        away = np.linalg.norm(self._skin.positions - self.point(spot, side), axis=1)
        return np.asarray(self._skin.positions[int(away.argmin())])

    def on_bone(self, spot: Spot, side: str) -> FloatArray:
        """The bone (3,) under the skin vertex that is nearest to a spot."""
        away = np.linalg.norm(self._skin.positions - self.point(spot, side), axis=1)
        return np.asarray(self._skull.anchors[int(away.argmin())])
