"""Fair the lips of a head: the targets of the base mesh waver there from vertex to vertex, the base mesh does not."""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import splu
from scipy.spatial import KDTree

from facemodel.smooth import smooth
from fem.types import FloatArray, IntArray

LENGTH = 1.0
"""Millimetres: waves of a target whose length is 2 pi of these lose half their height, longer ones hardly any and
shorter ones nearly all.  Vertices are some 2 mm from each other along a lip, and targets are rounded to 0.1 mm."""

LIPS = (6.0, 2.0)
"""Millimetres from the edges of the lips at which fairing begins, and within which it is full."""

CORNERS = (2.0, 6.0)
"""Millimetres from the corners of the mouth within which nothing is faired, and from where on all is: targets move the
corners by millimetres against the skin about them, which is the shape of the person."""

HELD = 1e-3
"""The share of `LENGTH` below which nothing moves; a target is faired with no smaller one."""


@dataclass(frozen=True)
class Seam:
    """Where the skin of the head meets the pocket of the mouth on the base mesh.

    Attributes
    ----------
    triangles : (T, 3) of the body, on both sides of it
    rim : (n,) base vertices of the edges of both lips
    corners : (2,) those in the corners of the mouth
    """

    triangles: IntArray
    rim: IntArray
    corners: IntArray


def with_fair_lips(base: FloatArray, shape: FloatArray, seam: Seam) -> FloatArray:
    """A shape (V, 3) whose lips differ as smoothly from those of the base shape (V, 3) as a thin plate bends.

    Of all displacements d' of the base mesh the one with the least integral of (l^4 (Lap d')^2 + (d' - d)^2), where d
    is that of the shape, and l is `LENGTH` beside the lips and none elsewhere.
    """
    rest = base[: seam.triangles.max() + 1]
    given = shape[: len(rest)] - rest
    from_lips, from_corners = (KDTree(rest[marks]).query(rest)[0] for marks in (seam.rim, seam.corners))
    share = smooth(from_lips, *LIPS) * smooth(from_corners, *CORNERS)
    free = np.flatnonzero(share > HELD)
    laplacian = csr_array(igl.cotmatrix(rest, seam.triangles))
    area = igl.massmatrix(rest, seam.triangles, igl.MASSMATRIX_TYPE_BARYCENTRIC).diagonal()
    near = np.unique(seam.triangles[np.isin(seam.triangles, free).any(axis=1)])
    rows = laplacian[near]
    bending = csr_array(rows.T @ diags_array(1 / area[near]) @ rows)[free]
    weight = area[free] / (LENGTH * share[free]) ** 4
    # Solved for what is taken away, so that all that is not free stays as it is.
    change = splu((bending[:, free] + diags_array(weight)).tocsc()).solve(-(bending @ given))
    faired = shape.copy()
    faired[free] += change
    return faired
