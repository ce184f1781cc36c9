"""A layer under the surface that resists a change of its volume: what is pressed together bulges.

The layer has the thickness t; its far side stays, and displacements are linear across it. To first order a place of
the surface that moves by w then changes the volume under a unit of its area by w . n + t / 2 div w, with the outward
normal n and the divergence along the surface. The penalty

    integral of kappa (w . n + t / 2 div w)^2 dA

couples the three coordinates and is linear, so that superposition holds.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array, csr_array

from fem.assembly import Assembler, batches
from fem.blocks import block_matrix
from fem.errors import FemError
from fem.types import FloatArray, IntArray

# Two shape functions (3 + 3) times a stiffness linear in the triangle (1). Thickness and the normals of a smooth
# surface add terms of lower order.
VOLUME_DEGREE = 7
# Below this share of the longest the tangents of a smooth surface span no plane.
FLATTEST = 1e-9


@dataclass(frozen=True, eq=False)
class VolumeLayer:
    """The layer under every vertex; stiffness and thickness are linear in every triangle.

    Parameters
    ----------
    stiffness
        (N,) kappa in N/mm^3, not negative; there is no layer where it is zero.
    thickness
        (N,) t in millimetres, not negative.

    Raises
    ------
    FemError
        If a value is negative or not finite.
    """

    stiffness: FloatArray
    thickness: FloatArray

    def __post_init__(self) -> None:
        for name in ("stiffness", "thickness"):
            values = np.asarray(getattr(self, name))
            bad = np.flatnonzero(~(np.isfinite(values) & (values >= 0.0)))
            if len(bad):
                raise FemError(
                    f"The {name} of the layer at vertex {bad[0]} is {values[bad[0]]}; "
                    "it must be finite and not negative."
                )

    def coupling(self, assembler: Assembler) -> csc_array:
        """Return the (3 n_dofs, 3 n_dofs) matrix, unknown ``3 * dof + coordinate``."""
        elements = self._elements(assembler)
        local = assembler.dofs.element_dofs
        matrices = np.zeros((3, 3, len(local), local.shape[1], local.shape[1]))
        for batch in batches(len(elements)):
            own = elements[batch]
            rows, weights = self._changes(assembler, own)
            weighted = rows * weights[..., None, None]
            for one in range(3):
                for other in range(one, 3):
                    product = np.swapaxes(weighted[:, :, one], 1, 2) @ rows[:, :, other]
                    matrices[one, other, own] = product
                    matrices[other, one, own] = np.swapaxes(product, 1, 2)
        return block_matrix([[assembler.matrix_of(entry) for entry in line] for line in matrices])

    def load_operator(self, assembler: Assembler) -> csr_array:
        """Return the (3 n_dofs, N) operator from a volume that is put under the surface to its loads.

        A volume v per area, linear in every triangle, loads the surface with the integral of kappa v times the change
        of volume by each unknown ``3 * dof + coordinate``: the layer then rests where its own change is v.
        """
        elements = self._elements(assembler)
        corners, local = assembler.surface.triangles, assembler.dofs.element_dofs
        quadrature = assembler.quadrature(VOLUME_DEGREE)
        blocks = np.empty((len(elements), local.shape[1], 3, 3))
        for batch in batches(len(elements)):
            rows, weights = self._changes(assembler, elements[batch])
            blocks[batch] = np.einsum("mqci,mq,qk->mick", rows, weights, quadrature.barycentric, optimize=True)
        unknowns = 3 * local[elements][:, :, None, None] + np.arange(3)[None, None, :, None]
        vertices = corners[elements][:, None, None, :]
        where = (np.broadcast_to(unknowns, blocks.shape).ravel(), np.broadcast_to(vertices, blocks.shape).ravel())
        shape = (3 * assembler.dofs.n_dofs, assembler.surface.n_vertices)
        return csr_array((blocks.ravel(), where), shape=shape)

    def _elements(self, assembler: Assembler) -> IntArray:
        """Triangles under which there is a layer."""
        count = assembler.surface.n_vertices
        for name in ("stiffness", "thickness"):
            if len(getattr(self, name)) != count:
                raise FemError(
                    f"The layer has the {name} of {len(getattr(self, name))} vertices, the surface has {count}."
                )
        return np.flatnonzero((self.stiffness[assembler.surface.triangles] > 0.0).any(axis=1))

    def _changes(self, assembler: Assembler, elements: IntArray) -> tuple[FloatArray, FloatArray]:
        """Return (m, Q, 3, n) changes of volume per area by the n unknowns of each coordinate, and (m, Q) weights."""
        quadrature = assembler.quadrature(VOLUME_DEGREE)
        slopes = quadrature.physical_derivatives(elements)[0]
        shapes = quadrature.values(elements)
        count, points, size = shapes.shape
        slopes = slopes.reshape(count, points, 2, size)
        normals, dual = _frames(assembler, elements, slopes)
        own = assembler.surface.triangles[elements]
        half = 0.5 * self.thickness[own] @ quadrature.barycentric.T
        rows = normals[..., None] * shapes[:, :, None, :]
        rows += half[..., None, None] * np.einsum("mqkc,mqki->mqci", dual, slopes, optimize=True)
        stiffness = self.stiffness[own] @ quadrature.barycentric.T
        weights = stiffness * quadrature.weights * assembler.surface.areas[elements, None]
        return rows, weights


def _frames(assembler: Assembler, elements: IntArray, slopes: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return (m, Q, 3) unit normals and (m, Q, 2, 3) vectors e^k with div w = sum of e^k . dw/dk, k along s and t.

    On the smooth surface of the assembler if it has one, else on the flat triangles.
    """
    count, points = slopes.shape[:2]
    surface = assembler.surface
    if assembler.smooth_positions is None:
        normals = np.broadcast_to(surface.normals[elements][:, None], (count, points, 3))
        return normals, np.broadcast_to(surface.frames[elements][:, None], (count, points, 2, 3))
    geometry = assembler.smooth_positions[assembler.dofs.element_dofs[elements]]
    tangents = slopes @ geometry[:, None]
    across = np.cross(tangents[:, :, 0], tangents[:, :, 1])
    normals = across / np.maximum(np.linalg.norm(across, axis=-1, keepdims=True), FLATTEST)
    metric = tangents @ np.swapaxes(tangents, -1, -2)
    return normals, np.linalg.inv(metric) @ tangents
