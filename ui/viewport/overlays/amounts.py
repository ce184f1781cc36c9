"""An amount on the skin, from nothing to its largest, as colours with a legend; where there is none skin stays bare."""

from __future__ import annotations

import numpy as np

from facemodel.smooth import smooth
from fem.types import Float32Array, FloatArray
from ui.viewport.colour_map import cividis
from ui.viewport.overlays.layer_map import readable
from ui.widgets.legend_card import Legend

COVER = 0.85
BARE, COVERED = 0.02, 0.12
"""Shares of the range between which the colours fade into the skin."""


def top_of(values: Float32Array | FloatArray, least: float) -> float:
    """An easily read end of the range of some values, at least so large."""
    return readable(max(float(values.max(initial=0.0)), least))


def amount_legend(title: str, unit: str, top: float) -> Legend:
    """The legend of amounts from zero to ``top``."""
    return Legend(title, unit, 0.0, top, lambda values: cividis(values / top))


def amount_paint(values: Float32Array | FloatArray, top: float) -> Float32Array:
    """Colours (P, 4) of amounts (P,)."""
    share = values.astype(np.float64) / top
    cover = COVER * smooth(share, BARE, COVERED)
    return np.column_stack([cividis(share), cover]).astype(np.float32)
