"""Assembly of the scalar stiffness matrix on a sparsity pattern that is found once per surface."""

from collections.abc import Iterator
from copy import copy
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import csc_array

from fem.dofs import DofMap
from fem.element_quadrature import ElementQuadrature
from fem.errors import FemError
from fem.hct import Element
from fem.quadrature import rule_of_degree
from fem.surface import ChartedSurface
from fem.tensors import ElementTensors
from fem.types import FloatArray, IntArray

# Degree of tensor (1) times slope squared (2 + 2): exact for flat triangles. The Christoffel symbols of a curved
# surface raise the bending term to degree 7, but add only a term of lower order.
STIFFNESS_DEGREE = 5
# Elements handled at once: keeps the arrays of one batch within the cache of one core.
BATCH = 512


@dataclass(frozen=True, eq=False)
class Stiffness:
    """A scalar stiffness matrix and the element matrices it is the sum of.

    Parameters
    ----------
    matrix
        (n_dofs, n_dofs) symmetric positive semidefinite, CSC.
    element_matrices
        (T, n, n) contributions of the triangles.
    """

    matrix: csc_array
    element_matrices: FloatArray


class Assembler:
    """Assembles matrices of one surface and element; the pattern is fixed at construction.

    Parameters
    ----------
    surface
        The surface with T triangles.
    element
        HCT-12 or HCT-9.

    Attributes
    ----------
    smooth_positions
        (n_dofs, 3) coefficients of the smooth surface through the vertices, which make bending independent of the
        chart; None takes each triangle as flat. `smooth_assembler` finds them.
    """

    def __init__(self, surface: ChartedSurface, element: Element) -> None:
        self.surface = surface
        self.element = element
        self.dofs = DofMap(surface, element)
        self.coefficients = element.coefficients(surface)
        self.smooth_positions: FloatArray | None = None

    @cached_property
    def _pattern(self) -> tuple[IntArray, IntArray, IntArray]:
        """Column pointers, row indices, and the place in them of every entry of every element matrix."""
        local = self.dofs.element_dofs
        n_dofs = self.dofs.n_dofs
        keys = local[:, None, :] * n_dofs + local[:, :, None]
        entries, places = np.unique(keys.ravel(), return_inverse=True)
        starts = np.searchsorted(entries, np.arange(n_dofs + 1) * n_dofs)
        return starts.astype(np.int32), (entries % n_dofs).astype(np.int32), places

    def on_smooth_surface(self, smooth_positions: FloatArray) -> "Assembler":
        """Return this assembler with (n_dofs, 3) coefficients of a smooth surface, sharing the pattern."""
        if smooth_positions.shape != (self.dofs.n_dofs, 3):
            raise FemError(
                f"The smooth surface must be ({self.dofs.n_dofs}, 3) coefficients, not {smooth_positions.shape}."
            )
        other = copy(self)
        other.smooth_positions = smooth_positions
        return other

    def assemble(self, tensors: ElementTensors) -> Stiffness:
        """Integrate the energy over all triangles.

        Raises
        ------
        FemError
            If the tensors have another number of triangles than the surface.
        """
        everything = np.arange(self.surface.n_triangles)
        return self._summed(self.element_matrices(tensors, everything))

    def reassemble(self, stiffness: Stiffness, tensors: ElementTensors, touched: IntArray) -> Stiffness:
        """Integrate the `touched` triangles anew; equal to `assemble` when no other tensor has changed."""
        matrices = stiffness.element_matrices.copy()
        matrices[touched] = self.element_matrices(tensors, touched)
        return self._summed(matrices)

    def element_matrices(self, tensors: ElementTensors, elements: IntArray) -> FloatArray:
        """Return (m, n, n) energy matrices of the given triangles."""
        if len(tensors.stretching) != self.surface.n_triangles:
            raise FemError(
                f"There are tensors for {len(tensors.stretching)} triangles, "
                f"the surface has {self.surface.n_triangles}."
            )
        quadrature = self.quadrature(STIFFNESS_DEGREE)
        size = self.dofs.element_dofs.shape[1]
        result = np.empty((len(elements), size, size))
        for batch in batches(len(elements)):
            chosen = elements[batch]
            slopes, curvatures = quadrature.physical_derivatives(chosen)
            weights = quadrature.weights * self.surface.areas[chosen, None]
            result[batch] = _energy(slopes, quadrature.barycentric, tensors.stretching[chosen], weights)
            result[batch] += _energy(curvatures, quadrature.barycentric, tensors.bending[chosen], weights)
        return result

    def quadrature(self, degree: int) -> ElementQuadrature:
        """Return the quadrature of the given degree over the parts of this assembler's elements."""
        smooth = self.smooth_positions
        geometry = None if smooth is None else smooth[self.dofs.element_dofs]
        return ElementQuadrature(self.surface, self.coefficients, rule_of_degree(degree), geometry)

    def matrix_of(self, element_matrices: FloatArray) -> csc_array:
        """Sum (T, n, n) element matrices into an (n_dofs, n_dofs) CSC matrix."""
        starts, rows, places = self._pattern
        data = np.bincount(places, weights=element_matrices.ravel(), minlength=len(rows))
        size = self.dofs.n_dofs
        return csc_array((data, rows, starts), shape=(size, size))

    def _summed(self, element_matrices: FloatArray) -> Stiffness:
        return Stiffness(self.matrix_of(element_matrices), element_matrices)


def batches(count: int) -> Iterator[slice]:
    """Split `count` elements into slices of at most `BATCH`."""
    for start in range(0, count, BATCH):
        yield slice(start, min(start + BATCH, count))


def _energy(rows: FloatArray, barycentric: FloatArray, corners: FloatArray, weights: FloatArray) -> FloatArray:
    """Return the sum over points of weight * rows^T form rows, symmetric to the last bit.

    Parameters
    ----------
    rows
        (m, Q k, n) the k derivatives of the n shape functions at Q points.
    barycentric
        (Q, 3) coordinates that interpolate the forms between the corners.
    corners
        (m, 3, k, k) forms at the corners.
    weights
        (m, Q) quadrature weights with the area.
    """
    count, _, size = rows.shape
    width = corners.shape[-1]
    forms = (barycentric @ corners.reshape(count, 3, -1)) * weights[..., None]
    forms = forms.reshape(count, -1, width, width)
    weighted = (forms @ rows.reshape(count, -1, width, size)).reshape(rows.shape)
    product = np.swapaxes(rows, 1, 2) @ weighted
    return np.asarray(0.5 * (product + np.swapaxes(product, 1, 2)))
