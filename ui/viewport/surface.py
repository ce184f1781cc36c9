"""A triangle surface that VTK draws straight out of numpy arrays."""

from __future__ import annotations

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - without it VTK makes actors that cannot be drawn
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import VTK_FLOAT, VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkTexture

from fem.types import Float32Array, FloatArray, IntArray

ByteArray = NDArray[np.uint8]


class Surface:
    """An actor whose points, normals and colours are the arrays given, never copies of them.

    Attributes
    ----------
    points, normals : (n, 3) float32, C order; write into them, then call `moved`
    colours : (n, 4) uint8 or None; write into them, then call `recoloured`
    motion : (4, 4) that `moved_by` gave it
    data, mapper, actor : the VTK side
    """

    def __init__(
        self,
        points: Float32Array,
        normals: Float32Array,
        triangles: IntArray,
        colours: ByteArray | None = None,
    ) -> None:
        self.points, self.normals, self.colours = points, normals, colours
        self.motion: FloatArray | None = None
        self.data = vtkPolyData()
        self._drawn_points = shared(points, VTK_FLOAT)
        vertices = vtkPoints()
        vertices.SetData(self._drawn_points)
        self.data.SetPoints(vertices)
        self.data.SetPolys(cells(triangles))
        self._drawn_normals = shared(normals, VTK_FLOAT)
        self._drawn_normals.SetName("Normals")
        self.data.GetPointData().SetNormals(self._drawn_normals)
        if colours is not None:
            self._drawn_colours = shared(colours, VTK_UNSIGNED_CHAR)
            self._drawn_colours.SetName("colours")
            self.data.GetPointData().SetScalars(self._drawn_colours)
        self.mapper = vtkPolyDataMapper()
        self.mapper.SetInputData(self.data)
        self.mapper.SetScalarVisibility(colours is not None)
        self.mapper.SetColorModeToDirectScalars()
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.actor.GetProperty().SetInterpolationToPhong()

    def wear(self, image: ByteArray, coordinates: FloatArray) -> None:
        """Lay a picture (h, w, 3) uint8 on the surface, by texture coordinates (n, 2)."""
        placed = np.ascontiguousarray(coordinates, dtype=np.float32)
        self.data.GetPointData().SetTCoords(numpy_to_vtk(placed, deep=True, array_type=VTK_FLOAT))
        self.actor.SetTexture(texture(image))

    def moved(self) -> None:
        """Tell VTK that points and normals were written."""
        self._drawn_points.Modified()
        self.data.GetPoints().Modified()
        self._drawn_normals.Modified()
        self.data.Modified()

    def recoloured(self) -> None:
        """Tell VTK that the colours were written."""
        self._drawn_colours.Modified()
        self.data.Modified()


def shared(array: NDArray[np.generic], kind: int):
    """A VTK array over the memory of a C-ordered numpy array.

    Raises
    ------
    ValueError
        if the array is not contiguous, since VTK would then silently draw a copy
    """
    if not array.flags.c_contiguous:
        raise ValueError("An array that VTK is to draw must be contiguous in C order.")
    return numpy_to_vtk(array, deep=False, array_type=kind)


def texture(image: ByteArray) -> vtkTexture:
    """A picture (h, w, 3) uint8, its first row at v = 0, smooth at every distance."""
    height, width, channels = image.shape
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(image).reshape(-1, channels)
    data.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True, array_type=VTK_UNSIGNED_CHAR))
    made = vtkTexture()
    made.SetInputData(data)
    made.SetColorModeToDirectScalars()
    made.InterpolateOn()
    made.MipmapOn()
    made.SetMaximumAnisotropicFiltering(1)
    made.SetWrap(vtkTexture.ClampToEdge)
    return made


def cells(corners: IntArray) -> vtkCellArray:
    """Triangles (n, 3), lines (n, 2) or dots (n, 1) as VTK cells."""
    made = vtkCellArray()
    flat = np.ascontiguousarray(corners, dtype=np.int64)
    made.SetData(flat.shape[1], numpy_to_vtkIdTypeArray(flat.ravel(), deep=True))
    return made


def companion(surface: Surface, corners: IntArray) -> vtkActor:
    """Triangles (n, 3), lines (n, 2) or dots (n, 1) on the very points of a surface, with which they move."""
    data = vtkPolyData()
    data.SetPoints(surface.data.GetPoints())
    data.GetPointData().SetNormals(surface.data.GetPointData().GetNormals())
    put = {1: data.SetVerts, 2: data.SetLines, 3: data.SetPolys}[corners.shape[1]]
    put(cells(corners))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToPhong()
    return actor


def moved_by(surface: Surface, motion: FloatArray) -> None:
    """Give a rigid motion (4, 4) to an actor; its points stay."""
    if surface.motion is not None and np.array_equal(motion, surface.motion):
        return
    surface.motion = motion
    matrix = vtkMatrix4x4()
    matrix.DeepCopy([float(x) for x in motion.ravel()])
    surface.actor.SetUserMatrix(matrix)
