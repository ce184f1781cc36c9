"""Reading a solved field anywhere on the surface, as sparse products."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from fem.assembly import Assembler
from fem.errors import FemError
from fem.hct import shape_functions
from fem.surface import edge_topology
from fem.types import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class SampleOperators:
    """Operators from degrees of freedom to values at P points; apply to (n_dofs, k) coefficients.

    Parameters
    ----------
    value
        (P, n_dofs) the field.
    d_u
        (P, n_dofs) its slope d/du in the chart.
    d_v
        (P, n_dofs) its slope d/dv in the chart.
    """

    value: csr_array
    d_u: csr_array
    d_v: csr_array


@dataclass(frozen=True, eq=False)
class Subdivision:
    """A regular sampling of every triangle, with points on shared corners and edges merged.

    Parameters
    ----------
    elements
        (P,) a triangle that holds each point.
    barycentric
        (P, 3) barycentric coordinates in it.
    triangles
        (T n^2, 3) fine triangles over the points, wound like the coarse ones, those of one coarse triangle
        together.
    """

    elements: IntArray
    barycentric: FloatArray
    triangles: IntArray


def sample_operators(assembler: Assembler, elements: IntArray, barycentric: FloatArray) -> SampleOperators:
    """Return the operators that evaluate a field and its slopes at points given by triangle and coordinates.

    Parameters
    ----------
    assembler
        The surface and element.
    elements
        (P,) triangle of each point.
    barycentric
        (P, 3) barycentric coordinates of each point.
    """
    shapes = shape_functions(assembler.surface, assembler.coefficients, elements, barycentric)
    columns = assembler.dofs.element_dofs[elements]

    def operator(weights: FloatArray) -> csr_array:
        starts = np.arange(len(elements) + 1) * columns.shape[1]
        shape = (len(elements), assembler.dofs.n_dofs)
        return csr_array((weights.ravel(), columns.ravel(), starts), shape=shape)

    return SampleOperators(
        value=operator(shapes.values),
        d_u=operator(shapes.gradients[:, 0]),
        d_v=operator(shapes.gradients[:, 1]),
    )


def subdivide(triangles: IntArray, segments: int) -> Subdivision:
    """Cut every edge into `segments` and every triangle into ``segments ** 2``.

    Points come in the order: corners (in the order of the vertices), points on edges, points inside
    triangles.

    Parameters
    ----------
    triangles
        (T, 3) vertex indices that use every vertex 0..N-1.
    segments
        Segments per edge, at least 1.

    Raises
    ------
    FemError
        If `segments` is less than 1.
    """
    if segments < 1:
        raise FemError(f"An edge cannot be cut into {segments} segments; take at least 1.")
    lattice = _lattice(segments)
    points = _point_numbers(triangles, lattice, segments)
    count = int(points.max()) + 1
    elements = np.empty(count, dtype=np.int64)
    barycentric = np.empty((count, 3))
    elements[points] = np.arange(len(triangles))[:, None]
    barycentric[points] = lattice / segments
    fine = points[:, _lattice_triangles(segments)].reshape(-1, 3)
    return Subdivision(elements, barycentric, fine)


def _lattice(segments: int) -> IntArray:
    """Return the (L, 3) steps (i, j, k) with sum `segments`; i falls slowest, j next."""
    steps = [(i, j, segments - i - j) for i in range(segments, -1, -1) for j in range(segments - i, -1, -1)]
    return np.array(steps, dtype=np.int64)


def _lattice_triangles(segments: int) -> IntArray:
    """Return the (n^2, 3) triangles between lattice points, wound like the triangle itself."""

    def number(row: int, column: int) -> int:
        return row * (row + 1) // 2 + column

    triangles = []
    for row in range(segments):
        for column in range(row + 1):
            below = number(row + 1, column)
            triangles.append((number(row, column), below, below + 1))
            if column < row:
                triangles.append((number(row, column), below + 1, number(row, column + 1)))
    return np.array(triangles, dtype=np.int64)


def _point_numbers(triangles: IntArray, lattice: IntArray, segments: int) -> IntArray:
    """Return (T, L) numbers of the lattice points of every triangle, equal where triangles share a point."""
    edges, triangle_edges = edge_topology(triangles)
    numbers = np.empty((len(triangles), len(lattice)), dtype=np.int64)
    for corner in range(3):
        numbers[:, lattice[:, corner] == segments] = triangles[:, corner, None]
    first_on_edges = int(triangles.max()) + 1
    for edge in range(3):
        start, end = (edge + 1) % 3, (edge + 2) % 3
        on_edge = (lattice[:, edge] == 0) & (lattice[:, start] > 0) & (lattice[:, end] > 0)
        upward = (triangles[:, start] < triangles[:, end])[:, None]
        step = np.where(upward, lattice[on_edge, end], lattice[on_edge, start])
        numbers[:, on_edge] = first_on_edges + triangle_edges[:, edge, None] * (segments - 1) + step - 1
    inside = (lattice > 0).all(axis=1)
    n_inside = int(inside.sum())
    own = np.arange(len(triangles) * n_inside).reshape(len(triangles), n_inside)
    numbers[:, inside] = first_on_edges + len(edges) * (segments - 1) + own
    return numbers
