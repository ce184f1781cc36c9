"""Points told in shares of a picture, whose sides nobody tells: what picture lets them be a face."""

from __future__ import annotations

import numpy as np

from facemodel.animation.landmarks.alignment import similarity
from facemodel.animation.landmarks.places import Places
from fem.types import FloatArray

SHARES = 2.0
"""Points are shares of a picture if none is farther from its corner: a face may leave it, and pixels are hundreds."""

PICTURES: dict[str, float] = {
    "16:9": 16 / 9, "3:2": 3 / 2, "4:3": 4 / 3, "1:1": 1.0, "3:4": 3 / 4, "2:3": 2 / 3, "9:16": 9 / 16
}  # fmt: skip
"""Width by height of what cameras take."""


def squared(points: FloatArray, places: Places) -> tuple[FloatArray, tuple[str, ...]]:
    """Points (N, P, 3) in one unit for all directions, and what was taken for granted.

    MediaPipe tells x and z in widths of the picture and y in heights.
    """
    if np.abs(points[:, places.indices, :2]).max() > SHARES:
        return points, ()
    typical = np.median(points[:, places.indices], axis=0)
    misfit = {name: _misfit(_stretched(typical[None], ratio), places) for name, ratio in PICTURES.items()}
    name = min(misfit, key=lambda each: misfit[each])
    note = f"Its points are told in shares of a picture, which was taken to be {name}."
    return _stretched(points, PICTURES[name]), (note,)


def _stretched(points: FloatArray, ratio: float) -> FloatArray:
    return np.asarray(points * np.array([ratio, 1.0, ratio]))


def _misfit(points: FloatArray, places: Places) -> float:
    """How far (K,) points (1, K, 3) stay from the face across the picture, millimetres squared."""
    laid = similarity(points, places.rest[None], places.weights).of(points)[0]
    return float(((laid - places.rest) ** 2).sum())
