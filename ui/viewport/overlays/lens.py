"""The cross-section of a drawn muscle: a lens, flat where the muscle is a sheet, round where it is a cord."""

from __future__ import annotations

import numpy as np

from fem.types import FloatArray

ROWS = 9
"""Points on the outer side of a lens, its edges included."""

INNER = 0.6
"""Thickness towards the bone over that towards the skin."""

ACROSS = np.sin(np.linspace(-np.pi / 2, np.pi / 2, ROWS))
"""(ROWS,) places of the points across a lens, -1 to 1; dense at its edges, where it is round."""


def lens(middles: FloatArray, thickness: FloatArray, outward: FloatArray) -> FloatArray:
    """Points (2 ROWS - 2, columns, 3) round the cross-sections of a muscle.

    Parameters
    ----------
    middles : (ROWS, columns, 3) the middle layer, across from edge to edge
    thickness : (columns,) millimetres of the outer half in the middle
    outward : (columns, 3) unit vectors towards the skin
    """
    swell = np.sqrt(np.maximum(1 - ACROSS**2, 0.0))[:, None] * thickness
    outer = middles + swell[..., None] * outward
    inner = middles - INNER * swell[..., None] * outward
    return np.concatenate([outer, inner[-2:0:-1]])


def grain_of(body: FloatArray, middles: FloatArray) -> FloatArray:
    """Millimetres (rows, columns, 2) along and across the fibres of a body made by `lens`."""
    steps = np.linalg.norm(np.diff(middles, axis=1), axis=2).mean(axis=0)
    along = np.append(0.0, np.cumsum(steps))
    gaps = np.linalg.norm(np.diff(middles, axis=0), axis=2).mean(axis=1)
    across = np.append(0.0, np.cumsum(gaps))
    around = np.concatenate([across, 2 * across[-1] - across[-2:0:-1]])
    return np.stack(np.broadcast_arrays(along[None], around[:, None]), axis=-1).reshape(*body.shape[:2], 2)
