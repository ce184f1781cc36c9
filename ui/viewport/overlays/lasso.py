"""The lasso while it is drawn, and the outlines of what is selected and locked."""

from __future__ import annotations

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - without it VTK makes actors that cannot be drawn
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkPolyDataMapper2D

from fem.types import BoolArray, FloatArray
from ui.viewport.look import at_points
from ui.viewport.overlays.iso_lines import Crossings, Lines, crossings
from ui.viewport.surface import cells
from ui.workspaces.workspace import Parts

ACCENT = (0.949, 0.518, 0.361)
LOCKED = (0.910, 0.725, 0.286)
BORDER = np.array([0.5])


class LassoOutline:
    """A line on the screen along the outline so far."""

    def __init__(self, parts: Parts) -> None:
        self._viewport = parts.viewport
        self._data = vtkPolyData()
        mapper = vtkPolyDataMapper2D()
        mapper.SetInputData(self._data)
        self._actor = vtkActor2D()
        self._actor.SetMapper(mapper)
        self._actor.GetProperty().SetColor(*ACCENT)
        self._actor.GetProperty().SetLineWidth(1.8)
        self._actor.VisibilityOff()
        parts.bench.sight.outline_changed.connect(self._take)

    def switch(self, on: bool) -> None:
        """Begin to draw, or stop."""
        renderer = self._viewport.scene.renderer
        renderer.AddViewProp(self._actor) if on else renderer.RemoveViewProp(self._actor)
        self._actor.VisibilityOff()

    def _take(self, corners: FloatArray | None) -> None:
        shown = corners is not None and len(corners) > 1
        self._actor.SetVisibility(shown)
        if corners is not None and shown:
            scale = self._viewport.canvas.devicePixelRatioF()
            height = self._viewport.scene.renderer.GetSize()[1]
            x, y = corners.T * scale
            flat = np.column_stack([x, height - 1 - y, np.zeros(len(x))]).astype(np.float32)
            points = vtkPoints()
            points.SetData(numpy_to_vtk(flat, deep=True, array_type=VTK_FLOAT))
            self._data.SetPoints(points)
            around = np.arange(len(flat))
            self._data.SetLines(cells(np.column_stack([around, np.roll(around, -1)])))
            self._data.Modified()
        self._viewport.canvas.ask_frame()


class RegionOutlines:
    """Lines around what is selected, in the accent, and around what is locked, in amber."""

    def __init__(self, parts: Parts) -> None:
        self._parts = parts
        self._lines = {"selected": Lines(ACCENT, 2.2), "locked": Lines(LOCKED, 2.2)}
        self._crossings: dict[str, Crossings] = {}
        self._on = False
        parts.bench.regions.changed.connect(self._find)
        parts.context.document.project_changed.connect(self._find)
        parts.viewport.canvas.before_frame.append(self._follow)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take the outlines off."""
        renderer = self._parts.viewport.scene.renderer
        for lines in self._lines.values():
            renderer.AddViewProp(lines.actor) if on else renderer.RemoveViewProp(lines.actor)
        self._on = on
        self._find()

    def _find(self, _now: object = None) -> None:
        drawn = self._parts.viewport.scene.drawn
        self._crossings = {}
        for lines in self._lines.values():
            lines.hide()
        if not self._on or drawn is None:
            return
        regions, face = self._parts.bench.regions, self._parts.context.document.project.face
        display = drawn.figure.posed.basis.display
        parts: dict[str, BoolArray | None] = {"selected": regions.selected(face), "locked": regions.locked(face)}
        for name, region in parts.items():
            if region is not None and len(region) == len(drawn.project.face.skin.positions):
                inside = at_points(drawn.project.face, display, region.astype(np.float64))
                self._crossings[name] = crossings(inside, display.triangles, BORDER)
        self._parts.viewport.canvas.ask_frame()

    def _follow(self) -> None:
        drawn = self._parts.viewport.scene.drawn
        if self._on and drawn is not None:
            for name, found in self._crossings.items():
                self._lines[name].show(found.on(drawn.figure.posed.points, drawn.figure.posed.normals))
