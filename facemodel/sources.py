"""What moves the skin by itself, and of how much of each a displacement field is made.

Loads add up and the skin is linear, so every field is the weighted sum of what its sources do alone.
"""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np

from facemodel.actions import JawMotion, skin_units
from facemodel.face import Face, Jaw
from facemodel.jaw.modes import JawMode, mode_shares, modes_for, motion_of
from facemodel.loads import contractions, springs_carry_jaw
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from facemodel.project import Project
from fem.types import BoolArray

Source = str | JawMode
"""A muscle, by its key, or a mode of the jaw whose pull the tissue carries to the skin."""

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
    for unit in skin_units(project.units):
        carried = springs_carry_jaw(unit, project.muscles)
        for name in unit.fields:
            jaw = _jaw_recipe(project.face.skull.jaw, unit.jaw_of(name)) if carried else ()
            made[name] = (*contracted[name].items(), *jaw)
    return made


def _jaw_recipe(hinge: Jaw, motion: JawMotion | None) -> Recipe:
    if motion is None:
        return ()
    shares = mode_shares(hinge, motion_of(hinge, motion))
    return tuple((JawMode(number), float(share)) for number, share in enumerate(shares) if share)


def jaw_modes(project: Project) -> tuple[JawMode, ...]:
    """The modes of the jaw of which any sum of the project's units is made, as far as the tissue carries it."""
    carried = (unit.jaw for unit in project.units if springs_carry_jaw(unit, project.muscles))
    return modes_for([motion for motion in carried if motion is not None])


def jaw_carried(project: Project) -> BoolArray:
    """Whether (M,) the tissue carries the skin along with the jaw of each displacement field."""
    carried = [springs_carry_jaw(unit, project.muscles) for unit in skin_units(project.units) for _ in unit.fields]
    return np.array(carried, dtype=np.bool_)


def acting(muscle: Muscle, face: Face) -> tuple[Any, ...]:
    """All that the action of a muscle depends on: its own members and the parts of the face it works on."""
    own = tuple(getattr(muscle, each.name) for each in fields(muscle) if each.name not in FOR_PEOPLE)
    on_skin = (face.skin.positions, face.skin.triangles)
    if MODELS[muscle.model].geometry == "skull":
        return own, on_skin, face.skull.jaw, face.skull.jawbone
    return own, on_skin
