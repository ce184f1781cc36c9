"""The smoothest surface of the element through given values at the vertices."""

import numpy as np

from fem.assembly import Assembler
from fem.errors import FemError
from fem.factor import factorise
from fem.hct import Element
from fem.surface import ChartedSurface
from fem.tensors import element_tensors, uniform_material
from fem.types import FloatArray


class SmoothInterpolation:
    """Slopes for fields that are known at the vertices, so that they bend least; factorised once.

    Minimises the integral of w_ss^2 + 2 w_st^2 + w_tt^2 + stretching (w_s^2 + w_t^2) over the true surface:
    the thin-plate spline within the space of the element.

    Parameters
    ----------
    assembler
        The surface with N vertices, and the element.
    stretching
        Weight of the first derivatives in 1/mm^2; above zero the field overshoots less.
    """

    def __init__(self, assembler: Assembler, stretching: float = 0.0) -> None:
        self._dofs = assembler.dofs
        tensors = element_tensors(
            assembler.surface, uniform_material(assembler.surface.n_vertices, stretching, bending=1.0)
        )
        columns = assembler.assemble(tensors).matrix
        self._free = np.setdiff1d(np.arange(self._dofs.n_dofs), self._dofs.value_dofs)
        columns = columns[:, self._free]
        self._coupling = columns[self._dofs.value_dofs].T
        # Three values per triangle leave no slope free: this matrix is definite on every surface.
        self._factor = factorise(columns[self._free])

    def __call__(self, values: FloatArray) -> FloatArray:
        """Return (n_dofs, k) coefficients with (N, k) values in their place.

        Raises
        ------
        FemError
            If there is not one finite value per vertex.
        """
        count = self._dofs.surface.n_vertices
        if values.ndim != 2 or len(values) != count or not np.isfinite(values).all():
            raise FemError(f"Interpolation needs ({count}, k) finite values, not {values.shape}.")
        result = np.zeros((self._dofs.n_dofs, values.shape[1]))
        result[self._dofs.value_dofs] = values
        result[self._free] = self._factor.solve(-(self._coupling @ values))
        return result


def interpolate_smoothly(assembler: Assembler, values: FloatArray, stretching: float = 0.0) -> FloatArray:
    """Choose slopes so that one field takes (N, k) values at the vertices with the least bending.

    The parameters, the (n_dofs, k) coefficients and the errors are those of `SmoothInterpolation`.
    """
    return SmoothInterpolation(assembler, stretching)(values)


def smooth_assembler(surface: ChartedSurface, element: Element, stretching: float = 0.0) -> Assembler:
    """Return the assembler to solve with: on the smoothest surface through the vertices.

    Its `Assembler.smooth_positions` are the coefficients of that surface, which is also the one to draw.
    `stretching` is that of `interpolate_smoothly`; above zero the surface overshoots less at tight folds.
    """
    flat = Assembler(surface, element)
    return flat.on_smooth_surface(interpolate_smoothly(flat, surface.positions, stretching))
