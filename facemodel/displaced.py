"""What muscles add to the solved fields that displace vertices and know no forces."""

from __future__ import annotations

import numpy as np

from facemodel.loads import field_sums
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS, muscle_action
from facemodel.project import Project
from facemodel.sampling import HeadSurface, SolvedRegion
from fem import SmoothInterpolation, Support, Supports
from fem.types import FloatArray

MEMBRANE = 0.05
"""1/mm^2, weight of slopes against curvatures when a field known at the vertices is made smooth between them."""


def displaces(muscle: Muscle) -> bool:
    """Whether a muscle displaces the skin's vertices instead of pulling on them."""
    return MODELS[muscle.model].action == "displacement"


def displacements(project: Project) -> FloatArray:
    """Displacement (M, N, 3) of the skin's vertices by every field, millimetres, zero where the face is held.

    Raises
    ------
    FaceError
        If a unit names a muscle that is not there on any side.
    """
    face = project.face
    actions = {muscle.key: muscle_action(muscle, face) for muscle in project.muscles if displaces(muscle)}
    still = np.zeros((len(face.skin.positions), 3))
    actions |= {muscle.key: still for muscle in project.muscles if not displaces(muscle)}
    _, sums = field_sums(project.units, project.muscles, actions, face)
    return sums


def displaced_fields(project: Project, head: HeadSurface, region: SolvedRegion, held: Supports) -> FloatArray | None:
    """Coefficients (n_dofs, 3, M) that displacing muscles add to the solved fields, or None if there are none.

    The displacements of the vertices are made smooth between them by the element (see
    `facemodel.sculpted`); a vertex whose value is held by a support stays.

    Parameters
    ----------
    project : whose muscles act
    head, region : the smooth surface of the head and the solved part of it
    held : supports of the vertices of the region
    """
    if not any(displaces(muscle) for muscle in project.muscles):
        return None
    fields = displacements(project)
    moving = region.vertices[~np.isin(held.kinds, (Support.VALUE, Support.CLAMPED))]
    at_vertices = np.zeros((fields.shape[1], 3 * len(fields)))
    at_vertices[moving] = fields[:, moving].transpose(1, 2, 0).reshape(len(moving), -1)
    used = np.flatnonzero(at_vertices.any(axis=0))
    coefficients = np.zeros((len(region.dofs), at_vertices.shape[1]))
    if len(used):
        smooth = SmoothInterpolation(head.assembler, MEMBRANE)(at_vertices[:, used])
        coefficients[:, used] = smooth[region.dofs]
        # Past a clamped rim the skin rests: it keeps its tangents there.
        coefficients[held.held_dofs(region.assembler.dofs)] = 0.0
    return coefficients.reshape(len(region.dofs), 3, -1)
