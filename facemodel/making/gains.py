"""Find how strongly each action unit must contract its muscles to move the skin as far as the table says."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.optimize import brentq

from facemodel.actions import ActionUnit, skin_units
from facemodel.atlas import Atlas
from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.facs import action_units
from facemodel.jaw.opening import opened
from facemodel.muscles import Muscle
from facemodel.project import Project, Settings
from facemodel.solve import solve_project

CLOSE = 0.005
"""Relative error of an amplitude at which the search ends; muscles are linear and need one step, the jaw's arc two
or three."""

LARGEST_TURN = 38.0
"""Degrees; a jaw opens no farther, however much the skin of the chin lags behind it.  People turn theirs by 34 at most
on the mean, and some by 40; a jaw whose incisors are near its hinge needs more for the same way between them."""

OPEN_WIDE = 40.1
"""Millimetres between the incisors to which the mouth stretch opens, just above the lower end of the norm of adults."""

WIDER = 1.25
"""How far beyond the table's amplitude of the chin it may go for that."""

STRETCH = 27
"""The action unit that opens the jaw all the way."""


def find_gains(face: Face, muscles: tuple[Muscle, ...]) -> Atlas:
    """The atlas of a face with the gain of every action unit of the table."""
    atlas = Atlas(muscles, {unit.number: 1.0 for unit in skin_units(action_units())})
    for _ in range(5):
        units = tuple(atlas.scaled(unit) for unit in skin_units(action_units()))
        basis = solve_project(Project(face, muscles, units, (), {}, Settings(density=1))).basis
        wrong = {unit.number: _factor(basis, unit) for unit in units}
        gains = {number: gain * wrong[number] for number, gain in atlas.gains.items()}
        gains = {n: min(g, LARGEST_TURN / _degrees(n)) if _degrees(n) else g for n, g in gains.items()}
        atlas = replace(atlas, gains=gains)
        if all(abs(factor - 1) < CLOSE for factor in wrong.values()):
            break
    stretched = min(max(atlas.gains[STRETCH], _wide_open(face)), WIDER * atlas.gains[STRETCH])
    return replace(atlas, gains={**atlas.gains, STRETCH: stretched})


def _wide_open(face: Face) -> float:
    """The gain of the mouth stretch that opens a face wide, or as far as a jaw goes."""
    jaw = next(unit.jaw for unit in action_units() if unit.number == STRETCH and unit.jaw)
    most = LARGEST_TURN / jaw.degrees
    if opened(face, LARGEST_TURN, jaw.slide) < OPEN_WIDE:
        return most
    return float(brentq(lambda gain: opened(face, gain * jaw.degrees, jaw.slide) - OPEN_WIDE, 0.0, most))


def _factor(basis: Basis, unit: ActionUnit) -> float:
    """What the gain of a unit is off by.

    The table's amplitudes are those of one side.  Where the sides meet at the midline both together move the skin
    further; then one side may fall a tenth short, so that the two of them stay near the table as well.
    """
    fields = [basis.moving_field(name) for name in unit.fields]
    alone = max(basis.peak(name) for name in unit.fields)
    together = float(np.linalg.norm(np.sum(fields, axis=0), axis=1).max())
    return min(
        unit.amplitude / alone, max(LEAST_ALONE * unit.amplitude / alone, MOST_TOGETHER * unit.amplitude / together)
    )


LEAST_ALONE, MOST_TOGETHER = 0.9, 1.1
"""Shares of the table's amplitude that one side must reach at least, and both together should not pass."""


def _degrees(number: int) -> float:
    unit = next(unit for unit in action_units() if unit.number == number)
    return unit.jaw.degrees if unit.jaw else 0.0
