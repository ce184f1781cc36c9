"""How deep the bone lies, as colours over the skin with a legend in millimetres, and a landmark that is asked about."""

from __future__ import annotations

import numpy as np

from app.view_state import ViewState
from facemodel.laying.places import nearest
from facemodel.sampling import points_of_vertices
from facemodel.skull.findings import Findings
from facemodel.skull.tissue_depths import LandmarkDepth
from facemodel.smooth import smooth
from fem.types import Float32Array, FloatArray
from ui.viewport.colour_map import cividis
from ui.viewport.look import at_points
from ui.viewport.overlays.marks import Colour, Marks
from ui.viewport.overlays.overlay import Drawn
from ui.widgets.legend_card import Legend, LegendCard
from ui.workspaces.workspace import Parts

DEEPEST = 25.0
"""Millimetres at the end of the map: no table knows deeper tissue over bone, but for the cheek beside the molars."""

GONE, FAR = 32.0, 48.0
"""Millimetres over which the colours fade: the neck and the floor of the mouth lie over no bone."""

COVER = 0.85

OUT: Colour = (0.86, 0.20, 0.18)
"""Bone that has come through."""

DOT: Colour = (1.0, 1.0, 1.0)
ACCENT: Colour = (0.949, 0.518, 0.361)
GROUND: Colour = (0.10, 0.11, 0.12)


def depth_colours(depth: FloatArray) -> FloatArray:
    """Colours (n, 3) of depths (n,)."""
    return np.where((depth < 0)[:, None], OUT, cividis(depth / DEEPEST))


def depth_legend(out: bool) -> Legend:
    """What the colours mean; the one of bone that is outside is named where there is some."""
    title = "Depth of the bone (red: outside)" if out else "Depth of the bone"
    return Legend(title, "mm", 0.0, DEEPEST, depth_colours, beyond=True)


class DepthMap:
    """Colours the skin while the map is asked for, and marks the landmark that is pointed at."""

    def __init__(self, parts: Parts) -> None:
        self._parts = parts
        self._view, self._watch = parts.context.view, parts.bench.watch
        self._scene, self._canvas = parts.viewport.scene, parts.viewport.canvas
        self._legend = LegendCard(parts.viewport)
        self._marks = {
            "ground": Marks(GROUND, 4.5, lines=True),
            "way": Marks(DOT, 2.0, lines=True),
            "rim": Marks(GROUND, 13.0),
            "bone": Marks(DOT, 9.0),
            "skin": Marks(ACCENT, 9.0),
        }
        self._pointed = ""
        self._on = False
        self._watch.changed.connect(self._redraw)
        self._view.changed.connect(self._look)
        parts.bench.sight.landmark_changed.connect(self._point)
        self._canvas.before_frame.append(self._mark)

    def switch(self, on: bool) -> None:
        """Begin to draw, or give the skin back."""
        self._on, self._pointed = on, ""
        for marks in self._marks.values():
            renderer = self._scene.renderer
            renderer.AddViewProp(marks.actor) if on else renderer.RemoveViewProp(marks.actor)
        self._scene.coat = self._coat if on else None
        self._redraw()

    def _look(self, now: ViewState, before: ViewState) -> None:
        if now.depth_map != before.depth_map:
            self._redraw()

    def _point(self, name: str) -> None:
        self._pointed = name
        if self._on:
            self._canvas.ask_frame()

    def _redraw(self) -> None:
        found = self._watch.found if self._on and self._view.state.depth_map else None
        self._legend.show_legend(None if found is None else depth_legend(found.depths.count > 0))
        self._scene.repaint()
        self._canvas.ask_frame()

    def _found(self, drawn: Drawn) -> Findings | None:
        """The findings, if they are about the skin that is drawn."""
        found = self._watch.found
        return found if found is not None and found.face.skin is drawn.project.face.skin else None

    def _coat(self, drawn: Drawn) -> Float32Array | None:
        """Colours (P, 4) of all drawn points."""
        found = self._found(drawn)
        if found is None or not self._view.state.depth_map:
            return None
        face = drawn.project.face
        depth = at_points(face, drawn.figure.posed.basis.display, found.depths.depth)
        cover = COVER * smooth(depth, FAR, GONE)
        return np.column_stack([depth_colours(depth), cover]).astype(np.float32)

    def _mark(self) -> None:
        for marks in self._marks.values():
            marks.hide()
        drawn = self._scene.drawn
        if not self._on or drawn is None or not self._pointed or (found := self._found(drawn)) is None:
            return
        for each in found.landmarks:
            if each.name == self._pointed:
                self._mark_landmark(drawn, each)

    def _mark_landmark(self, drawn: Drawn, landmark: LandmarkDepth) -> None:
        """A dot on the skin, one on the nearest bone, and the way between them."""
        face, posed = drawn.project.face, drawn.figure.posed
        at = points_of_vertices(face, posed.basis.display)[landmark.vertex]
        skin, rest = posed.points[at].astype(np.float64), face.skin.positions[landmark.vertex]
        found = [nearest(mesh, rest) for mesh in (face.skull.cranium, face.skull.mandible) if len(mesh.triangles)]
        bone = min(found, key=lambda each: float(each[2][0]))[0][0]
        ends = np.array([skin, bone])
        for name, places in {"ground": ends, "way": ends, "rim": ends, "bone": ends[1:], "skin": ends[:1]}.items():
            self._marks[name].show(places)
