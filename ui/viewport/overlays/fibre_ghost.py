"""A muscle in the hand: where it would act and how it would pull, while it is dragged, among the muscles there are."""

from __future__ import annotations

import numpy as np
from PySide6.QtGui import QCursor

from app.tools.sight import Ghost
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from facemodel.smooth import smooth
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.colour_map import cividis
from ui.viewport.look import at_points
from ui.viewport.muscle_fields import muscle_named, muscle_pull
from ui.viewport.overlays.forces import COLOUR, LIFT, ArrowField
from ui.viewport.overlays.influence import COVER, FADE, KPA
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.supports import points_of_vertices
from ui.widgets.legend_card import Legend, LegendCard
from ui.workspaces.workspace import Parts

STRONGEST = 120
"""Arrows drawn of a muscle in the hand at most."""

APART = 0.014
"""Height of the picture in which there is one arrow, the strongest: more of them hide what they stand on."""


class FibreGhost:
    """Lays the influence of the muscle in the hand on the skin, with arrows along its forces, and says what is wrong.

    The legend is that of the muscle in the hand, else of the one that is selected.
    """

    def __init__(self, parts: Parts) -> None:
        self._viewport, self._view, self._document = parts.viewport, parts.context.view, parts.context.document
        self._ghost: Ghost | None = None
        self._arrows = ArrowField(COLOUR, STRONGEST)
        self._legend = LegendCard(parts.viewport)
        self._on = self._due = False
        parts.bench.sight.ghost_changed.connect(self._take)
        parts.viewport.canvas.before_frame.append(self._before_frame)
        self._view.changed.connect(lambda *_: self._show_legend())
        for signal in (self._document.muscles_changed, self._document.project_changed):
            signal.connect(lambda _what: self._show_legend())

    def switch(self, on: bool) -> None:
        """Begin to draw, or take all off."""
        scene = self._viewport.scene
        renderer, actor = scene.renderer, self._arrows.actor
        renderer.AddViewProp(actor) if on else renderer.RemoveViewProp(actor)
        scene.coat = self._coat if on else None
        self._on = on
        self._take(None)
        self._show_legend()

    def _take(self, ghost: Ghost | None) -> None:
        if ghost is self._ghost and ghost is not None:
            return
        said = self._ghost.complaint if self._ghost is not None else ""
        self._ghost, self._due = ghost, True
        self._viewport.canvas.ask_frame()
        if not self._on:
            return
        complaint = ghost.complaint if ghost is not None else ""
        if complaint or said:
            self._viewport.pointer.say(complaint, self._viewport.mapFromGlobal(QCursor.pos()))
        self._show_legend()

    def _show_legend(self) -> None:
        """What the colours on the skin mean, while there are some."""
        legend = None
        if self._on and self._ghost is not None and self._ghost.most:
            legend = _legend(self._ghost.muscles[0], self._ghost.most)
        elif self._on and self._ghost is None and self._view.state.influence:
            project = self._document.project
            muscle = muscle_named(project, self._view.state.muscle)
            most = float(muscle_pull(muscle, project.face).max()) if muscle is not None else 0.0
            legend = _legend(muscle, most) if muscle is not None and most else None
        self._legend.show_legend(legend)

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
        kept = _apart(places, field.vectors, 2 * APART * drawn.half_height)
        self._arrows.show(places[kept], field.vectors[kept], 2 * drawn.half_height)


def _apart(places: FloatArray, vectors: FloatArray, gap: float) -> IntArray:
    """The strongest vector in every cube of some width, (k,) of the places (n, 3)."""
    order = np.argsort(-np.linalg.norm(vectors, axis=1), kind="stable")
    cells = np.floor(places[order] / gap).astype(np.int64)
    _, first = np.unique(cells, axis=0, return_index=True)
    return np.asarray(order[first])


def _legend(muscle: Muscle, most: float) -> Legend:
    """How hard a muscle pulls, or how far it moves the skin, at full contraction."""
    moves = MODELS[muscle.model].action == "displacement"
    top = most if moves else KPA * most

    def colours(values: FloatArray) -> FloatArray:
        return np.asarray(cividis(values / top))

    return Legend("Moves the skin" if moves else "Pulls the skin", "mm" if moves else "kPa", 0.0, top, colours)
