"""Which colours are laid on the skin: one thing at a time, what is under the pointer first."""

from __future__ import annotations

from collections.abc import Callable

from app.view_state import ViewState
from fem.types import Float32Array
from ui.viewport.overlays.glow import glow_paint
from ui.viewport.overlays.influence import influence_paint
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.supports import held_paint

Coat = Callable[[Drawn], Float32Array | None]
"""Makes colours (P, 4) of what is drawn, or None."""


def paint_of(drawn: Drawn, state: ViewState, coat: Coat | None) -> Float32Array | None:
    """The colours (P, 4) that are laid on the skin now; none for the bare skin."""
    colours = glow_paint(drawn) if drawn.glowing else None
    if colours is None and coat is not None:
        colours = coat(drawn)
    if colours is None and state.influence:
        colours = influence_paint(drawn)
    if colours is None and state.supports:
        colours = held_paint(drawn)
    return colours


def painted(state: ViewState) -> tuple[bool, bool, str]:
    """The members of a view state that decide what is laid on the skin."""
    return state.influence, state.supports, state.muscle
