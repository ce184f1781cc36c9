"""Find how strongly each action unit must contract its muscles to move the skin as far as the table says."""

from __future__ import annotations

from dataclasses import replace

from facemodel.atlas import Atlas
from facemodel.face import Face
from facemodel.facs import action_units
from facemodel.muscles import Muscle
from facemodel.project import Project, Settings
from facemodel.solve import solve_project

CLOSE = 0.005
"""Relative error of an amplitude at which the search ends; muscles are linear and need one step, the jaw's arc two
or three."""

LARGEST_TURN = 40.0
"""Degrees; an opening beyond this would mean that the skin does not follow the jaw."""


def find_gains(face: Face, muscles: tuple[Muscle, ...]) -> Atlas:
    """The atlas of a face with the gain of every action unit of the table."""
    atlas = Atlas(muscles, {unit.number: 1.0 for unit in action_units()})
    for _ in range(5):
        units = tuple(atlas.scaled(unit) for unit in action_units())
        basis = solve_project(Project(face, muscles, units, (), {}, Settings(density=1))).basis
        reached = {unit.number: max(basis.peak(name) for name in unit.fields) for unit in units}
        wrong = {unit.number: unit.amplitude / reached[unit.number] for unit in units}
        gains = {number: gain * wrong[number] for number, gain in atlas.gains.items()}
        gains = {n: min(g, LARGEST_TURN / _degrees(n)) if _degrees(n) else g for n, g in gains.items()}
        atlas = replace(atlas, gains=gains)
        if all(abs(factor - 1) < CLOSE for factor in wrong.values()):
            break
    return atlas


def _degrees(number: int) -> float:
    unit = next(unit for unit in action_units() if unit.number == number)
    return unit.jaw.degrees if unit.jaw else 0.0
