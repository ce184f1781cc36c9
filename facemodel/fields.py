"""From coefficients of the finite elements to rows of a basis: what is drawn of every field."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.actions import ActionUnit, JawMotion, skin_units
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.sampling import HeadSurface, SolvedRegion, carried_points, display_surface, field_sampler
from fem import SampleOperators
from fem.types import Float32Array, FloatArray, IntArray

STILL = JawMotion(0.0)


@dataclass(frozen=True, eq=False)
class FieldSampler:
    """Samples fields on the points that are drawn; found once per face, element and density.

    Attributes
    ----------
    face : whose parts are carried by the skin
    display : the surface that is drawn
    operators : from the region's degrees of freedom to the moving points of the display
    vertices, value_dofs : (n,) skin vertex and degree of freedom of the value of each vertex of the region
    """

    face: Face
    display: DisplaySurface
    operators: SampleOperators
    vertices: IntArray
    value_dofs: IntArray

    @property
    def unknowns(self) -> int:
        """Scalar degrees of freedom of the region."""
        return int(self.operators.value.shape[1])

    def at_vertices(self, coefficients: FloatArray) -> FloatArray:
        """How far (N, k) the vertices of the whole skin move by coefficients (n_dofs, k)."""
        moved = np.zeros((len(self.face.skin.positions), coefficients.shape[1]))
        moved[self.vertices] = coefficients[self.value_dofs]
        return moved

    def rows(self, coefficients: FloatArray) -> tuple[Float32Array, Float32Array]:
        """The rows of `Basis.fields` and `Basis.slopes` of fields given as coefficients (n_dofs, 3, M)."""
        count = coefficients.shape[2]
        flat = coefficients.reshape(len(coefficients), 3 * count)
        moved = np.concatenate([carried_points(self.face, self.at_vertices(flat)), self.operators.value @ flat])
        d_u, d_v = self.operators.d_u @ flat, self.operators.d_v @ flat
        return _points(moved, count), np.concatenate([_planes(d_u, count), _planes(d_v, count)], axis=1)


def face_sampler(face: Face, head: HeadSurface, region: SolvedRegion, density: int) -> FieldSampler:
    """A sampler of a face's fields, ``density`` segments per edge of an element."""
    display = display_surface(face, head, density)
    operators = field_sampler(face, display, region)
    return FieldSampler(face, display, operators, region.vertices, region.assembler.dofs.value_dofs)


def jaw_table(units: tuple[ActionUnit, ...]) -> FloatArray:
    """Opening in degrees, slide and shift to the left in millimetres of every field, (M, 3)."""
    motions = [unit.jaw_of(name) or STILL for unit in skin_units(units) for name in unit.fields]
    rows = [(each.degrees, each.slide, each.side) for each in motions]
    return np.array(rows, dtype=np.float64).reshape(-1, 3)


def _points(points: FloatArray, count: int) -> Float32Array:
    """(Q, 3 M) with the coordinate slower than the field, to (M, 3 Q)."""
    by_field = points.reshape(len(points), 3, count).transpose(2, 0, 1)
    return np.ascontiguousarray(by_field, dtype=np.float32).reshape(count, 3 * len(points))


def _planes(slopes: FloatArray, count: int) -> Float32Array:
    """(S, 3 M) to (M, 3 S) with the coordinate slowest."""
    by_field = slopes.reshape(len(slopes), 3, count).transpose(2, 1, 0)
    return np.ascontiguousarray(by_field, dtype=np.float32).reshape(count, 3 * len(slopes))
