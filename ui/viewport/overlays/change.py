"""Where the last solve has moved the expression that is shown, as colours with a legend in millimetres."""

from __future__ import annotations

from app.document import Document
from fem.types import Float32Array
from ui.viewport.overlays.amounts import amount_legend, amount_paint, top_of
from ui.viewport.overlays.overlay import Drawn
from ui.widgets.legend_card import Legend

LEAST = 0.01
"""Millimetres; a change below this is not seen on any face."""


def change_legend(document: Document) -> Legend | None:
    """The legend of the change; none while nothing has been solved twice."""
    moved = document.last_change_map()
    return None if moved is None else amount_legend("Moved by the last solve", "mm", top_of(moved, LEAST))


def change_paint(document: Document, drawn: Drawn) -> Float32Array | None:
    """Colours (P, 4) of how far every drawn point went; what stayed where it was stays bare."""
    moved = document.last_change_map()
    if moved is None or len(moved) != len(drawn.figure.posed.points):
        return None
    return amount_paint(moved, top_of(moved, LEAST))
