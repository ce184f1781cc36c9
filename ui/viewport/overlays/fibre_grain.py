"""The grain of muscle: a picture of fine fibres that goes on for ever, and how a surface wears it."""

from __future__ import annotations

from functools import cache

import numpy as np
from scipy.ndimage import gaussian_filter
from vtkmodules.vtkRenderingCore import vtkTexture

from fem.types import FloatArray
from ui.viewport.surface import ByteArray, Surface

SIDE = 256
"""Pixels of the picture."""

LONG, WIDE = 30.0, 9.0
"""Millimetres of muscle, along and across its fibres, after which the picture begins again."""

STREAKS = ((1.0, 40.0, 1.0), (2.6, 60.0, 0.8), (7.0, 30.0, 0.5))
"""Pixels across and along, and weight, of bundles of fibres: fine, coarse, and the unevenness of the whole."""

GLSL = """
  float fibre = texture(actortexture, tcoordVCVSOutput).r;
  albedo *= 0.50 + 1.0 * fibre;
  gloss = 0.5 + fibre;"""
"""Fibres in the colour of a muscle and in its shine."""


@cache
def grain() -> ByteArray:
    """The picture (SIDE, SIDE, 3), brightness about one half; rows go across the fibres."""
    rng = np.random.default_rng(4)
    total = np.zeros((SIDE, SIDE))
    for across, along, weight in STREAKS:
        streak = gaussian_filter(rng.normal(size=(SIDE, SIDE)), (across, along), mode="wrap")
        total += weight * streak / streak.std()
    shade = 0.5 + 0.20 * total / total.std()
    return np.ascontiguousarray(np.repeat(np.clip(255 * shade, 0, 255)[..., None], 3, axis=2), dtype=np.uint8)


def wear_grain(surface: Surface, millimetres: FloatArray) -> None:
    """Lay the grain on a surface, by millimetres (n, 2) along and across the fibres of each point."""
    surface.wear(grain(), millimetres / [LONG, WIDE])
    surface.actor.GetTexture().SetWrap(vtkTexture.Repeat)
