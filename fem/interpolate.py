"""The smoothest surface of the element through given values at the vertices."""

import numpy as np

from fem.assembly import Assembler
from fem.errors import FemError
from fem.factor import factorise
from fem.hct import Element
from fem.surface import ChartedSurface
from fem.tensors import element_tensors, uniform_material
from fem.types import FloatArray


def interpolate_smoothly(assembler: Assembler, values: FloatArray, stretching: float = 0.0) -> FloatArray:
    """Choose slopes so that the field takes `values` at the vertices with the least bending.

    Minimises the integral of w_ss^2 + 2 w_st^2 + w_tt^2 + stretching (w_s^2 + w_t^2) over the true surface:
    the thin-plate spline within the space of the element.

    Parameters
    ----------
    assembler
        The surface with N vertices, and the element.
    values
        (N, k) values at the vertices, for instance the positions themselves.
    stretching
        Weight of the first derivatives in 1/mm^2; above zero the field overshoots less.

    Returns
    -------
    (n_dofs, k) coefficients, with `values` in their place.

    Raises
    ------
    FemError
        If there is not one finite value per vertex.
    """
    surface, dofs = assembler.surface, assembler.dofs
    if values.ndim != 2 or len(values) != surface.n_vertices or not np.isfinite(values).all():
        raise FemError(f"Interpolation needs ({surface.n_vertices}, k) finite values, not {values.shape}.")
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, stretching, bending=1.0))
    matrix = assembler.assemble(tensors).matrix
    free = np.setdiff1d(np.arange(dofs.n_dofs), dofs.value_dofs)
    columns = matrix[:, free]
    result = np.zeros((dofs.n_dofs, values.shape[1]))
    result[dofs.value_dofs] = values
    right = -(columns[dofs.value_dofs].T @ values)
    # Three values per triangle leave no slope free: this matrix is definite on every surface.
    result[free] = factorise(columns[free]).solve(right)
    return result


def smooth_assembler(surface: ChartedSurface, element: Element, stretching: float = 0.0) -> Assembler:
    """Return the assembler to solve with: on the smoothest surface through the vertices.

    Its `Assembler.smooth_positions` are the coefficients of that surface, which is also the one to draw.
    `stretching` is that of `interpolate_smoothly`; above zero the surface overshoots less at tight folds.
    """
    flat = Assembler(surface, element)
    return flat.on_smooth_surface(interpolate_smoothly(flat, surface.positions, stretching))
