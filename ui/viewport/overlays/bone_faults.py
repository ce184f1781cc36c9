"""Where skull and skin do not agree: dots where bone comes through the skin, and where springs are left out."""

from __future__ import annotations

from facemodel.sampling import points_of_vertices
from fem.types import IntArray
from ui.viewport.overlays.marks import Colour, Marks
from ui.workspaces.workspace import Parts

GROUND: Colour = (0.13, 0.06, 0.06)
PIERCED: Colour = (0.95, 0.33, 0.30)
LEFT_OUT: Colour = (0.96, 0.76, 0.29)
RIM, DOT = 7.5, 5.0
"""Pixels."""


class BoneFaults:
    """Draws the dots as long as there is anything wrong."""

    def __init__(self, parts: Parts) -> None:
        self._viewport, self._watch = parts.viewport, parts.bench.watch
        self._marks = {
            "rim": Marks(GROUND, RIM),
            "left out": Marks(LEFT_OUT, DOT),
            "pierced": Marks(PIERCED, DOT),
        }
        self._on = False
        self._watch.changed.connect(self._ask)
        self._viewport.canvas.before_frame.append(self._draw)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take the dots off."""
        renderer = self._viewport.scene.renderer
        for marks in self._marks.values():
            renderer.AddViewProp(marks.actor) if on else renderer.RemoveViewProp(marks.actor)
        self._on = on
        self._ask()

    def _ask(self) -> None:
        if self._on:
            self._viewport.canvas.ask_frame()

    def _draw(self) -> None:
        """The dots follow the skin, in every frame; there are few of them."""
        drawn, found = self._viewport.scene.drawn, self._watch.found
        if not self._on or drawn is None:
            return
        if found is None or found.sound or found.face.skin is not drawn.project.face.skin:
            for marks in self._marks.values():
                marks.hide()
            return
        posed = drawn.figure.posed
        at = points_of_vertices(drawn.project.face, posed.basis.display)
        lone: IntArray = found.faults.at
        for name, vertices in (("left out", lone), ("pierced", found.pierced)):
            self._marks[name].show(posed.points[at[vertices]])
        self._marks["rim"].show(posed.points[at[[*lone, *found.pierced]]])
