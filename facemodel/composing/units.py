"""The action units of a project: make, change, rename, split, join and delete, with what names their fields."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from facemodel.actions import ActionUnit, Emotion, Group, JawMotion, resolve
from facemodel.errors import ActionError, UnknownNameError
from facemodel.project import Project

FIRST_OWN = 101
"""Number of the first unit that is a user's own; FACS itself ends below it."""

LONGEST_NAME = 100
"""Characters of a name, as in the project file."""

LARGEST_WEIGHT = 10.0
"""Activation of a muscle in a unit; more of it would belong into the muscle's strength."""

LARGEST_DEGREES, LARGEST_SLIDE = 45.0, 15.0
"""Opening and slide of a jaw that is not dislocated."""

USUAL_AMPLITUDE = 5.0
"""Millimetres that a new unit is to move the skin."""


@dataclass(frozen=True, eq=False)
class UnitDeletion:
    """What is left when units are deleted: the project without them, and the names of the emotions that used them."""

    project: Project
    users: tuple[str, ...]


def unit_of(project: Project, number: int) -> ActionUnit:
    """The unit with a number; raises `UnknownNameError` if there is none."""
    for unit in project.units:
        if unit.number == number:
            return unit
    raise UnknownNameError(f"There is no action unit {number}; this face has {_numbers(project.units)}.")


def free_number(project: Project) -> int:
    """The first number that no unit of the user's own range has."""
    taken = {unit.number for unit in project.units}
    return next(number for number in range(FIRST_OWN, FIRST_OWN + len(taken) + 1) if number not in taken)


def free_name(project: Project, wanted: str) -> str:
    """A name that no unit has: the one that is wanted, else with the first free number."""
    taken = {unit.name.lower() for unit in project.units}
    tries = (wanted, *(f"{wanted} {k}" for k in range(2, len(taken) + 3)))
    return next(name for name in tries if name.lower() not in taken)


def checked_name(project: Project, name: str, but: int | None = None) -> str:
    """The name itself, without white space at its ends, if a unit may have it.

    Parameters
    ----------
    but : number of the unit whose own name counts as free

    Raises
    ------
    ActionError
        If it is empty, too long, reads like a number or a side, or is taken.
    """
    plain = " ".join(name.split())
    if not plain or len(plain) > LONGEST_NAME:
        raise ActionError(f"An action unit needs a name of 1 to {LONGEST_NAME} characters.")
    if re.fullmatch(r"(au ?)?\d+ ?[lr]?", plain, re.IGNORECASE) or re.search(r"\s[lr]$", plain, re.IGNORECASE):
        raise ActionError(f"“{plain}” reads like a number or a side; give the unit a name in words.")
    for unit in project.units:
        if unit.name.lower() == plain.lower() and unit.number != but:
            raise ActionError(f"Action unit {unit.number} is called “{unit.name}” already; choose another name.")
    return plain


def with_unit(project: Project, unit: ActionUnit) -> Project:
    """A project with a new unit at its end, or with a changed one in place; raises `ActionError` if it cannot be so."""
    checked_name(project, unit.name, but=unit.number)
    checked_unit(unit)
    if all(each.number != unit.number for each in project.units):
        return replace(project, units=(*project.units, unit))
    return replace(project, units=tuple(unit if each.number == unit.number else each for each in project.units))


def checked_unit(unit: ActionUnit) -> ActionUnit:
    """The unit itself, if its numbers are possible; raises `ActionError` otherwise."""
    for muscle, weight in unit.muscles.items():
        if not -LARGEST_WEIGHT <= weight <= LARGEST_WEIGHT:
            raise ActionError(
                f"The activation {weight:g} of “{muscle}” in action unit {unit.number} is not possible; "
                f"it has to be between {-LARGEST_WEIGHT:g} and {LARGEST_WEIGHT:g}."
            )
    jaw = unit.jaw or JawMotion(0.0)
    if not (abs(jaw.degrees) <= LARGEST_DEGREES and abs(jaw.slide) <= LARGEST_SLIDE):
        raise ActionError(
            f"Action unit {unit.number} would open the jaw by {jaw.degrees:g}° and slide it by {jaw.slide:g} mm; "
            f"at most {LARGEST_DEGREES:g}° and {LARGEST_SLIDE:g} mm are possible."
        )
    return unit


def new_unit(project: Project, name: str = "New action", group: Group = "upper") -> tuple[Project, int]:
    """A project with one more unit, which contracts nothing yet; also the unit's number."""
    number = free_number(project)
    unit = ActionUnit(number, free_name(project, name), group, True, {}, USUAL_AMPLITUDE)
    return with_unit(project, unit), number


def duplicated(project: Project, number: int) -> tuple[Project, int]:
    """A project with a copy of a unit behind it; also the copy's number."""
    unit = unit_of(project, number)
    copy = replace(unit, number=free_number(project), name=free_name(project, f"{unit.name} copy"))
    place = project.units.index(unit) + 1
    return replace(project, units=(*project.units[:place], copy, *project.units[place:])), copy.number


def renamed(project: Project, number: int, name: str) -> Project:
    """A project in which a unit has another name, in its emotions too; raises `ActionError` if it cannot have it."""
    unit = unit_of(project, number)
    changed = replace(unit, name=checked_name(project, name, but=number))
    return replace(with_unit(project, changed), emotions=_by_field(project, unit, project.emotions))


def paired(project: Project, number: int, apart: bool) -> Project:
    """A project in which a unit has fields of its own for left and right, or one for both.

    Emotions and the expression in hand stay what they are; where left and right differ, one field for both gets the
    larger weight.
    """
    unit = unit_of(project, number)
    if unit.paired == apart:
        return project
    changed = replace(unit, paired=apart)
    emotions = tuple(
        replace(emotion, weights=_moved(emotion.weights, unit, changed))
        for emotion in _by_field(project, unit, project.emotions)
    )
    expression = _moved(project.expression, unit, changed)
    return replace(with_unit(project, changed), emotions=emotions, expression=dict(sorted(expression.items())))


def deleted(project: Project, number: int) -> UnitDeletion:
    """A project without a unit; the emotions and the expression let go of it."""
    unit = unit_of(project, number)
    emotions = _by_field(project, unit, project.emotions)
    users = tuple(emotion.name for emotion in emotions if emotion.weights.keys() & set(unit.fields))
    left = replace(
        project,
        units=tuple(each for each in project.units if each is not unit),
        emotions=tuple(
            replace(emotion, weights=_without(emotion.weights, unit)) if emotion.name in users else emotion
            for emotion in emotions
        ),
        expression=_without(project.expression, unit),
    )
    return UnitDeletion(left, users)


def with_weight(unit: ActionUnit, muscle: str, weight: float) -> ActionUnit:
    """A unit that contracts a muscle, by its name without side, with another activation."""
    return replace(unit, muscles={**unit.muscles, muscle: float(weight)})


def without_muscle(unit: ActionUnit, muscle: str) -> ActionUnit:
    """A unit that lets go of a muscle."""
    return replace(unit, muscles={name: weight for name, weight in unit.muscles.items() if name != muscle})


def with_jaw(unit: ActionUnit, degrees: float, slide: float) -> ActionUnit:
    """A unit that moves the jaw; one that moves it by nothing leaves it alone."""
    return replace(unit, jaw=JawMotion(float(degrees), float(slide)) if degrees or slide else None)


def scaled(unit: ActionUnit, factor: float) -> ActionUnit:
    """A unit whose muscles contract, and whose jaw opens, by another factor; the jaw slides as before."""
    jaw = None if unit.jaw is None else replace(unit.jaw, degrees=unit.jaw.degrees * factor)
    return replace(unit, muscles={name: weight * factor for name, weight in unit.muscles.items()}, jaw=jaw)


def _by_field(project: Project, unit: ActionUnit, emotions: Iterable[Emotion]) -> tuple[Emotion, ...]:
    """The same emotions, in which a unit is named by its fields or its number and never by its name."""

    def plain(weights: Mapping[str, float]) -> dict[str, float]:
        told: dict[str, float] = {}
        for name, weight in weights.items():
            fields = resolve(name, project.units)
            for each in fields if set(fields) <= set(unit.fields) else (name,):
                told[each] = weight
        return told

    return tuple(
        emotion
        if all(not set(resolve(name, project.units)) <= set(unit.fields) for name in emotion.weights)
        else replace(emotion, weights=plain(emotion.weights))
        for emotion in emotions
    )


def _moved(weights: Mapping[str, float], unit: ActionUnit, changed: ActionUnit) -> dict[str, float]:
    """Weights by field of a unit in its new fields."""
    own = [weights[field] for field in unit.fields if field in weights]
    kept = _without(weights, unit)
    return {**kept, **dict.fromkeys(changed.fields, max(own))} if own else kept


def _without(weights: Mapping[str, float], unit: ActionUnit) -> dict[str, float]:
    return {name: weight for name, weight in weights.items() if name not in unit.fields}


def _numbers(units: Iterable[ActionUnit]) -> str:
    return ", ".join(str(unit.number) for unit in units) or "none yet"
