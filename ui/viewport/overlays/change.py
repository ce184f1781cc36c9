"""Where the last solve has moved the expression that is shown, as colours with a legend in millimetres."""

from __future__ import annotations

import numpy as np

from app.document import Document
from fem.types import Float32Array, FloatArray
from ui.viewport.colour_map import cividis
from ui.viewport.complexion import smooth
from ui.viewport.overlays.layer_map import readable
from ui.viewport.overlays.overlay import Drawn
from ui.widgets.legend_card import Legend

COVER = 0.85
LEAST = 0.01
"""Millimetres; a change below this is not seen on any face."""


def change_legend(document: Document) -> Legend | None:
    """The legend of the change; none while nothing has been solved twice."""
    moved = document.last_change_map()
    if moved is None:
        return None
    return Legend("Moved by the last solve", "mm", 0.0, _top(moved), lambda values: cividis(values / _top(moved)))


def change_paint(document: Document, drawn: Drawn) -> Float32Array | None:
    """Colours (P, 4) of how far every drawn point went; what stayed where it was stays bare."""
    moved = document.last_change_map()
    if moved is None or len(moved) != len(drawn.figure.posed.points):
        return None
    share = moved.astype(np.float64) / _top(moved)
    cover = COVER * smooth(share, 0.02, 0.12)
    return np.column_stack([cividis(share), cover]).astype(np.float32)


def _top(moved: Float32Array | FloatArray) -> float:
    return readable(max(float(moved.max(initial=0.0)), LEAST))
