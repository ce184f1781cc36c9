"""Where the intensities A to E of an action unit begin."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from app.authoring.units import unit_of, with_unit
from app.errors import UnitError
from app.intensity import NAMES
from facemodel.actions import EXAGGERATED
from facemodel.project import Project

NARROWEST = 0.01
"""A letter that covers less of a slider could not be hit."""


def with_letters(project: Project, number: int, letters: Sequence[float]) -> Project:
    """A project in which the intensities A to E of a unit begin at some weights.

    Raises
    ------
    UnitError
        If there are not five increasing weights, the first above 0 and the last within what sliders reach.
    """
    begins = tuple(round(float(weight), 6) for weight in letters)
    if len(begins) != len(NAMES):
        raise UnitError(f"There are {len(begins)} beginnings of intensities; give one for each of A, B, C, D and E.")
    if not all(math.isfinite(weight) and 0 < weight <= EXAGGERATED for weight in begins):
        raise UnitError(f"An intensity begins at a weight above 0 and up to {EXAGGERATED:g}; choose others.")
    for letter, (begin, end) in zip(NAMES[1:], pairwise(begins), strict=True):
        if end - begin < NARROWEST - 1e-9:
            raise UnitError(f"{letter} begins at {end:g}, which is not after {begin:g}; let A to E begin in order.")
    unit = unit_of(project, number)
    return project if begins == unit.letters else with_unit(project, replace(unit, letters=begins))


def with_letter(project: Project, number: int, letter: str, weight: float) -> Project:
    """A project in which one intensity of a unit begins elsewhere, between the ones beside it."""
    begins = list(unit_of(project, number).letters)
    at = NAMES.index(letter)
    least = begins[at - 1] + NARROWEST if at else NARROWEST
    most = begins[at + 1] - NARROWEST if at + 1 < len(begins) else EXAGGERATED
    begins[at] = min(max(weight, least), max(least, most))
    return with_letters(project, number, begins)
