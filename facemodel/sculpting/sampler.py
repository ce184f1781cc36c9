"""From a displacement of the mesh's vertices to what is drawn of it, smooth across all edges."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array, csr_array, vstack

from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.mesh import submesh
from facemodel.painting.geodesic import SurfacePoint
from facemodel.sampling import carried_points
from facemodel.sculpting.slopes import vertex_slopes
from fem import HCT9, Assembler, ChartedSurface, sample_operators
from fem.types import Float32Array, FloatArray, IntArray

KEPT = 2
"""Drawn surfaces whose sampler is remembered: that of the document, and one more."""


@dataclass(frozen=True, eq=False)
class DrawnChange:
    """What is drawn otherwise.

    Attributes
    ----------
    rows : (r,) points of the live part of what is posed: those of the carried parts, then the moving skin
    moved : (r, 3) float32, millimetres
    points : (s,) moving points of the skin
    slopes : (6, s) float32, the rows x, y, z of d/du and of d/dv
    """

    rows: IntArray
    moved: Float32Array
    points: IntArray
    slopes: Float32Array


class CorrectionSampler:
    """Linear operators from displacements of the skin's vertices to the rows of a basis.

    Between the vertices the displacement is that of the reduced Hsieh-Clough-Tocher element, with slopes at the
    vertices that a local fit gives: it is smooth across edges, and shows no facet.  Along the rim it lies flat.

    Parameters
    ----------
    face : whose skin it is
    display : what is drawn of it
    """

    def __init__(self, face: Face, display: DisplaySurface) -> None:
        self.display = display
        mesh, vertices = submesh(face.skin, face.solved)
        assembler = Assembler(ChartedSurface(mesh.positions, mesh.triangles, face.chart[vertices]), HCT9)
        self._assembler, self._number = assembler, np.cumsum(face.solved) - 1
        fitted = self._fitted = _coefficients(face, assembler, vertices)
        moving = slice(0, display.moving)
        sample = sample_operators(assembler, self._number[display.elements[moving]], display.barycentric[moving])
        carried = csr_array(carried_points(face, np.eye(len(face.skin.positions))))
        self._value: csc_array = csc_array(vstack([carried, sample.value @ fitted]))
        self._d_u: csc_array = csc_array(sample.d_u @ fitted)
        self._d_v: csc_array = csc_array(sample.d_v @ fitted)

    def rows(self, vertices: IntArray, moved: FloatArray | Float32Array) -> tuple[Float32Array, Float32Array]:
        """The rows of `Basis.fields` (3 Q,) and `Basis.slopes` (6 S,) of a displacement (k, 3) of some vertices."""
        exact = np.asarray(moved, dtype=np.float64)
        points = (self._value[:, vertices] @ exact).astype(np.float32)
        slopes = [operator[:, vertices] @ exact for operator in (self._d_u, self._d_v)]
        return points.ravel(), np.concatenate([each.T for each in slopes]).astype(np.float32).ravel()

    def change(self, vertices: IntArray, moved: FloatArray) -> DrawnChange:
        """What is drawn otherwise if some vertices (k,) are moved (k, 3) farther; the rest is left out."""
        value, d_u, d_v = (operator[:, vertices] for operator in (self._value, self._d_u, self._d_v))
        rows = np.unique(value.indices).astype(np.int64)
        points = np.unique(np.concatenate([d_u.indices, d_v.indices])).astype(np.int64)
        slopes = [(csr_array(each)[points] @ moved).T for each in (d_u, d_v)]
        shifted = csr_array(value)[rows] @ moved
        return DrawnChange(rows, shifted.astype(np.float32), points, np.concatenate(slopes).astype(np.float32))

    def shares_at(self, point: SurfacePoint) -> FloatArray:
        """How far (N,) a place on the solved skin goes with each vertex; with all of them together it goes once."""
        element = self._number[point.triangle : point.triangle + 1]
        sample = sample_operators(self._assembler, element, point.barycentric[None])
        return np.asarray((sample.value @ self._fitted).toarray()[0])


def _coefficients(face: Face, assembler: Assembler, vertices: IntArray) -> csr_array:
    """Operator (n_dofs, N) from values at all skin vertices to those degrees of freedom that the element has."""
    surface = assembler.surface
    d_u, d_v = vertex_slopes(surface.chart, surface.triangles)
    rim = np.isin(vertices, face.skin.triangles[~face.solved])
    free = csr_array((1.0 - rim, (np.arange(len(vertices)), np.arange(len(vertices)))))
    own = csr_array((np.ones(len(vertices)), (np.arange(len(vertices)), vertices)), (len(vertices), len(face.uv)))
    kinds = csr_array(vstack([own, free @ d_u @ own, free @ d_v @ own]))
    # Value, d/du and d/dv of one vertex follow one another.
    order = np.arange(3 * len(vertices)).reshape(3, -1).T.ravel()
    return csr_array(kinds[order])


_known: deque[tuple[Face, CorrectionSampler]] = deque(maxlen=KEPT)


def correction_sampler(face: Face, display: DisplaySurface) -> CorrectionSampler:
    """The sampler of a drawn surface, remembered; any thread may have it made before it is wanted."""
    for known, sampler in tuple(_known):
        if sampler.display is display and known.skin is face.skin and known.parts is face.parts:
            return sampler
    made = CorrectionSampler(face, display)
    _known.append((face, made))
    return made
