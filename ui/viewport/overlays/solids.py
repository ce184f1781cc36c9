"""Flat shapes that are seen through everything: heads of arrows, boxes and dots of a size in pixels."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from fem.types import FloatArray, IntArray
from ui.viewport.overlays.marks import IN_FRONT, Colour
from ui.viewport.surface import cells

AROUND = 16


class Solids:
    """Triangles in one colour that take no light.

    Attributes
    ----------
    actor : the VTK side

    Parameters
    ----------
    colour : of all of them
    """

    def __init__(self, colour: Colour) -> None:
        self._data = vtkPolyData()
        self._data.SetPoints(vtkPoints())
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._data)
        mapper.ScalarVisibilityOff()
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, IN_FRONT)
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.PickableOff()
        self.actor.GetProperty().SetLighting(False)
        self.actor.GetProperty().SetColor(*colour)
        self.actor.VisibilityOff()

    def show(self, points: FloatArray, triangles: IntArray, colour: Colour, opacity: float = 1.0) -> None:
        """Draw triangles (t, 3) between points (n, 3)."""
        made = vtkPoints()
        made.SetData(numpy_to_vtk(np.ascontiguousarray(points, np.float32), deep=True, array_type=VTK_FLOAT))
        self._data.SetPoints(made)
        self._data.SetPolys(cells(triangles))
        self._data.Modified()
        self.actor.GetProperty().SetColor(*colour)
        self.actor.GetProperty().SetOpacity(opacity)
        self.actor.VisibilityOn()

    def hide(self) -> None:
        """Draw nothing."""
        self.actor.VisibilityOff()


def cone(foot: FloatArray, way: FloatArray, radius: float) -> tuple[FloatArray, IntArray]:
    """A cone from the middle (3,) of its base along a way (3,) to its tip."""
    one, other = across(way)
    turn = np.linspace(0.0, 2 * np.pi, AROUND, endpoint=False)[:, None]
    rim = foot + radius * (np.cos(turn) * one + np.sin(turn) * other)
    around, after = np.arange(AROUND), (np.arange(AROUND) + 1) % AROUND
    tip, base = np.full(AROUND, AROUND), np.full(AROUND, AROUND + 1)
    triangles = np.concatenate([np.column_stack([around, after, tip]), np.column_stack([after, around, base])])
    return np.concatenate([rim, [foot + way, foot]]), triangles


def box(middle: FloatArray, axes: FloatArray, half: float) -> tuple[FloatArray, IntArray]:
    """A cube about a middle (3,) along axes (3, 3)."""
    corners = np.array([[x, y, z] for x in (-half, half) for y in (-half, half) for z in (-half, half)])
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [[a, b, c] for a, b, c, _ in faces] + [[a, c, d] for a, _, c, d in faces]
    return middle + corners @ axes, np.array(triangles)


def across(way: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Two unit directions (3,) across a way (3,) and each other."""
    along = way / np.linalg.norm(way)
    one = np.cross(along, [0.0, 1.0, 0.0] if abs(along[1]) < 0.9 else [1.0, 0.0, 0.0])
    one /= np.linalg.norm(one)
    return one, np.cross(along, one)


def circle(centre: FloatArray, normal: FloatArray, radius: float, sides: int = 48) -> FloatArray:
    """Places (sides + 1, 3) around a centre (3,), across a normal (3,), closed."""
    one, other = across(normal)
    turn = np.linspace(0.0, 2 * np.pi, sides + 1)[:, None]
    return np.asarray(centre + radius * (np.cos(turn) * one + np.sin(turn) * other))
