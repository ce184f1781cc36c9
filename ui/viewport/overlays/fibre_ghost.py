"""A muscle in the hand: where it would act and how it would pull, while it is dragged, among the muscles there are."""

from __future__ import annotations

import numpy as np

from app.tools.sight import Ghost
from app.view_state import ViewState
from fem.types import Float32Array
from ui.viewport.colour_map import cividis
from ui.viewport.complexion import smooth
from ui.viewport.look import at_points
from ui.viewport.overlays.forces import COLOUR, LIFT, ArrowField
from ui.viewport.overlays.influence import COVER, FADE
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.supports import points_of_vertices
from ui.workspaces.workspace import Parts

STRONGEST = 160
"""Arrows drawn of a muscle in the hand; more of them hide what they stand on."""


class FibreGhost:
    """Lays the influence of the muscle in the hand on the skin, with arrows along its forces."""

    def __init__(self, parts: Parts) -> None:
        self._viewport = parts.viewport
        self._ghost: Ghost | None = None
        self._arrows = ArrowField(COLOUR, STRONGEST)
        self._on = self._due = False
        parts.bench.sight.ghost_changed.connect(self._take)
        parts.viewport.canvas.before_frame.append(self._before_frame)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take all off."""
        scene = self._viewport.scene
        renderer, actor = scene.renderer, self._arrows.actor
        renderer.AddViewProp(actor) if on else renderer.RemoveViewProp(actor)
        scene.coat = self._coat if on else None
        self._on = on
        self._take(None)

    def _take(self, ghost: Ghost | None) -> None:
        if ghost is not self._ghost or ghost is None:
            self._ghost, self._due = ghost, True
            self._viewport.canvas.ask_frame()

    def _before_frame(self) -> None:
        drawn = self._viewport.scene.drawn
        if self._due and drawn is not None:
            self._due = False
            self._viewport.scene.repaint()
            self._draw_arrows(drawn)

    def _coat(self, drawn: Drawn) -> Float32Array | None:
        """Colours (P, 4) of the influence of the muscle in the hand."""
        if self._ghost is None or self._ghost.influence is None:
            return None
        share = at_points(drawn.project.face, drawn.figure.posed.basis.display, self._ghost.influence)
        return np.column_stack([cividis(share), COVER * smooth(share, 0.0, FADE)]).astype(np.float32)

    def _draw_arrows(self, drawn: Drawn) -> None:
        field = self._ghost.arrows if self._ghost is not None else None
        if not self._on or field is None or not len(field.vertices):
            self._arrows.hide()
            return
        posed = drawn.figure.posed
        at = points_of_vertices(drawn.project.face, posed.basis.display)[field.vertices]
        places = posed.points[at] + LIFT * posed.normals[at]
        self._arrows.show(places, field.vectors, 2 * drawn.half_height)


class MusclesInSight:
    """Keeps the muscles drawn and the selected one's influence shown while their workspace is open."""

    def __init__(self, parts: Parts) -> None:
        self._view = parts.context.view
        self._before: ViewState | None = None

    def switch(self, on: bool) -> None:
        """Show the muscles, or what was shown before; what a person switched in between stays so."""
        state = self._view.state
        if on:
            self._before = state
            self._view.change(muscles=True, influence=True, **_kept_selection(state))
        elif self._before is not None:
            before, self._before = self._before, None
            self._view.change(muscles=before.muscles, influence=before.influence, **_kept_selection(state))


def _kept_selection(state: ViewState) -> dict[str, object]:
    return {"muscle": state.muscle, "others": state.others}
