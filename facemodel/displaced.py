"""What muscles add to the solved fields that displace vertices and know no forces."""

from __future__ import annotations

import numpy as np

from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from facemodel.sampling import SolvedRegion
from fem import SmoothInterpolation, Support, Supports
from fem.types import FloatArray

MEMBRANE = 0.05
"""1/mm^2, weight of slopes against curvatures when a field known at the vertices is made smooth between them."""


def displaces(muscle: Muscle) -> bool:
    """Whether a muscle displaces the skin's vertices instead of pulling on them."""
    return MODELS[muscle.model].action == "displacement"


def displaced_columns(
    displacements: FloatArray, smooth: SmoothInterpolation, region: SolvedRegion, held: Supports
) -> FloatArray:
    """Coefficients (n_dofs, 3, M) of displacements that are known at the skin's vertices.

    They are made smooth between the vertices by the element (see `facemodel.sculpted`); a vertex whose value is
    held by a support stays, and so does all of the skin that is not solved.

    Parameters
    ----------
    displacements : (M, N, 3) of the skin's vertices, millimetres
    smooth : of the whole head, with the slopes weighted by `MEMBRANE`
    region : the solved part of it
    held : supports of the vertices of the region
    """
    moving = region.vertices[~np.isin(held.kinds, (Support.VALUE, Support.CLAMPED))]
    at_vertices = np.zeros((displacements.shape[1], 3 * len(displacements)))
    at_vertices[moving] = displacements[:, moving].transpose(1, 2, 0).reshape(len(moving), -1)
    coefficients = smooth(at_vertices)[region.dofs]
    # Past a clamped rim the skin rests: it keeps its tangents there.
    coefficients[held.held_dofs(region.assembler.dofs)] = 0.0
    return coefficients.reshape(len(region.dofs), 3, -1)
