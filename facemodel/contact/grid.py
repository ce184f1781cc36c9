"""Values between the places of an even grid, and how far beside it a place is."""

from __future__ import annotations

from facemodel.compiled import compiled
from fem.types import FloatArray


@compiled
def between(values: FloatArray, u: float, v: float) -> float:
    """The value so many steps from the first place of a grid (A, D); beside it that of its edge."""
    u, v = min(max(u, 0.0), values.shape[0] - 1.0), min(max(v, 0.0), values.shape[1] - 1.0)
    i, k = min(int(u), values.shape[0] - 2), min(int(v), values.shape[1] - 2)
    s, t = u - i, v - k
    low = values[i, k] * (1 - s) + values[i + 1, k] * s
    high = values[i, k + 1] * (1 - s) + values[i + 1, k + 1] * s
    return float(low * (1 - t) + high * t)


@compiled
def beside(at: float, count: int) -> float:
    """How many steps before the first or behind the last of so many places one is."""
    return max(-at, at - (count - 1.0), 0.0)
