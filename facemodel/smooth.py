"""How what fades does so: smoothly, with level ends."""

from __future__ import annotations

import numpy as np

from facemodel.compiled import compiled
from fem.types import FloatArray


def smooth_step(x: FloatArray) -> FloatArray:
    """0 below 0, 1 above 1, and between them the cubic that has level ends."""
    t = np.clip(x, 0.0, 1.0)
    return np.asarray(t * t * (3 - 2 * t))


def smooth(x: FloatArray, low: float, high: float) -> FloatArray:
    """0 below ``low``, 1 above ``high`` (or the other way round if ``low`` is larger), with level ends."""
    return smooth_step((x - low) / (high - low))


@compiled
def smooth_share(x: float) -> float:
    """The same of one number, for loops over points."""
    t = min(max(x, 0.0), 1.0)
    return t * t * (3 - 2 * t)
