"""Consistent loads: F = integral of Phi^T f over the true surface.

A load is a force per area f in N/mm^2 on the skin. Given linear in every triangle, it turns into degrees of
freedom by one sparse product, so that hundreds of loads cost no loop.
"""

import numpy as np
from scipy.sparse import csr_array

from fem.assembly import Assembler, batches
from fem.errors import FemError
from fem.types import FloatArray, IntArray

# Shape function (3) times linear load (1).
LINEAR_LOAD_DEGREE = 4
# Enough for loads that vary within a triangle like a quadratic.
POINT_LOAD_DEGREE = 5


def load_operator(assembler: Assembler) -> csr_array:
    """Return the (n_dofs, N) operator from a load given at the vertices, linear in every triangle.

    Use as ``operator @ f`` with f (N, k), a column per coordinate and per load.
    """
    return _operator(assembler, assembler.surface.triangles, assembler.surface.n_vertices)


def corner_load_operator(assembler: Assembler) -> csr_array:
    """Return the (n_dofs, 3 T) operator from a load given at the corners of every triangle.

    Such a load may jump between triangles; column ``3 t + c`` belongs to corner c of triangle t.
    """
    count = 3 * assembler.surface.n_triangles
    return _operator(assembler, np.arange(count).reshape(-1, 3), count)


def load_points(assembler: Assembler, degree: int = POINT_LOAD_DEGREE) -> FloatArray:
    """Return the (T, Q, 3) positions in millimetres at which `point_loads` expects the load."""
    return assembler.quadrature(degree).positions


def point_loads(assembler: Assembler, forces: FloatArray, degree: int = POINT_LOAD_DEGREE) -> FloatArray:
    """Integrate a load given at the quadrature points.

    Parameters
    ----------
    assembler
        The surface and element.
    forces
        (T, Q, k) load at `load_points` of the same degree.
    degree
        Degree of the product of load and shape function (3) that is integrated exactly.

    Returns
    -------
    (n_dofs, k) loads.

    Raises
    ------
    FemError
        If the load does not match the points.
    """
    quadrature = assembler.quadrature(degree)
    expected = (assembler.surface.n_triangles, len(quadrature.weights))
    if forces.ndim != 3 or forces.shape[:2] != expected:
        raise FemError(f"The load must be {expected} points of k components, not {forces.shape}.")
    result = np.zeros((assembler.dofs.n_dofs, forces.shape[2]))
    for batch in batches(expected[0]):
        elements = np.arange(batch.start, batch.stop)
        weighted = forces[batch] * _point_areas(assembler, elements, quadrature.weights)[..., None]
        own = np.swapaxes(quadrature.values(elements), 1, 2) @ weighted
        np.add.at(result, assembler.dofs.element_dofs[batch], own)
    return result


def _point_areas(assembler: Assembler, elements: IntArray, weights: FloatArray) -> FloatArray:
    return assembler.surface.areas[elements, None] * weights


def _operator(assembler: Assembler, columns: IntArray, n_columns: int) -> csr_array:
    local = assembler.dofs.element_dofs
    quadrature = assembler.quadrature(LINEAR_LOAD_DEGREE)
    blocks = np.empty((*local.shape, 3))
    for batch in batches(len(local)):
        elements = np.arange(batch.start, batch.stop)
        weighted = quadrature.barycentric * _point_areas(assembler, elements, quadrature.weights)[..., None]
        blocks[batch] = np.swapaxes(quadrature.values(elements), 1, 2) @ weighted
    rows = np.broadcast_to(local[:, :, None], blocks.shape)
    across = np.broadcast_to(columns[:, None, :], blocks.shape)
    entries = (blocks.ravel(), (rows.ravel(), across.ravel()))
    return csr_array(entries, shape=(assembler.dofs.n_dofs, n_columns))
