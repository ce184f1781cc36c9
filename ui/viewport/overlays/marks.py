"""Dots and lines that are seen through everything, for what a hand can take hold of."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from fem.types import Float32Array, FloatArray
from ui.viewport.surface import cells

Colour = tuple[float, float, float]

IN_FRONT = -66_000.0
"""Units of depth by which a mark is drawn nearer than it is, so that no skin lies before it."""

NEARER = 2_000.0
"""Units by which one kind of mark lies before another."""


class Marks:
    """Points, or segments between them two and two, in one colour that takes no light.

    Attributes
    ----------
    actor : the VTK side

    Parameters
    ----------
    colour, size : of the dots, or of the lines; pixels
    lines : whether segments are drawn, not dots
    rank : what has a larger one lies before what has a smaller one
    """

    def __init__(self, colour: Colour, size: float, *, lines: bool = False, rank: int = 0) -> None:
        self._lines = lines
        self._data = vtkPolyData()
        self._data.SetPoints(vtkPoints())
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._data)
        mapper.ScalarVisibilityOff()
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        depth = IN_FRONT - NEARER * rank
        mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0.0, depth)
        mapper.SetRelativeCoincidentTopologyPointOffsetParameter(depth)
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.PickableOff()
        shown = self.actor.GetProperty()
        shown.SetColor(*colour)
        shown.SetLighting(False)
        shown.SetLineWidth(size)
        shown.SetPointSize(size)
        shown.SetRenderPointsAsSpheres(not lines)
        self.actor.VisibilityOff()

    def show(self, places: FloatArray | Float32Array) -> None:
        """Draw at some places (n, 3), or segments by their ends (2 n, 3); nothing without any."""
        self.actor.SetVisibility(len(places) > 0)
        if not len(places):
            return
        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(places, dtype=np.float32), deep=True, array_type=VTK_FLOAT))
        if self._data.GetNumberOfPoints() != len(places):
            ends = np.arange(len(places))
            if self._lines:
                self._data.SetLines(cells(ends.reshape(-1, 2)))
            else:
                self._data.SetVerts(cells(ends.reshape(-1, 1)))
        self._data.SetPoints(points)
        self._data.Modified()

    def hide(self) -> None:
        """Draw nothing."""
        self.actor.VisibilityOff()


def chain(points: FloatArray, closed: bool = False) -> FloatArray:
    """Ends (2 m, 3) of the segments between points (n, 3) in a row."""
    row = np.concatenate([points, points[:1]]) if closed else points
    return np.repeat(row, 2, axis=0)[1:-1]
