"""Polynomials in two variables with all their derivatives, as known fields for the tests."""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import polynomial

from fem import Assembler
from fem.types import FloatArray


@dataclass(frozen=True)
class Polynomial:
    """sum of c[i, j] x^i y^j."""

    coefficients: FloatArray

    def derivative(self, in_x: int, in_y: int) -> "Polynomial":
        table = polynomial.polyder(self.coefficients, in_x, axis=0)
        return Polynomial(np.atleast_2d(polynomial.polyder(table, in_y, axis=1)))

    def __call__(self, points: FloatArray) -> FloatArray:
        return np.asarray(polynomial.polyval2d(points[..., 0], points[..., 1], self.coefficients))


def of_degree(degree: int, seed: int = 0) -> Polynomial:
    table = np.random.default_rng(seed).uniform(0.5, 1.5, (degree + 1, degree + 1))
    total = np.add.outer(np.arange(degree + 1), np.arange(degree + 1))
    return Polynomial(np.where(total <= degree, table, 0.0))


def interpolant(assembler: Assembler, field: Polynomial) -> FloatArray:
    """Degrees of freedom of the field in the chart, by their definition."""
    surface = assembler.surface
    result = np.empty(assembler.dofs.n_dofs)
    result[0 : 3 * surface.n_vertices : 3] = field(surface.chart)
    result[1 : 3 * surface.n_vertices : 3] = field.derivative(1, 0)(surface.chart)
    result[2 : 3 * surface.n_vertices : 3] = field.derivative(0, 1)(surface.chart)
    if assembler.element.dofs_per_edge:
        middle = surface.chart[surface.edges].mean(axis=1)
        slopes = np.stack([field.derivative(1, 0)(middle), field.derivative(0, 1)(middle)], axis=1)
        result[3 * surface.n_vertices :] = (slopes * surface.edge_normals).sum(axis=1)
    return result
