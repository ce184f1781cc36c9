"""What action units may be numbered and called, and what is free."""

from __future__ import annotations

import re

from app.errors import UnitError
from facemodel.actions import ActionUnit
from facemodel.project import Project

FIRST_OWN = 101
"""Where the numbers of units begin that FACS does not know; its own end at 92."""

LARGEST_NUMBER = 999
LONGEST_NAME = 100

BY_NUMBER = re.compile(r"(au)?[\s_-]*\d+[\s_-]*[lr]?", re.IGNORECASE)
"""What names a unit by its number already."""

ONE_SIDE = re.compile(r".*[\s_-][lr]", re.IGNORECASE)
"""What names one side of a unit already."""


def free_number(project: Project) -> int:
    """The first number for a unit that FACS does not know."""
    taken = {unit.number for unit in project.units}
    return next(number for number in range(FIRST_OWN, LARGEST_NUMBER + 1) if number not in taken)


def checked_number(project: Project, number: int) -> int:
    """The number, if a new unit can have it; else raises `UnitError`."""
    if not 1 <= number <= LARGEST_NUMBER:
        raise UnitError(f"An action unit cannot have the number {number}; choose one from 1 to {LARGEST_NUMBER}.")
    for unit in project.units:
        if unit.number == number:
            raise UnitError(f"There is an action unit {number} already ({unit.name}); choose another number.")
    return number


def checked_name(project: Project, name: str, but: ActionUnit | None = None) -> str:
    """The name without stray spaces, if a unit can have it; else raises `UnitError`.

    Parameters
    ----------
    but : the unit that is to have it, which may be called so already
    """
    plain = " ".join(name.split())
    if not plain or len(plain) > LONGEST_NAME:
        raise UnitError(f"An action unit needs a name of at most {LONGEST_NAME} characters; type another one.")
    if BY_NUMBER.fullmatch(plain) or ONE_SIDE.fullmatch(plain):
        raise UnitError(f"“{plain}” reads like a number or a side; give the action unit a name in words.")
    for unit in project.units:
        if unit is not but and unit.name.lower() == plain.lower():
            raise UnitError(f"Action unit {unit.number} is called “{unit.name}” already; choose another name.")
    return plain


def free_name(project: Project, wanted: str) -> str:
    """The name, or the first one with a number behind it that no unit has."""
    taken = {unit.name.lower() for unit in project.units}
    names = (wanted, *(f"{wanted} {count}" for count in range(2, len(taken) + 3)))
    return next(name for name in names if name.lower() not in taken)
