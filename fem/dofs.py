"""Numbering of the degrees of freedom of one scalar field on a surface."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fem.hct import Element
from fem.ordering import nested_dissection
from fem.surface import ChartedSurface
from fem.types import IntArray


@dataclass(frozen=True, eq=False)
class DofMap:
    """Degrees of freedom: 3 i, 3 i + 1, 3 i + 2 are value, d/du, d/dv of vertex i; 3 N + e is the slope of
    edge e.

    Parameters
    ----------
    surface
        The surface with N vertices and E edges.
    element
        The element; only HCT-12 has edge slopes.
    """

    surface: ChartedSurface
    element: Element

    @property
    def n_dofs(self) -> int:
        """Number of scalar degrees of freedom: 3 N, or 3 N + E."""
        return 3 * self.surface.n_vertices + self.element.dofs_per_edge * len(self.surface.edges)

    @cached_property
    def element_dofs(self) -> IntArray:
        """(T, 9 or 12) degrees of freedom of each triangle in the element's local order."""
        corners = 3 * self.surface.triangles[:, :, None] + np.arange(3)
        own = corners.reshape(-1, 9)
        if self.element.dofs_per_edge == 0:
            return own
        return np.hstack([own, 3 * self.surface.n_vertices + self.surface.triangle_edges])

    @cached_property
    def elimination_rank(self) -> IntArray:
        """(n_dofs,) place of each degree of freedom in an order of elimination that fills the factors little."""
        chart = self.surface.chart
        places = chart[self.vertex_of(np.arange(self.n_dofs))]
        order = nested_dissection(chart[self.surface.triangles].mean(axis=1), self.element_dofs, places)
        rank = np.zeros(self.n_dofs, dtype=np.int64)
        rank[order] = np.arange(len(order))
        return rank

    @property
    def value_dofs(self) -> IntArray:
        """(N,) degree of freedom that is the value at each vertex."""
        return 3 * np.arange(self.surface.n_vertices)

    def vertex_of(self, dofs: IntArray) -> IntArray:
        """Return the vertex that each degree of freedom belongs to; the lower end for a slope at an edge."""
        n_corner = 3 * self.surface.n_vertices
        edge = np.clip(dofs - n_corner, 0, len(self.surface.edges) - 1)
        return np.where(dofs < n_corner, dofs // 3, self.surface.edges[edge, 0])
