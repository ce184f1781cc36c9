"""Where the skin is held: a dot on every vertex of the solved face that a support holds."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from facemodel.display import DisplaySurface
from facemodel.face import Face
from fem import Support
from fem.types import IntArray
from ui.viewport.overlays.overlay import Drawn, Overlay

COLOURS = {Support.VALUE: (0.353, 0.694, 0.941), Support.CLAMPED: (0.910, 0.725, 0.286)}
"""Held in place; held in place and slope."""
SIZE = 6.0
"""Pixels."""


def held_vertices(face: Face) -> dict[Support, IntArray]:
    """Solved skin vertices by how they are held; those on the seam to the held rest of the head are clamped."""
    kinds = np.array(face.layers.supports)
    solved = np.zeros(len(kinds), dtype=bool)
    solved[face.skin.triangles[face.solved]] = True
    kinds[face.skin.triangles[~face.solved]] = Support.CLAMPED
    return {kind: np.flatnonzero(solved & (kinds == kind)) for kind in COLOURS}


def points_of_vertices(face: Face, display: DisplaySurface) -> IntArray:
    """The drawn point (N,) that lies on each skin vertex."""
    corner = display.barycentric.argmax(axis=1)
    on = np.flatnonzero(display.barycentric.max(axis=1) > 1 - 1e-6)
    found = np.full(len(face.skin.positions), -1, dtype=np.int64)
    found[face.skin.triangles[display.elements[on], corner[on]]] = on
    return found


class SupportsOverlay(Overlay):
    """Dots on held vertices."""

    def build(self, drawn: Drawn) -> None:
        """Make the dots; they share the skin's points."""
        face, figure = drawn.project.face, drawn.figure
        at = points_of_vertices(face, figure.posed.basis.display)
        for kind, vertices in held_vertices(face).items():
            self.add(_dots(drawn, at[vertices], COLOURS[kind]))


def _dots(drawn: Drawn, points: IntArray, colour: tuple[float, float, float]) -> vtkActor:
    data = vtkPolyData()
    data.SetPoints(drawn.figure.skin.surface.data.GetPoints())
    cells = vtkCellArray()
    cells.SetData(1, numpy_to_vtkIdTypeArray(np.ascontiguousarray(points), deep=True))
    data.SetVerts(cells)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-8.0)
    actor = vtkActor()
    actor.SetMapper(mapper)
    shown = actor.GetProperty()
    shown.SetColor(*colour)
    shown.SetLighting(False)
    shown.SetPointSize(SIZE)
    shown.RenderPointsAsSpheresOn()
    return actor
