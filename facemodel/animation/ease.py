"""The way a face sets out and arrives: the course of least jerk."""

from __future__ import annotations

import numpy as np

from fem.types import FloatArray


def least_jerk(share: FloatArray) -> FloatArray:
    """10 x^3 - 15 x^4 + 6 x^5 for x from 0 to 1, level before and behind: how limbs move (Flash & Hogan 1985)."""
    x = np.clip(share, 0.0, 1.0)
    return np.asarray(x**3 * (10.0 + x * (6.0 * x - 15.0)))
