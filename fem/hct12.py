"""The Hsieh-Clough-Tocher triangle with 12 degrees of freedom.

Value, d/du and d/dv at each corner, and the slope along `ChartedSurface.edge_normals` at the middle of each
edge. Local order: (w, w_u, w_v) of corners 0, 1, 2, then the normal slopes of edges 0, 1, 2. It contains all
cubics.
"""

from dataclasses import dataclass

import numpy as np

from fem.hct import part_gradients
from fem.surface import ChartedSurface
from fem.types import FloatArray


@dataclass(frozen=True)
class Hct12:
    """The full element: cubic along edges, quadratic normal slope."""

    name: str = "HCT-12"
    dofs_per_edge: int = 1

    def coefficients(self, surface: ChartedSurface) -> FloatArray:
        """Return (T, 3, 10, 12) Bernstein coefficients of each part per local degree of freedom.

        Continuous slopes across the inner edges make every ordinate next to the barycentre the mean of its
        three neighbours (Farin, Curves and Surfaces for CAGD, section on Clough-Tocher interpolants).
        """
        result = np.zeros((surface.n_triangles, 3, 10, 12))
        uv = surface.chart[surface.triangles]
        centre = uv.mean(axis=1)
        for part in range(3):
            a, b = (part + 1) % 3, (part + 2) % 3
            result[:, part, 0] = _ordinate(uv, a, uv[:, a])
            result[:, part, 1] = _ordinate(uv, b, uv[:, b])
            result[:, part, 3] = _ordinate(uv, a, uv[:, b])
            result[:, part, 4] = _ordinate(uv, b, uv[:, a])
            result[:, part, 5] = _ordinate(uv, a, centre)
            result[:, part, 6] = _ordinate(uv, b, centre)
        _fill_middle(result, surface)
        _fill_around_barycentre(result)
        return result


def _ordinate(uv: FloatArray, corner: int, target: FloatArray) -> FloatArray:
    """Return (T, 12) w + slope . (target - corner) / 3: the ordinate a third of the way to `target`."""
    ordinate = np.zeros((len(uv), 12))
    ordinate[:, 3 * corner] = 1.0
    ordinate[:, 3 * corner + 1 : 3 * corner + 3] = (target - uv[:, corner]) / 3.0
    return ordinate


def _fill_middle(result: FloatArray, surface: ChartedSurface) -> None:
    """Set the ordinate in the middle of each part so that the mid-edge normal slope is its degree of freedom.

    The normal slope along the edge is a quadratic with the Bernstein ordinates 3 q20, 3 q11, 3 q02; at the
    middle it is 3 (q20 + 2 q11 + q02) / 4, and q11 alone holds the ordinate sought.
    """
    normals = surface.edge_normals[surface.triangle_edges]
    along = np.einsum("tpcd,tpd->tpc", part_gradients(surface.chart_gradients), normals)[..., None]
    to_a, to_b, to_centre = along[:, :, 0], along[:, :, 1], along[:, :, 2]
    q20 = to_a * result[:, :, 0] + to_b * result[:, :, 3] + to_centre * result[:, :, 5]
    q02 = to_a * result[:, :, 4] + to_b * result[:, :, 1] + to_centre * result[:, :, 6]
    known = to_a * result[:, :, 3] + to_b * result[:, :, 4]
    slope = np.eye(12)[9:] / 3.0
    result[:, :, 9] = (2.0 * slope - 0.5 * (q20 + q02) - known) / to_centre


def _fill_around_barycentre(result: FloatArray) -> None:
    near = np.empty((len(result), 3, 12))
    for corner in range(3):
        # Part corner + 2 starts at this corner, part corner + 1 ends at it.
        starting, ending = (corner + 2) % 3, (corner + 1) % 3
        near[:, corner] = (result[:, starting, 5] + result[:, starting, 9] + result[:, ending, 9]) / 3.0
    result[:, :, 2] = near.mean(axis=1)[:, None]
    for part in range(3):
        result[:, part, 7] = near[:, (part + 1) % 3]
        result[:, part, 8] = near[:, (part + 2) % 3]


HCT12 = Hct12()
