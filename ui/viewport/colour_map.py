"""The map for scalar fields: cividis, even to the eye and safe for colour-blind ones."""

from __future__ import annotations

import numpy as np

from fem.types import FloatArray

CIVIDIS = np.array(
    [
        (0.000, 0.135, 0.305), (0.000, 0.179, 0.415), (0.103, 0.220, 0.436), (0.195, 0.264, 0.426),
        (0.264, 0.308, 0.423), (0.324, 0.351, 0.426), (0.381, 0.395, 0.436), (0.435, 0.440, 0.451),
        (0.489, 0.485, 0.471), (0.548, 0.532, 0.472), (0.609, 0.580, 0.464), (0.672, 0.629, 0.448),
        (0.736, 0.681, 0.424), (0.803, 0.734, 0.390), (0.871, 0.790, 0.343), (0.941, 0.848, 0.276),
        (0.996, 0.909, 0.218),
    ]
)  # fmt: skip
"""Every sixteenth colour (Nuñez, Anderton and Renslow 2018), sRGB; linear in between."""


def cividis(share: FloatArray) -> FloatArray:
    """Colours (..., 3) for values 0..1."""
    at = np.clip(share, 0.0, 1.0) * (len(CIVIDIS) - 1)
    return np.stack([np.interp(at, np.arange(len(CIVIDIS)), CIVIDIS[:, k]) for k in range(3)], axis=-1)
