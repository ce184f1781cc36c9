"""What moves the skin by itself, and of how much of each a displacement field is made.

Loads add up and the skin is linear, so every field is the weighted sum of what its sources do alone.
"""

from __future__ import annotations

from dataclasses import fields
from typing import Any

from facemodel.actions import JawMotion
from facemodel.face import Face
from facemodel.loads import contractions, springs_carry_jaw
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from facemodel.project import Project

Source = str | JawMotion
"""A muscle, by its key, or a motion of the jaw whose pull the tissue carries to the skin."""

Recipe = tuple[tuple[Source, float], ...]
"""Sources and their weights, in order."""

FOR_PEOPLE = {"name", "side", "title", "group", "linked", "colour"}
"""Members of a muscle that name, list or pair it and have no part in what it does."""


def recipes(project: Project) -> dict[str, Recipe]:
    """What every displacement field is made of, in the order of the units, left before right.

    Raises
    ------
    FaceError
        If a unit names a muscle that is not there on any side.
    """
    contracted = contractions(project.units, project.muscles)
    made: dict[str, Recipe] = {}
    for unit in project.units:
        carried = springs_carry_jaw(unit, project.muscles)
        for name in unit.fields:
            jaw = unit.jaw_of(name)
            made[name] = (*contracted[name].items(), *(((jaw, 1.0),) if jaw and carried else ()))
    return made


def acting(muscle: Muscle, face: Face) -> tuple[Any, ...]:
    """All that the action of a muscle depends on: its own members and the parts of the face it works on."""
    own = tuple(getattr(muscle, each.name) for each in fields(muscle) if each.name not in FOR_PEOPLE)
    on_skin = (face.skin.positions, face.skin.triangles)
    if MODELS[muscle.model].geometry == "skull":
        return own, on_skin, face.skull.jaw, face.skull.jawbone
    return own, on_skin
