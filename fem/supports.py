"""Where the surface is held."""

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from fem.dofs import DofMap
from fem.errors import FemError
from fem.types import BoolArray, FloatArray, IntArray


class Support(IntEnum):
    """How a vertex is held."""

    FREE = 0
    VALUE = 1
    """All three coordinates of the displacement are prescribed; the slopes are free."""
    CLAMPED = 2
    """Displacement and slopes are prescribed; with HCT-12 also the normal slope of edges between two such."""
    SLIDING = 3
    """The displacement along a normal is prescribed; within the plane the vertex is free."""


@dataclass(frozen=True, eq=False)
class Supports:
    """The support of every vertex.

    Parameters
    ----------
    kinds
        (N,) values of `Support`.
    normals
        (N, 3) direction that is held at sliding vertices, of any length; other rows are ignored. Needed only
        when a vertex slides.

    Raises
    ------
    FemError
        If a kind is unknown, or a sliding vertex has no normal.
    """

    kinds: IntArray
    normals: FloatArray | None = None

    def __post_init__(self) -> None:
        bad = np.flatnonzero(~np.isin(self.kinds, list(Support)))
        if len(bad):
            raise FemError(f"Vertex {bad[0]} has the unknown kind of support {self.kinds[bad[0]]}.")
        sliding = self.sliding
        if len(sliding) == 0:
            return
        if self.normals is None or self.normals.shape != (len(self.kinds), 3):
            raise FemError(f"Sliding supports need normals of shape ({len(self.kinds)}, 3).")
        length = np.linalg.norm(self.normals[sliding], axis=1)
        bad = sliding[~(np.isfinite(length) & (length > 0.0))]
        if len(bad):
            raise FemError(f"Vertex {bad[0]} slides but its normal is {self.normals[bad[0]].tolist()}.")

    @property
    def sliding(self) -> IntArray:
        """(k,) vertices that slide."""
        return np.flatnonzero(np.asarray(self.kinds) == Support.SLIDING)

    def held_dofs(self, dofs: DofMap) -> BoolArray:
        """Return (n_dofs,) True where all three coordinates of a degree of freedom are prescribed.

        Raises
        ------
        FemError
            If there is not one support per vertex.
        """
        surface = dofs.surface
        if len(self.kinds) != surface.n_vertices:
            raise FemError(f"There are {len(self.kinds)} supports for {surface.n_vertices} vertices.")
        clamped = np.asarray(self.kinds) == Support.CLAMPED
        held = np.zeros(dofs.n_dofs, dtype=np.bool_)
        held[dofs.value_dofs] = clamped | (np.asarray(self.kinds) == Support.VALUE)
        held[dofs.value_dofs + 1] = held[dofs.value_dofs + 2] = clamped
        if dofs.element.dofs_per_edge:
            held[3 * surface.n_vertices :] = clamped[surface.edges].all(axis=1)
        return held

    def sliding_frames(self) -> FloatArray:
        """Return (k, 3, 3) rotations of the sliding vertices; the first column is the held direction."""
        sliding = self.sliding
        if self.normals is None or len(sliding) == 0:
            return np.empty((0, 3, 3))
        normal = self.normals[sliding]
        normal = normal / np.linalg.norm(normal, axis=1, keepdims=True)
        least = np.eye(3)[np.abs(normal).argmin(axis=1)]
        first = np.cross(normal, least)
        first /= np.linalg.norm(first, axis=1, keepdims=True)
        return np.stack([normal, first, np.cross(normal, first)], axis=2)
