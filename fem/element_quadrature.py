"""Quadrature over the three parts of every triangle, with the shape functions in physical units."""

from dataclasses import dataclass

import numpy as np

from fem import bernstein
from fem.hct import part_gradients, second_derivative_weights, triangle_coordinates
from fem.quadrature import TriangleRule
from fem.surface import ChartedSurface
from fem.types import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class ElementQuadrature:
    """One rule on each part: Q points in a triangle, part by part.

    Parameters
    ----------
    surface
        The surface.
    coefficients
        (T, 3, 10, n) Bernstein coefficients of the element.
    rule
        Rule on each part; Q is three times its number of points.
    geometry
        (T, n, 3) element coefficients of the smooth surface, for second derivatives that do not depend on the
        chart; None takes each triangle as flat.
    """

    surface: ChartedSurface
    coefficients: FloatArray
    rule: TriangleRule
    geometry: FloatArray | None = None

    @property
    def barycentric(self) -> FloatArray:
        """(Q, 3) barycentric coordinates in the triangle, the same in all."""
        return triangle_coordinates(self.rule.points).reshape(-1, 3)

    @property
    def weights(self) -> FloatArray:
        """(Q,) weights that sum to 1; multiply by the true area of the triangle."""
        return np.tile(self.rule.weights / 3.0, 3)

    @property
    def positions(self) -> FloatArray:
        """(T, Q, 3) points on the flat triangles in millimetres."""
        return np.asarray(self.barycentric @ self.surface.positions[self.surface.triangles])

    def values(self, elements: IntArray) -> FloatArray:
        """Return (m, Q, n) shape functions of the m elements at their points."""
        own = self.coefficients[elements]
        return self._joined(bernstein.values(self.rule.points) @ own, 1)

    def physical_derivatives(self, elements: IntArray) -> tuple[FloatArray, FloatArray]:
        """Return first and second derivatives in the isometric frame (s, t) of each triangle.

        First derivatives pull back with J^T and second ones with J^T H J, where J = d(u, v)/d(s, t). Both are
        applied to the barycentric coordinates, on which the parts are plain cubics.

        J jumps between triangles, so J^T H J alone misses how the chart itself bends, and two charts of one
        surface would keep different solutions however fine the mesh. On a smooth surface X the second derivative
        that does not depend on the chart is the covariant one, w_ij - Gamma^k_ij w_k with
        Gamma^k_ij = e_k . X_ij (do Carmo, Riemannian Geometry, chapter 2); e_1, e_2 are the directions s, t.

        Returns
        -------
        (m, Q 2, n) with rows w_s, w_t of each point, and (m, Q 3, n) with rows w_ss, w_tt, w_st.
        """
        own = self.coefficients[elements]
        along = part_gradients(self.surface.chart_gradients[elements] @ self.surface.jacobians[elements])
        first = np.swapaxes(along, -2, -1)[:, :, None] @ bernstein.gradients(self.rule.points)
        second = second_derivative_weights(along)[:, :, None] @ bernstein.hessians(self.rule.points)
        slopes, curvatures = self._joined(_on(first, own), 2), self._joined(_on(second, own), 3)
        if self.geometry is not None:
            towards_plane = np.swapaxes(self.surface.frames[elements], 1, 2)
            christoffel = (curvatures @ self.geometry[elements] @ towards_plane).reshape(len(own), -1, 3, 2)
            turned = christoffel @ slopes.reshape(len(own), -1, 2, own.shape[-1])
            curvatures = curvatures - turned.reshape(curvatures.shape)
        return slopes, curvatures

    def _joined(self, rows: FloatArray, per_point: int) -> FloatArray:
        return rows.reshape(len(rows), 3 * len(self.rule.weights) * per_point, -1)


def _on(derivatives: FloatArray, coefficients: FloatArray) -> FloatArray:
    """Apply (m, 3, q, d, 10) derivatives of the cubics to (m, 3, 10, n) coefficients."""
    count, parts, points, kinds, _ = derivatives.shape
    return np.asarray(derivatives.reshape(count, parts, points * kinds, 10) @ coefficients)
