"""Where and how strongly muscles pull on the skin of a project."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from facemodel.actions import Expression
from facemodel.face import Face
from facemodel.loads import bone_forces, contractions
from facemodel.muscles import Muscle
from facemodel.muscles.models import muscle_action
from facemodel.project import Project
from fem.types import FloatArray


@lru_cache(maxsize=256)
def muscle_pull(muscle: Muscle, face: Face) -> FloatArray:
    """How strongly (N,) a muscle acts on each skin vertex at full contraction, N/mm^2 or mm as its model says."""
    return np.linalg.norm(muscle_action(muscle, face), axis=1)


def muscle_named(project: Project, key: str) -> Muscle | None:
    """The muscle with a key, if the project has it."""
    return next((muscle for muscle in project.muscles if muscle.key == key), None)


@lru_cache(maxsize=256)
def muscle_force(muscle: Muscle, face: Face) -> FloatArray:
    """Force per area (N, 3) of a muscle on the skin at full contraction, N/mm^2, turned along the bone."""
    return bone_forces(muscle, face)


class FieldForces:
    """Force per area of the fields of a project; other activations of the same muscles cost next to nothing.

    Parameters
    ----------
    project : its units, muscles and skin
    """

    def __init__(self, project: Project) -> None:
        self._contracted = contractions(project.units, project.muscles)
        self._muscles = {muscle.key: muscle for muscle in project.muscles}
        self._face = project.face

    def of(self, expression: Expression) -> FloatArray:
        """Force per area (N, 3) on the skin of an expression, N/mm^2."""
        pulls: dict[str, float] = {}
        for name, weight in expression.items():
            for key, activation in self._contracted.get(name, {}).items():
                pulls[key] = pulls.get(key, 0.0) + weight * activation
        total = np.zeros_like(self._face.skin.positions)
        for key, pull in pulls.items():
            if pull:
                total += pull * muscle_force(self._muscles[key], self._face)
        return total


def activations(project: Project, expression: Expression) -> dict[str, float]:
    """Contraction of every muscle by key in an expression; full at the largest that one unit alone asks of it."""
    pulled: dict[str, float] = {}
    largest: dict[str, float] = {}
    keys = {muscle.key for muscle in project.muscles}
    for unit in project.units:
        for field in unit.fields:
            weight = abs(expression.get(field, 0.0))
            sides = (field[-1],) if unit.paired else ("L", "R")
            for name, share in unit.muscles.items():
                for key in [name] if name in keys else [f"{name}_{side}" for side in sides]:
                    pulled[key] = pulled.get(key, 0.0) + weight * abs(share)
                    largest[key] = max(largest.get(key, 0.0), abs(share))
    return {key: min(1.0, value / largest[key]) for key, value in pulled.items() if largest[key] > 0}
