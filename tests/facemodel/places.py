"""Where on the drawn surface the vertices of the skin lie, and how far named places move."""

import numpy as np

from facemodel.basis import Basis
from facemodel.display import DisplaySurface
from facemodel.face import Face
from fem.types import FloatArray, IntArray


def points_of_vertices(face: Face, display: DisplaySurface) -> IntArray:
    """Return (N,) the drawn point on each vertex of the skin."""
    on_corner = np.flatnonzero(display.barycentric.max(axis=1) == 1.0)
    corner = display.barycentric[on_corner].argmax(axis=1)
    points = np.full(len(face.skin.positions), -1)
    points[face.skin.triangles[display.elements[on_corner], corner]] = on_corner
    return points


def vertex_fields(face: Face, basis: Basis) -> dict[str, FloatArray]:
    """Return the displacement (N, 3) of every skin vertex by every field, millimetres."""
    points = points_of_vertices(face, basis.display)
    return {name: basis.field(name)[points].astype(np.float64) for name in basis.names}
