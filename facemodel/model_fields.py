"""What one muscle does to a face under every model that can work on it, side by side."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.display import DisplaySurface
from facemodel.laying.influence import side_by_side
from facemodel.muscles import Muscle
from facemodel.muscles.muscle import Model
from facemodel.project import Project
from facemodel.solution import Progress, silent
from facemodel.solver import FaceSolver
from fem.types import Float32Array


@dataclass(frozen=True, eq=False)
class ModelField:
    """What a muscle does at full contraction under one model.

    Attributes
    ----------
    displacement : (P, 3) of the drawn points of the skin, millimetres
    largest : of them, millimetres
    cosine : of the angle to the field of the muscle's own model, over all points; none where one of both does nothing
    """

    displacement: Float32Array
    largest: float
    cosine: float | None


@dataclass(frozen=True, eq=False)
class ModelFields:
    """A muscle under all of its models.

    Attributes
    ----------
    muscle : as it was compared
    display : the drawn skin at rest
    fields : by model, in the order in which they are offered
    """

    muscle: Muscle
    display: DisplaySurface
    fields: Mapping[Model, ModelField]

    @property
    def largest(self) -> float:
        """The largest displacement under any model, millimetres."""
        return max(field.largest for field in self.fields.values())


def model_fields(
    project: Project, muscle: Muscle, solver: FaceSolver | None = None, progress: Progress = silent
) -> ModelFields:
    """Solve a face for one muscle under each model that can work on what it is made of.

    Strength and width are the muscle's own under every model, and nothing else contracts.

    Parameters
    ----------
    project : whose face is solved; the muscle need not be in it
    muscle : what contracts fully
    solver : keeps the factorised face from one comparison to the next
    progress : told of every step; may raise `Cancelled`

    Raises
    ------
    FaceError, Cancelled
        As `FaceSolver.solve` does.
    """
    models = side_by_side(muscle)
    trial = _trial(project, models)
    basis = (solver or FaceSolver()).solve(trial, progress).basis
    ways = {model: basis.field(name) for model, name in zip(models, basis.names, strict=True)}
    own = ways[muscle.model]
    fields = {
        model: ModelField(way, float(np.linalg.norm(way, axis=1).max()), _cosine(way, own))
        for model, way in ways.items()
    }
    return ModelFields(muscle, basis.display, fields)


def _trial(project: Project, models: Mapping[Model, Muscle]) -> Project:
    """A project with nothing but one muscle under each model, and a unit that contracts it."""
    muscles = tuple(
        replace(each, name=f"{each.name}_{model}", side="M", linked=False) for model, each in models.items()
    )
    units = tuple(
        ActionUnit(number, muscle.name, "upper", False, {muscle.name: 1.0}, 1.0)
        for number, muscle in enumerate(muscles, start=1)
    )
    return replace(project, muscles=muscles, units=units, emotions=(), expression={}, corrections={})


def _cosine(one: Float32Array, other: Float32Array) -> float | None:
    first, second = one.astype(np.float64).ravel(), other.astype(np.float64).ravel()
    size = float(np.linalg.norm(first) * np.linalg.norm(second))
    return float(first @ second) / size if size > 0 else None
