"""The layer in hand as colours over the skin, with lines of equal value; a stroke changes only what it touches."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from app.tools.brush_state import BrushState
from app.tools.sight import Working
from app.view_state import ViewState
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.painting.layers import LAYER, PaintLayer
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.overlays.change import change_legend, change_paint
from ui.viewport.overlays.iso_lines import Crossings, Lines, crossings, drawn_on
from ui.viewport.overlays.layer_map import LayerMap, at_drawn, at_some, layer_map
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.skin import PAINT
from ui.widgets.legend_card import Legend, LegendCard
from ui.workspaces.workspace import Parts

CONTOUR = (0.05, 0.06, 0.07)
LINES_IN_RANGE = 10
"""Lines of equal value across the range of the map."""


class LayerDrawing:
    """Colours, lines of equal value and legend of the layer in hand, or of the change by the last solve."""

    def __init__(self, parts: Parts) -> None:
        self._parts = parts
        self._document, self._view = parts.context.document, parts.context.view
        self._scene, self._canvas = parts.viewport.scene, parts.viewport.canvas
        self._values: FloatArray = np.zeros(0)
        self._map: LayerMap | None = None
        self._contours = Lines(CONTOUR, 1.2, 0.7)
        self._crossings: Crossings | None = None
        self._legend = LegendCard(parts.viewport)
        self._on = self._stroke = False
        self._connect()

    def switch(self, on: bool) -> None:
        """Begin to draw, or give the skin back."""
        self._on = on
        renderer = self._scene.renderer
        renderer.AddViewProp(self._contours.actor) if on else renderer.RemoveViewProp(self._contours.actor)
        self._scene.coat = self._coat if on else None
        self._read()

    @property
    def _layer(self) -> PaintLayer | None:
        return LAYER.get(self._view.state.layer)

    @property
    def _face(self) -> Face:
        return self._document.project.face

    def _connect(self) -> None:
        document = self._document
        document.project_changed.connect(self._reread)
        document.layers_changed.connect(self._reread)
        document.solution_changed.connect(self._reread)
        document.expression_changed.connect(self._expressed)
        self._view.changed.connect(self._look)
        self._parts.bench.brush.changed.connect(self._brushed)
        self._parts.bench.sight.working_changed.connect(self._work)
        self._parts.toolbox.busy_changed.connect(self._gesture)
        self._canvas.before_frame.append(self._follow)

    def _gesture(self, busy: bool) -> None:
        self._stroke = self._stroke and busy

    def _reread(self, *_now: object) -> None:
        self._stroke = False
        self._read()

    def _look(self, now: ViewState, before: ViewState) -> None:
        members = ("layer", "layer_opacity", "contours", "change_map", "before")
        if any(getattr(now, name) != getattr(before, name) for name in members):
            self._read()

    def _brushed(self, now: BrushState, before: BrushState) -> None:
        if (now.layer, now.mode, now.value) != (before.layer, before.mode, before.value):
            self._read()

    def _expressed(self, _now: object) -> None:
        if self._on and self._view.state.change_map:
            self._read()

    def _read(self) -> None:
        """Take over what the document has, and draw it."""
        layer, brush = self._layer, self._parts.bench.brush.state
        if layer is not None and not self._stroke:
            self._values = layer.values(self._face)
            painting = brush.layer == layer.key and brush.mode == "set"
            self._map = layer_map(layer, self._values, brush.value if painting else 0.0)
        self._scene.repaint()
        self._find_contours()
        self._legend.show_legend(self._legend_now() if self._on else None)
        self._canvas.ask_frame()

    def _legend_now(self) -> Legend | None:
        if self._view.state.change_map:
            return change_legend(self._document)
        if self._layer is None or self._map is None:
            return None
        layer = self._layer
        if layer.kind == "choice":
            return Legend(layer.title, "", bands=self._map.bands)
        return Legend(
            layer.title, layer.unit, self._map.low, self._map.high, self._map.colours, beyond=self._map.beyond
        )

    def _coat(self, drawn: Drawn) -> Float32Array | None:
        """Colours (P, 4) of everything."""
        if self._view.state.change_map:
            return change_paint(self._document, drawn)
        fits = len(self._values) == len(drawn.project.face.skin.positions)
        if self._layer is None or self._map is None or not fits:
            return None
        display = drawn.figure.posed.basis.display
        return self._colours(at_drawn(self._layer, drawn.project.face, display, self._values), display.moving)

    def _colours(self, values: FloatArray, moving: int) -> Float32Array:
        assert self._map is not None
        cover = self._view.state.layer_opacity * self._map.covers(values)
        # What is not solved is held as it is, whatever is painted there.
        cover[moving:] = 0.0
        return np.column_stack([self._map.colours(values), cover]).astype(np.float32)

    def _work(self, working: Working) -> None:
        """Other values of a stroke under way: only the drawn points about their vertices are coloured anew."""
        layer, drawn = self._layer, self._scene.drawn
        if not self._on or layer is None or working.layer != layer.key or self._map is None or drawn is None:
            return
        self._stroke = True
        self._values[working.vertices] = working.values
        display = drawn.figure.posed.basis.display
        points = _points_about(drawn.project.face, display, working.vertices)
        points = points[points < display.moving]
        self._recolour(drawn, points, at_some(layer, drawn.project.face, display, self._values, points))
        self._canvas.ask_frame()

    def _recolour(self, drawn: Drawn, points: IntArray, values: FloatArray) -> None:
        data = drawn.figure.skin.surface.data
        painted = data.GetPointData().GetArray(PAINT)
        if painted is None or self._view.state.change_map:
            return
        vtk_to_numpy(painted)[points] = self._colours(values, len(points))
        painted.Modified()
        data.Modified()

    def _find_contours(self) -> None:
        self._crossings = None
        self._contours.hide()
        layer, drawn, state = self._layer, self._scene.drawn, self._view.state
        if not (self._on and state.contours and layer and self._map and drawn) or state.change_map:
            return
        if layer.kind != "amount" or len(self._values) != len(drawn.project.face.skin.positions):
            return
        display = drawn.figure.posed.basis.display
        # Between the round numbers: plateaus are painted at those, and a line would wander about on one.
        levels = self._map.low + (self._map.high - self._map.low) * (np.arange(LINES_IN_RANGE) + 0.5) / LINES_IN_RANGE
        values = at_drawn(layer, drawn.project.face, display, self._values)
        solved = display.triangles[(display.triangles < display.moving).all(axis=1)]
        self._crossings = crossings(values, solved, levels)

    def _follow(self) -> None:
        drawn = self._scene.drawn
        if self._on and self._crossings is not None and drawn is not None:
            self._contours.show(self._crossings.on(drawn.figure.posed.points, drawn.figure.posed.normals))


def _points_about(face: Face, display: DisplaySurface, vertices: IntArray) -> IntArray:
    """Drawn points (n,) on triangles of the skin that have one of some vertices as a corner."""
    touched = np.zeros(len(face.skin.positions), dtype=np.bool_)
    touched[vertices] = True
    elements = np.flatnonzero(touched[face.skin.triangles].any(axis=1))
    return np.unique(drawn_on(display, elements))
