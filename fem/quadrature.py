"""Triangle quadrature with a stated degree of exactness."""

from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.special import roots_jacobi

from fem.types import FloatArray


@dataclass(frozen=True, eq=False)
class TriangleRule:
    """Points and weights that integrate polynomials of `degree` exactly over a triangle.

    Parameters
    ----------
    points
        (Q, 3) barycentric coordinates.
    weights
        (Q,) weights that sum to 1; multiply by the area of the triangle.
    degree
        Highest total degree integrated exactly.
    """

    points: FloatArray
    weights: FloatArray
    degree: int


@cache
def radon_rule() -> TriangleRule:
    """Return the 7-point rule of degree 5 (Radon 1948)."""
    root = np.sqrt(15.0)
    points = [(1 / 3, 1 / 3, 1 / 3)]
    weights = [9 / 40]
    for sign in (-1.0, 1.0):
        near = (6.0 + sign * root) / 21.0
        far = 1.0 - 2.0 * near
        points += [(far, near, near), (near, far, near), (near, near, far)]
        weights += [(155.0 + sign * root) / 1200.0] * 3
    return TriangleRule(np.array(points), np.array(weights), 5)


@cache
def conical_rule(order: int) -> TriangleRule:
    """Return the conical product of two Gauss rules, exact to degree ``2 * order - 1``.

    The square is collapsed onto the triangle, and the factor (1 - x) of that map is the weight of the
    Gauss-Jacobi rule in x (Stroud 1971, section 2.4). All points are inside, all weights positive.

    Parameters
    ----------
    order
        Points per direction; the rule has ``order ** 2`` points.
    """
    x, x_weights = roots_jacobi(order, 1.0, 0.0)
    y, y_weights = np.polynomial.legendre.leggauss(order)
    first, second = np.meshgrid((x + 1.0) / 2.0, (y + 1.0) / 2.0, indexing="ij")
    second = second * (1.0 - first)
    points = np.stack([first, second, 1.0 - first - second], axis=-1).reshape(-1, 3)
    weights = np.outer(x_weights, y_weights).ravel()
    return TriangleRule(points, weights / weights.sum(), 2 * order - 1)


def rule_of_degree(degree: int) -> TriangleRule:
    """Return a rule exact for polynomials of total degree `degree` or less."""
    if degree <= 5:
        return radon_rule()
    return conical_rule(degree // 2 + 1)
