"""The one interface of all muscle models: given a skin, return forces per area."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from facemodel.mesh import Mesh
from facemodel.muscles.fibre import fibre_forces
from facemodel.muscles.lid import lid_forces
from facemodel.muscles.muscle import Muscle
from facemodel.muscles.sphincter import sphincter_forces
from fem.types import FloatArray

MODELS: Mapping[str, Callable[[Muscle, Mesh], FloatArray]] = {
    "fibre": fibre_forces,
    "sphincter": sphincter_forces,
    "lid": lid_forces,
}
"""Muscle models by the name a muscle carries."""


def muscle_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Force per area (N, 3) on the skin at full contraction of a muscle, N/mm^2."""
    return MODELS[muscle.model](muscle, skin)
