"""How far the lids are open, and eyes that are shut for good."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from fem.types import FloatArray

MIDDLES = {"L": (386, 374), "R": (159, 145)}
"""The middle of the upper and of the lower lid in the mesh, by the side of the eye."""

CLOSING = "43"
"""The action unit that shuts an eye, without its side."""

SHUT, OPEN = 0.25, 0.5
"""Shares of their opening at rest: trackers leave a fifth of it to lids that are shut; half open ones only squint."""


def openness(points: FloatArray, side: str, rest: slice) -> FloatArray:
    """How far an eye is open (N,), 1 as at rest, in frames (N, P, 3) of the mesh without head motion."""
    upper, lower = MIDDLES[side]
    gap = np.linalg.norm(points[:, upper] - points[:, lower], axis=1)
    return np.asarray(gap / max(float(gap[rest].mean()), np.finfo(np.float64).tiny))


def with_shut_eyes(names: Sequence[str], weights: FloatArray, points: FloatArray, rest: slice) -> FloatArray:
    """Weights (N, M) by which lids that look shut are shut, however little of their way was seen of them."""
    found = weights.copy()
    for side in MIDDLES:
        if CLOSING + side in names:
            column = names.index(CLOSING + side)
            shut = np.clip((OPEN - openness(points, side, rest)) / (OPEN - SHUT), 0.0, 1.0)
            found[:, column] = np.maximum(found[:, column], shut)
    return found
