"""The Hsieh-Clough-Tocher split: three cubics on one triangle that meet with continuous slopes.

The triangle is split at its barycentre S. Part k lies at edge k (opposite corner k) and has the corners (k +
1, k + 2, S), indices modulo 3; its cubic is held as ten Bernstein coefficients, each a linear function of the
element's degrees of freedom. See Ciarlet, The Finite Element Method for Elliptic Problems (1978), section
6.1.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from fem import bernstein
from fem.surface import ChartedSurface
from fem.types import FloatArray, IntArray


class Element(Protocol):
    """A C1 element: how many degrees of freedom it has and how they shape its three cubics."""

    @property
    def name(self) -> str:
        """Short name, as shown to a user."""
        ...

    @property
    def dofs_per_edge(self) -> int:
        """Degrees of freedom at each mid-edge: 0 or 1."""
        ...

    def coefficients(self, surface: ChartedSurface) -> FloatArray:
        """Return (T, 3, 10, n) Bernstein coefficients of each part per local degree of freedom."""
        ...


@dataclass(frozen=True, eq=False)
class ShapeFunctions:
    """Shape functions of the elements at P points, in the chart.

    Parameters
    ----------
    values
        (P, n) values of the n local shape functions.
    gradients
        (P, 2, n) derivatives d/du, d/dv.
    hessians
        (P, 3, n) derivatives d2/du2, d2/dv2, d2/dudv. They jump across the edges of the parts.
    """

    values: FloatArray
    gradients: FloatArray
    hessians: FloatArray


def part_gradients(gradients: FloatArray) -> FloatArray:
    """Return the derivatives of each part's barycentric coordinates.

    Parameters
    ----------
    gradients
        (T, 3, 2) derivatives of the triangle's barycentric coordinates along two directions.

    Returns
    -------
    (T, 3, 3, 2) derivatives [triangle, part, coordinate, direction].
    """
    own = gradients
    return np.stack([np.roll(own, -1, axis=1) - own, np.roll(own, -2, axis=1) - own, 3.0 * own], axis=2)


def second_derivative_weights(first: FloatArray) -> FloatArray:
    """Return how second derivatives along two directions follow from those by barycentric coordinates.

    Parameters
    ----------
    first
        (..., 3, 2) constant derivatives of the barycentric coordinates along directions 1 and 2.

    Returns
    -------
    (..., 3, 6) weights of `bernstein.SECOND_PAIRS` in the derivatives 11, 22 and 12.
    """
    weights = np.empty((*first.shape[:-2], 3, 6))
    for column, (i, j) in enumerate(bernstein.SECOND_PAIRS):
        mixed = 1.0 if i == j else 2.0
        weights[..., 0, column] = mixed * first[..., i, 0] * first[..., j, 0]
        weights[..., 1, column] = mixed * first[..., i, 1] * first[..., j, 1]
        crossed = first[..., i, 0] * first[..., j, 1] + first[..., j, 0] * first[..., i, 1]
        weights[..., 2, column] = 0.5 * mixed * crossed
    return weights


def parts_of(barycentric: FloatArray) -> tuple[IntArray, FloatArray]:
    """Find the part that each point lies in.

    Parameters
    ----------
    barycentric
        (P, 3) barycentric coordinates in the triangle.

    Returns ------- (P,) parts, and (P, 3) barycentric coordinates within the part. On an edge between parts
    the first one is named.
    """
    part = np.argmin(barycentric, axis=1)
    rows = np.arange(len(part))
    least = barycentric[rows, part]
    ahead = barycentric[rows, (part + 1) % 3] - least
    behind = barycentric[rows, (part + 2) % 3] - least
    return part, np.stack([ahead, behind, 3.0 * least], axis=1)


def triangle_coordinates(mu: FloatArray) -> FloatArray:
    """Return (3, P, 3) barycentric coordinates in the triangle of points `mu` (P, 3) of each part."""
    third = mu[:, 2] / 3.0
    first = np.stack([third, mu[:, 0] + third, mu[:, 1] + third], axis=1)
    return np.stack([np.roll(first, part, axis=1) for part in range(3)])


def shape_functions(
    surface: ChartedSurface,
    coefficients: FloatArray,
    elements: IntArray,
    barycentric: FloatArray,
    parts: IntArray | None = None,
) -> ShapeFunctions:
    """Evaluate the shape functions of one element at each point, in the chart.

    Parameters
    ----------
    surface
        The surface whose chart carries the elements.
    coefficients
        (T, 3, 10, n) from `Element.coefficients`.
    elements
        (P,) triangle of each point.
    barycentric
        (P, 3) barycentric coordinates of each point in its triangle.
    parts
        (P,) part whose cubic is evaluated; by default the part that holds the point. To name it matters only
        on an edge between parts, where the second derivatives jump.
    """
    if parts is None:
        parts, mu = parts_of(barycentric)
    else:
        rows = np.arange(len(parts))
        least = barycentric[rows, parts]
        others = [barycentric[rows, (parts + step) % 3] - least for step in (1, 2)]
        mu = np.stack([*others, 3.0 * least], axis=1)
    own = coefficients[elements, parts]
    first = part_gradients(surface.chart_gradients)[elements, parts]
    second = second_derivative_weights(first)
    return ShapeFunctions(
        values=(bernstein.values(mu)[:, None, :] @ own)[:, 0],
        gradients=np.swapaxes(first, 1, 2) @ bernstein.gradients(mu) @ own,
        hessians=second @ bernstein.hessians(mu) @ own,
    )
