"""Action units: make, name, weigh, split and delete them, with the weights that hang on them."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace

from app.authoring.renaming import refielded, spelled
from app.authoring.unit_names import BY_NUMBER, checked_name, checked_number, free_name, free_number
from app.errors import UnitError
from facemodel.actions import EXAGGERATED, GROUP_TITLES, ActionUnit, Group, JawMotion, resolve
from facemodel.errors import UnknownNameError
from facemodel.facs import action_units
from facemodel.muscles.muscle import Model
from facemodel.project import Project
from facemodel.sculpting.correction import copied

LONGEST_NOTE = 20_000

LARGEST_ACTIVATION = 20.0
"""Times a muscle's strength; what the shipped units ask of their muscles stays far below."""

LET_GO: frozenset[Model] = frozenset({"lid"})
"""Models of muscles that hold at rest, so that a unit may also relax them: below zero the levator lets its lid sink."""

WIDEST = 60.0
"""Degrees of opening; no jaw opens wider than 45."""

SMALLEST_LIMIT = 0.05
"""A slider that goes less far shows nothing."""

FARTHEST = 30.0
"""Millimetres of slide or shift; condyles slide 15, and incisors go 12 aside."""


def unit_of(project: Project, number: int) -> ActionUnit:
    """The action unit with a number.

    Raises
    ------
    UnknownNameError
        If there is none.
    """
    for unit in project.units:
        if unit.number == number:
            return unit
    known = ", ".join(str(unit.number) for unit in project.units) or "none yet"
    raise UnknownNameError(f"There is no action unit {number}; this face has {known}.")


def with_new_unit(
    project: Project, name: str = "", group: Group = "diagonal", number: int | None = None
) -> tuple[Project, int]:
    """A project with one more unit, in which nothing moves yet.

    Returns
    -------
    project : with the unit at the end
    number : of the unit

    Raises
    ------
    UnitError
        If the number or the name is taken or cannot be one.
    """
    own = free_number(project) if number is None else checked_number(project, number)
    title = checked_name(project, name) if name else free_name(project, "new action")
    unit = ActionUnit(own, title, group, True, {}, 0.0)
    return replace(project, units=(*project.units, unit)), own


def with_duplicate(project: Project, number: int) -> tuple[Project, int]:
    """A project with a copy of a unit behind it; also its number."""
    unit = unit_of(project, number)
    copy = replace(unit, number=free_number(project), name=free_name(project, f"{unit.name} copy"))
    place = project.units.index(unit) + 1
    sculpted = dict(zip(unit.fields, copy.fields, strict=True))
    return replace(
        project,
        units=(*project.units[:place], copy, *project.units[place:]),
        corrections=copied(project.corrections, sculpted),
    ), copy.number


def renamed(project: Project, number: int, name: str) -> Project:
    """A project in which a unit has another name; raises `UnitError` if it is taken or empty."""
    unit = unit_of(project, number)
    made = with_unit(project, replace(unit, name=checked_name(project, name, but=unit)))
    names = {each for emotion in project.emotions for each in emotion.weights}
    by_name = {each for each in names if not BY_NUMBER.fullmatch(each.strip())}
    return spelled(made, {each: resolve(each, project.units) for each in by_name})


def renumbered(project: Project, number: int, to: int) -> Project:
    """A project in which a unit has another number, as have its weights in expression and emotions.

    A unit that nobody has said yet how far it moves the skin takes that, and its group, from the table of FACS.
    """
    unit = unit_of(project, number)
    if to == number:
        return project
    new = replace(unit, number=checked_number(project, to))
    table = None if unit.amplitude else next((each for each in action_units() if each.number == to), None)
    if table is not None:
        new = replace(new, group=table.group, amplitude=table.amplitude)
    fields = dict(zip(unit.fields, new.fields, strict=True))
    return refielded(project, {number: new}, lambda name: fields.get(name, name))


def with_activation(project: Project, number: int, muscle: str, weight: float) -> Project:
    """A project in which a unit contracts a muscle more or less; 0 takes the muscle out of it.

    Parameters
    ----------
    muscle : by its name without side
    weight : times the muscle's strength at weight 1 of the unit; below zero a lid lets go

    Raises
    ------
    UnitError
        If the muscle cannot be contracted so, see `check_activation`.
    UnknownNameError
        If there is no such unit or muscle.
    """
    unit = unit_of(project, number)
    check_activation(project, muscle, weight)
    muscles = {name: each for name, each in unit.muscles.items() if name != muscle or weight}
    return with_unit(project, replace(unit, muscles={**muscles, muscle: float(weight)} if weight else muscles))


def check_activation(project: Project, muscle: str, weight: float) -> None:
    """See that a muscle, by its name without side, can be contracted so.

    Raises
    ------
    UnitError
        If the weight is not a number, or beyond `LARGEST_ACTIVATION`, or below zero for a muscle that can only pull.
    UnknownNameError
        If there is no such muscle.
    """
    models = {each.model for each in project.muscles if each.name == muscle}
    if not models:
        raise UnknownNameError(f"There is no muscle “{muscle}” to contract; lay it first.")
    lets_go = models <= LET_GO
    if weight < 0 and not lets_go:
        raise UnitError(f"The activation of {muscle} is {weight:g}, but a muscle only pulls; choose 0 or more.")
    least = -LARGEST_ACTIVATION if lets_go else 0.0
    check_range(f"The activation of {muscle}", weight, least, LARGEST_ACTIVATION, "")


def with_jaw(project: Project, number: int, degrees: float, slide: float = 0.0, side: float = 0.0) -> Project:
    """A project in which a unit opens the jaw by degrees, and slides it forward and to the left by millimetres.

    Raises
    ------
    UnitError
        If one of the numbers is out of range.
    """
    unit = unit_of(project, number)
    check_range("The opening of the jaw", degrees, -WIDEST, WIDEST, "°")
    check_range("The slide of the jaw", slide, -FARTHEST, FARTHEST, " mm")
    check_range("The shift of the jaw", side, -FARTHEST, FARTHEST, " mm")
    return with_unit(project, replace(unit, jaw=JawMotion(float(degrees), float(slide), float(side)) or None))


def with_note(project: Project, number: int, note: str) -> Project:
    """A project in which a unit has another line for people."""
    if len(note) > LONGEST_NOTE:
        raise UnitError(f"The note has {len(note):,} characters; keep it within {LONGEST_NOTE:,}.")
    return with_unit(project, replace(unit_of(project, number), note=note.strip()))


def with_limit(project: Project, number: int, limit: float) -> Project:
    """A project in which the sliders of a unit go no farther than a weight; what is shown goes back to it.

    Raises
    ------
    UnitError
        If the limit is not a number from `SMALLEST_LIMIT` to the largest weight there is.
    """
    unit = unit_of(project, number)
    check_range("The limit", limit, SMALLEST_LIMIT, EXAGGERATED, "")
    own = set(unit.fields)
    expression = {name: min(each, limit) if name in own else each for name, each in project.expression.items()}
    return with_unit(replace(project, expression=expression), replace(unit, limit=float(limit)))


def with_group(project: Project, number: int, group: Group) -> Project:
    """A project in which a unit is listed elsewhere; raises `UnitError` if there is no such group."""
    if group not in GROUP_TITLES:
        raise UnitError(f"There is no group “{group}” of action units; choose one of {', '.join(GROUP_TITLES)}.")
    return with_unit(project, replace(unit_of(project, number), group=group))


def without_units(project: Project, numbers: Collection[int]) -> Project:
    """A project without some units; expression and emotions let go of their weights."""
    gone = {field for number in numbers for field in unit_of(project, number).fields}
    return refielded(project, dict.fromkeys(numbers), lambda name: None if name in gone else name)


def moved_unit(project: Project, number: int, place: int) -> Project:
    """A project in which a unit stands at another place of the list, counted from 0."""
    unit = unit_of(project, number)
    others = [each for each in project.units if each is not unit]
    others.insert(min(max(place, 0), len(others)), unit)
    return replace(project, units=tuple(others))


def with_unit(project: Project, unit: ActionUnit) -> Project:
    """A project with a unit in place of the one with its number."""
    return replace(project, units=tuple(unit if each.number == unit.number else each for each in project.units))


def check_range(what: str, value: float, least: float, most: float, unit: str) -> None:
    """See that a number is within a range; raises `UnitError` with what it is, and its unit, otherwise."""
    if not (math.isfinite(value) and least <= value <= most):
        raise UnitError(f"{what} is {value:g}{unit}; choose a number from {least:g} to {most:g}{unit}.")
