"""The reduced Hsieh-Clough-Tocher triangle with 9 degrees of freedom.

Value, d/du and d/dv at each corner; the normal slope (in the chart) is linear along every edge. Local order:
(w, w_u, w_v) of corners 0, 1, 2. It contains all quadratics.
"""

from dataclasses import dataclass

import numpy as np

from fem.hct12 import HCT12
from fem.surface import ChartedSurface
from fem.types import FloatArray


@dataclass(frozen=True)
class Hct9:
    """The reduced element: cubic along edges, linear normal slope."""

    name: str = "HCT-9"
    dofs_per_edge: int = 0

    def coefficients(self, surface: ChartedSurface) -> FloatArray:
        """Return (T, 3, 10, 9): the coefficients of HCT-12, each mid-edge slope the mean of its two ends."""
        full = HCT12.coefficients(surface)
        normals = surface.edge_normals[surface.triangle_edges]
        slopes = np.zeros((surface.n_triangles, 3, 9))
        for edge in range(3):
            for corner in ((edge + 1) % 3, (edge + 2) % 3):
                slopes[:, edge, 3 * corner + 1 : 3 * corner + 3] = 0.5 * normals[:, edge]
        return np.asarray(full[..., :9] + full[..., 9:] @ slopes[:, None])


HCT9 = Hct9()
