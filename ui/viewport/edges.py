"""Places on edges of a mesh, which move with the two points that each lies between."""

from __future__ import annotations

import numpy as np

from facemodel.compiled import compiled
from fem.types import Float32Array, FloatArray, IntArray


@compiled
def between(values: Float32Array | FloatArray, start: IntArray, stop: IntArray, share: FloatArray) -> FloatArray:
    """Values (P, k) of points on the way (n, k) from one point to another, at a share of it."""
    found = np.empty((len(start), values.shape[1]))
    for i in range(len(start)):
        for k in range(values.shape[1]):
            found[i, k] = values[start[i], k] * (1 - share[i]) + values[stop[i], k] * share[i]
    return found
