"""The order of action units as they are listed: by groups of FACS, and within a group one after the other."""

from __future__ import annotations

from dataclasses import replace

from app.authoring.units import unit_of
from facemodel.actions import GROUP_TITLES, ActionUnit, Group
from facemodel.project import Project


def listed(project: Project) -> tuple[ActionUnit, ...]:
    """The units as a person sees them listed."""
    return tuple(unit for group in GROUP_TITLES for unit in project.units if unit.group == group)


def placed(project: Project, number: int, group: Group, before: int | None) -> Project:
    """A project in which a unit is listed in a group, in front of another unit of it, or at its end.

    Raises
    ------
    UnknownNameError
        If there is no such unit.
    """
    unit = unit_of(project, number)
    if number == before:
        return project
    moved = replace(unit, group=group)
    others = [each for each in project.units if each is not unit]
    if before is None:
        members = [place for place, each in enumerate(others) if each.group == group]
        place = members[-1] + 1 if members else len(others)
    else:
        place = others.index(unit_of(project, before))
    ordered = (*others[:place], moved if moved != unit else unit, *others[place:])
    return project if ordered == project.units else replace(project, units=ordered)


def stepped(project: Project, number: int, by: int) -> Project:
    """A project in which a unit is listed one place further up (-1) or down (1); at an end all stays as it is.

    At the border of a group it goes over into the one beside it that has units.
    """
    unit, rows = unit_of(project, number), listed(project)
    at = rows.index(unit)
    if not 0 <= at + by < len(rows):
        return project
    beside = rows[at + by]
    if beside.group != unit.group:
        # Upwards it becomes the last of the group above, downwards the first of the one below.
        return placed(project, number, beside.group, None if by < 0 else beside.number)
    if by < 0:
        return placed(project, number, unit.group, beside.number)
    after = rows[at + 2] if at + 2 < len(rows) and rows[at + 2].group == unit.group else None
    return placed(project, number, unit.group, after.number if after else None)
