"""Lines on the drawn skin where a value is reached; they move with it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from facemodel.display import DisplaySurface
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.surface import cells

LIFT = 0.12
"""Millimetres by which lines lie above the skin, so that they are not half sunk in it."""


@dataclass(frozen=True, eq=False)
class Crossings:
    """Ends of segments, two and two: where edges of the drawn skin are crossed.

    Attributes
    ----------
    one, other : (2 n,) drawn points
    share : (2 n,) of the way from one to the other
    """

    one: IntArray
    other: IntArray
    share: FloatArray

    def on(self, points: Float32Array, normals: Float32Array, lift: float = LIFT) -> Float32Array:
        """Where they are (2 n, 3) on a posed skin, somewhat above it."""
        share = self.share[:, None].astype(np.float32)
        place = (1 - share) * points[self.one] + share * points[self.other]
        outward = (1 - share) * normals[self.one] + share * normals[self.other]
        return np.ascontiguousarray(place + np.float32(lift) * outward)


def crossings(values: FloatArray, triangles: IntArray, levels: FloatArray) -> Crossings:
    """Where values (P,) that are linear on every triangle reach some levels."""
    found = [_at_level(values, triangles, float(level)) for level in levels]
    one, other, share = (np.concatenate(column) for column in zip(*found, strict=True)) if found else _nothing()
    return Crossings(one, other, share)


def _at_level(values: FloatArray, triangles: IntArray, level: float) -> tuple[IntArray, IntArray, FloatArray]:
    above = values > level
    corner = above[triangles]
    cut = np.flatnonzero(corner.any(axis=1) & ~corner.all(axis=1))
    corner, points = corner[cut], triangles[cut]
    # One corner lies on its own side; the line crosses the two edges that meet in it.
    odd = corner.sum(axis=1) == 1
    lone = np.where(odd, corner.argmax(axis=1), corner.argmin(axis=1))
    row = np.arange(len(cut))
    one = np.repeat(points[row, lone], 2)
    other = np.column_stack([points[row, (lone + 1) % 3], points[row, (lone + 2) % 3]]).ravel()
    return one, other, (level - values[one]) / (values[other] - values[one])


def _nothing() -> tuple[IntArray, IntArray, FloatArray]:
    empty = np.zeros(0, dtype=np.int64)
    return empty, empty, np.zeros(0)


def drawn_on(display: DisplaySurface, elements: IntArray) -> IntArray:
    """Drawn triangles (n, 3) that some triangles of the skin are cut into."""
    each = display.density**2
    rows: IntArray = (elements[:, None] * each + np.arange(each)).ravel()
    return np.asarray(display.triangles[rows])


class Lines:
    """Segments in one colour that shine through nothing and take no light.

    Parameters
    ----------
    colour, width, opacity : of the lines; width in pixels
    nearer : steps of depth that they are drawn in front of where they are; of lines in one place the nearer are seen

    Attributes
    ----------
    actor : the VTK side
    """

    def __init__(
        self, colour: tuple[float, float, float], width: float, opacity: float = 1.0, nearer: float = 6.0
    ) -> None:
        self._data = vtkPolyData()
        self._data.SetPoints(vtkPoints())
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._data)
        mapper.ScalarVisibilityOff()
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-1.0, -nearer)
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.PickableOff()
        shown = self.actor.GetProperty()
        shown.SetColor(*colour)
        shown.SetLighting(False)
        shown.SetLineWidth(width)
        shown.SetOpacity(opacity)
        self.actor.VisibilityOff()

    def show(self, ends: Float32Array) -> None:
        """Draw segments by their ends (2 n, 3), two and two; nothing without any."""
        self.actor.SetVisibility(len(ends) > 0)
        if not len(ends):
            return
        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(ends, dtype=np.float32), deep=True, array_type=VTK_FLOAT))
        if self._data.GetNumberOfLines() != len(ends) // 2:
            self._data.SetLines(cells(np.arange(len(ends)).reshape(-1, 2)))
        self._data.SetPoints(points)
        self._data.Modified()

    def hide(self) -> None:
        """Draw nothing."""
        self.actor.VisibilityOff()
