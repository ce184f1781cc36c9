"""Action units as the FACS table has them, on the face of a project."""

from __future__ import annotations

from dataclasses import replace

from facemodel.actions import ActionUnit
from facemodel.atlas import Atlas, read_atlas
from facemodel.composing.units import unit_of, with_unit
from facemodel.errors import ActionError
from facemodel.faces import face_keys
from facemodel.facs import action_units
from facemodel.project import Project
from resources import resource


def table_unit(project: Project, number: int) -> ActionUnit:
    """A unit of the table with the gain of the project's face, without the muscles that are not there.

    Raises
    ------
    ActionError
        If the table has no such unit, or the face none of its muscles.
    """
    for unit in action_units():
        if unit.number == number:
            break
    else:
        raise ActionError(f"FACS has no action unit {number} in its table; change its muscles by hand.")
    there = {muscle.name for muscle in project.muscles}
    whole = _atlas(project).scaled(unit)
    left = replace(whole, muscles={name: weight for name, weight in whole.muscles.items() if name in there})
    if whole.muscles and not left.muscles and left.jaw is None:
        raise ActionError(f"This face has none of the muscles of action unit {number}; lay them first.")
    return left


def filled(project: Project, number: int) -> Project:
    """A project in which a unit contracts the muscles of the table; its name and its sides stay."""
    unit, table = unit_of(project, number), table_unit(project, number)
    return with_unit(project, replace(unit, muscles=table.muscles, jaw=table.jaw, amplitude=table.amplitude))


def missing(project: Project) -> tuple[ActionUnit, ...]:
    """Units of the table that the project does not have."""
    there = {unit.number for unit in project.units}
    return tuple(unit for unit in action_units() if unit.number not in there)


def completed(project: Project) -> Project:
    """A project with every unit of the table for which it has muscles, those that it has filled anew; own ones last."""
    order = {unit.number: place for place, unit in enumerate(action_units())}
    for number in order:
        try:
            found = table_unit(project, number)
        except ActionError:
            continue
        there = any(each.number == number for each in project.units)
        project = filled(project, number) if there else with_unit(project, found)
    units = sorted(project.units, key=lambda unit: order.get(unit.number, len(order)))
    return replace(project, units=tuple(units))


def _atlas(project: Project) -> Atlas:
    """The gains of a shipped face; those of another one are not known and are 1."""
    key = project.face.key
    return read_atlas(resource("atlas", f"{key}.json")) if key in face_keys() else Atlas((), {})
