"""Change the numbers, the model and the names for people of one muscle."""

from __future__ import annotations

import re
from dataclasses import replace
from math import isfinite

from facemodel.errors import MuscleError
from facemodel.laying.checks import complaints_of, shape_complaints
from facemodel.muscles import Muscle, Profile
from facemodel.muscles.models import MODELS, comparable_models
from facemodel.muscles.muscle import Model
from facemodel.muscles.parameters import Parameter, ProfileParameter, value_of, with_value

GROUPS = ("brow", "eye", "nose", "cheek", "lip", "chin")
"""Groups of muscles, from top to bottom."""


COLOUR = re.compile(r"#[0-9a-f]{6}")


def parameter_of(muscle: Muscle, name: str) -> Parameter | ProfileParameter:
    """The parameter of a muscle's model by its name.

    Raises
    ------
    MuscleError
        If its model has no such parameter.
    """
    model = MODELS[muscle.model]
    for parameter in model.parameters:
        if parameter.name == name:
            return parameter
    known = ", ".join(parameter.name for parameter in model.parameters)
    raise MuscleError(f"“{muscle.key}” ({model.title}) has no parameter “{name}”; it has {known}.")


def changed(muscle: Muscle, name: str, value: float | Profile) -> Muscle:
    """A muscle with another value of one parameter.

    Parameters
    ----------
    name : of a parameter of its model, for example ``width``, ``kappa``, ``ring.focus`` or ``profiles.sigma``
    value : within its range

    Raises
    ------
    MuscleError
        If there is no such parameter, or the value is out of its range.
    """
    parameter = parameter_of(muscle, name)
    if isinstance(parameter, ProfileParameter) != isinstance(value, Profile):
        kind = "a profile of knots" if isinstance(parameter, ProfileParameter) else "a number"
        raise MuscleError(f"“{parameter.title}” of “{muscle.key}” is {kind}; give it one.")
    if isinstance(parameter, Parameter) and parameter.whole and not isinstance(value, Profile) and isfinite(value):
        value = round(value)
    result = with_value(muscle, name, value)
    for complaint in complaints_of(result, parameter):
        raise MuscleError(complaint)
    return result


def reset(muscle: Muscle, name: str) -> Muscle:
    """A muscle with the default of one parameter.

    Raises
    ------
    MuscleError
        If there is no such parameter.
    """
    return with_value(muscle, name, parameter_of(muscle, name).default)


def values(muscle: Muscle) -> dict[str, float | Profile]:
    """The value of every parameter of a muscle's model, by name and in the order of a panel."""
    return {parameter.name: value_of(muscle, parameter.name) for parameter in MODELS[muscle.model].parameters}


def with_model(muscle: Muscle, model: Model) -> Muscle:
    """A muscle that acts by another model on what it is made of; its other values stay for the way back.

    Raises
    ------
    MuscleError
        If the muscle has not what that model works on.
    """
    turned = replace(muscle, model=model)
    for complaint in shape_complaints(turned):
        fitting = ", ".join(MODELS[name].title.lower() for name in comparable_models(muscle))
        raise MuscleError(f"{complaint} Without it “{muscle.key}” can be: {fitting}.")
    return turned


def titled(muscle: Muscle, title: str) -> Muscle:
    """A muscle with another Latin name for people.

    Raises
    ------
    MuscleError
        If nothing is left of the title.
    """
    if not title.strip():
        raise MuscleError(f"“{muscle.key}” needs a title; type a name for people.")
    return replace(muscle, title=title.strip())


def grouped(muscle: Muscle, group: str) -> Muscle:
    """A muscle in another group, which decides its colour.

    Raises
    ------
    MuscleError
        If there is no such group.
    """
    if group not in GROUPS:
        raise MuscleError(f"There is no group “{group}” of muscles; choose one of {', '.join(GROUPS)}.")
    return replace(muscle, group=group)


def coloured(muscle: Muscle, colour: str) -> Muscle:
    """A muscle in a colour of its own, ``#rrggbb``, or in that of its group if the colour is empty.

    Raises
    ------
    MuscleError
        If that is no colour.
    """
    if colour and not COLOUR.fullmatch(colour.lower()):
        raise MuscleError(f"“{colour}” is no colour; write it as #rrggbb, or nothing for that of the group.")
    return replace(muscle, colour=colour.lower())
