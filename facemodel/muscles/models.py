"""The one interface of all muscle models: given a face, a muscle acts on its skin."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.muscles import parameters as of
from facemodel.muscles.cosine import cosine_displacements, cosine_ring_displacements
from facemodel.muscles.fibre import fibre_forces
from facemodel.muscles.fold import fold_forces
from facemodel.muscles.jaw import jaw_force
from facemodel.muscles.lid import lid_forces
from facemodel.muscles.mouth import mouth_forces
from facemodel.muscles.muscle import Model, Muscle
from facemodel.muscles.parameters import Parameter, ProfileParameter
from facemodel.muscles.pressure import pressure_forces
from facemodel.muscles.quadrilateral import quadrilateral_forces
from facemodel.muscles.sphincter import sphincter_forces
from fem.types import FloatArray

Geometry = Literal["fibres", "ring", "skull"]
Action = Literal["force", "displacement"]


@dataclass(frozen=True)
class MuscleModel:
    """A way to turn a muscle into what it does to the skin.

    Attributes
    ----------
    title : what people read
    source : where it comes from
    geometry : what it works on: the muscle's central fibres, its ring, or the skull alone
    action : ``force`` per area, N/mm^2, for which the face is solved, or ``displacement`` of the skin's
        vertices, mm, which is added to the solved field
    act : the action (N, 3) on the skin of a face at full contraction
    parameters : what a person may turn
    slides : whether forces that point into the bone are turned along it; the bone itself moves under the others
    inflates : whether it is a pressure from within, which brings the volume that it lifts the skin by
    along_skin : whether its fibres lie on the skin from end to end, where those of others begin on the bone
    """

    title: str
    source: str
    geometry: Geometry
    action: Action
    act: Callable[[Muscle, Face], FloatArray]
    parameters: tuple[Parameter | ProfileParameter, ...]
    slides: bool = True
    inflates: bool = False
    along_skin: bool = False


def _on_skin(model: Callable[[Muscle, Mesh], FloatArray]) -> Callable[[Muscle, Face], FloatArray]:
    return lambda muscle, face: model(muscle, face.skin)


MODELS: Mapping[Model, MuscleModel] = {
    "fibre": MuscleModel(
        "Fibres",
        "Koch, Gross and Bosshard 1998, eqs. 1 to 10",
        "fibres",
        "force",
        _on_skin(fibre_forces),
        (of.WIDTH, of.KAPPA, of.STRENGTH, of.COUNT),
    ),
    "quadrilateral": MuscleModel(
        "Quadrilateral sheet",
        "Choe, Lee and Ko 2001, eq. 1",
        "fibres",
        "force",
        _on_skin(quadrilateral_forces),
        (of.RADIUS, of.STRENGTH),
    ),
    "cosine": MuscleModel(
        "Cosine pseudo-muscle",
        "Hung and Huang 1995, linear",
        "fibres",
        "displacement",
        _on_skin(cosine_displacements),
        (of.RADIUS, of.SHARE, *of.BOX),
    ),
    "sphincter": MuscleModel(
        "Sphincter",
        "Koch, Gross and Bosshard 1998, section 3.1, with the lateral profile of eq. 8 across the ring",
        "ring",
        "force",
        _on_skin(sphincter_forces),
        (of.WIDTH, of.STRENGTH, of.FOCUS, of.INWARD, of.FORWARD),
    ),
    "mouth": MuscleModel(
        "Mouth sphincter with profiles",
        "Choe, Lee and Ko 2001, eq. 2",
        "ring",
        "force",
        _on_skin(mouth_forces),
        (of.WIDTH, of.STRENGTH, of.SIGMA, of.TAU),
    ),
    "cosine_ring": MuscleModel(
        "Cosine pseudo-sphincter",
        "Hung and Huang 1995, sphincter",
        "ring",
        "displacement",
        _on_skin(cosine_ring_displacements),
        (of.WIDTH, *of.FACTORS, *of.BOX),
    ),
    "lid": MuscleModel(
        "Levator of the lid",
        "a turn of the tarsal plate about the eyeball",
        "ring",
        "force",
        _on_skin(lid_forces),
        (of.STRENGTH, of.INWARD),
    ),
    "pressure": MuscleModel(
        "Pressure from within",
        "breath behind the skin, along its normal",
        "ring",
        "force",
        _on_skin(pressure_forces),
        (of.WIDTH, of.STRENGTH, of.INWARD),
        slides=False,
        inflates=True,
    ),
    "fold": MuscleModel(
        "Fold of the skin",
        "insertions along a line that draw the skin in, with the flesh standing up beside it",
        "fibres",
        "force",
        _on_skin(fold_forces),
        (of.WIDTH, of.STRENGTH),
        slides=False,
        along_skin=True,
    ),
    "jaw": MuscleModel(
        "Jaw force",
        "Choe, Lee and Ko 2001, eq. 3",
        "skull",
        "force",
        jaw_force,
        (of.STRENGTH,),
        slides=False,
    ),
}
"""Muscle models by the name that a muscle carries."""


def muscle_action(muscle: Muscle, face: Face) -> FloatArray:
    """What a muscle does to the skin at full contraction (N, 3): force per area or displacement, as its model says.

    Raises
    ------
    FaceError
        If the muscle has not what its model works on.
    """
    return MODELS[muscle.model].act(muscle, face)


def muscle_forces(muscle: Muscle, face: Face) -> FloatArray:
    """Force per area (N, 3) on the skin at full contraction, N/mm^2; none of a muscle that displaces."""
    if MODELS[muscle.model].action == "force":
        return muscle_action(muscle, face)
    return np.zeros_like(face.skin.positions)


def comparable_models(muscle: Muscle) -> tuple[Model, ...]:
    """The models that can work on what a muscle is made of, where it lies, in the order of the table."""
    has = {"fibres": bool(muscle.fibres), "ring": muscle.ring is not None, "skull": muscle.model == "jaw"}
    lies = MODELS[muscle.model].along_skin
    return tuple(name for name, model in MODELS.items() if has[model.geometry] and model.along_skin == lies)
