"""What a new muscle is like where it is laid, and what is drawn of muscles in the hand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from app.tools.sight import Ghost
from facemodel.displaced import displaces
from facemodel.face import Face
from facemodel.laying.checks import checked, shape_complaints
from facemodel.laying.collection import drafted_muscle, with_muscle
from facemodel.laying.influence import FAINT, Arrows, coarse
from facemodel.laying.sides import mirrored, partner
from facemodel.loads import along_bone
from facemodel.muscles import Fibre, Muscle
from facemodel.muscles.models import MODELS, muscle_action
from facemodel.project import Project
from fem.types import FloatArray

NEAR: Mapping[str, str] = {
    "brow": "brow",
    "supra": "brow",
    "frontal": "brow",
    "glabella": "brow",
    "eye": "eye",
    "upper_lid": "eye",
    "lower_lid": "eye",
    "lateral_orbit": "eye",
    "nas": "nose",
    "nose": "nose",
    "ala": "nose",
    "rhinion": "nose",
    "subnasale": "nose",
    "upper_lip": "lip",
    "upper_vermilion": "lip",
    "lower_lip": "lip",
    "lower_vermilion": "lip",
    "mid_philtrum": "lip",
    "cupid_bow": "lip",
    "mouth_corner": "lip",
    "chin": "chin",
    "pogonion": "chin",
    "menton": "chin",
}
"""Group of a muscle by how the name of the landmark begins that its attachment is nearest to; else the cheek's."""


def group_at(face: Face, place: FloatArray) -> str:
    """The group of muscles that a place (3,) on the skin suggests."""
    if not face.landmarks:
        return "cheek"
    names = list(face.landmarks)
    away = np.linalg.norm(face.skin.positions[list(face.landmarks.values())] - place, axis=1)
    nearest = names[int(np.argmin(away))]
    fitting = [start for start in NEAR if nearest.startswith(start)]
    return NEAR[max(fitting, key=len)] if fitting else "cheek"


def drafted(project: Project, fibre: Fibre) -> Muscle:
    """A new muscle of one fibre, as it may lie while it is drawn."""
    group = group_at(project.face, fibre.attachment)
    return drafted_muscle(project, f"{group.capitalize()} muscle", group, fibres=(fibre,))


def with_image(project: Project, muscle: Muscle, linked: bool) -> tuple[Muscle, ...]:
    """A muscle alone, or with its mirror image where both sides are changed together."""
    other = partner(project.muscles, muscle)
    if muscle.side == "M" or not muscle.linked or not (other.linked if other else linked):
        return (muscle,)
    return muscle, mirrored(muscle, project.face)


def put_in(project: Project, muscle: Muscle, linked: bool) -> Project:
    """A project with a changed muscle, or a new one, which gets a mirror image where both sides are laid together.

    Raises
    ------
    MuscleError
        If it cannot be used as it lies.
    """
    if any(each.key == muscle.key for each in project.muscles):
        return with_muscle(project, muscle)
    checked(muscle, project.face)
    return replace(project, muscles=(*project.muscles, *with_image(project, muscle, linked)))


def ghost(muscles: tuple[Muscle, ...], face: Face) -> Ghost:
    """What is drawn of muscles that are dragged: themselves, what the first one acts on, and what is wrong with it.

    Only what is seen at once is checked; whether it lies within the head is when the hand lets go.
    """
    first = coarse(muscles[0])
    wrong = next(shape_complaints(first), "")
    if wrong:
        return Ghost(muscles, complaint=wrong)
    action = muscle_action(first, face)
    size = np.linalg.norm(action, axis=1)
    most = float(size.max())
    if most == 0:
        far = f"“{first.title}” reaches no vertex of the skin; make it wider, or move it there."
        return Ghost(muscles, complaint=far if first.strength and not displaces(first) else "")
    model = MODELS[first.model]
    vectors = along_bone(action, face.skin.normals) if model.action == "force" and model.slides else action
    felt = np.flatnonzero(size > FAINT * most)
    arrows = Arrows(felt, face.skin.positions[felt], vectors[felt], model.action)
    return Ghost(muscles, size / most, most, arrows)
