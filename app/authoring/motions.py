"""What an action unit does to eyes, head and tongue."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import astuple, replace

from app.authoring.units import unit_of, with_unit
from app.errors import UnitError
from facemodel.motions import EyeMotion, HeadMotion, TongueMotion
from facemodel.project import Project

WIDEST_TURN = 90.0
"""Degrees that eyes or head are turned at most."""

FARTHEST = 100.0
"""Millimetres that a head or a tongue is moved at most."""


def with_eyes(project: Project, number: int, turn: float = 0.0, lift: float = 0.0, spread: float = 0.0) -> Project:
    """A project in which a unit turns the eyes by degrees, see `facemodel.motions.EyeMotion`.

    Raises
    ------
    UnitError
        If the unit has left and right, or one of the numbers is out of range.
    """
    unit = unit_of(project, number)
    _check_one(unit.paired, number, "eyes")
    motion = EyeMotion(float(turn), float(lift), float(spread))
    _check({"turn of the eyes": turn, "lift of the eyes": lift, "spread of the eyes": spread}, WIDEST_TURN, "°")
    return with_unit(project, replace(unit, eyes=motion or None))


def with_head(
    project: Project, number: int, turn: float = 0.0, lift: float = 0.0, tilt: float = 0.0, forward: float = 0.0
) -> Project:
    """A project in which a unit moves the head, see `facemodel.motions.HeadMotion`.

    Raises
    ------
    UnitError
        If the unit has left and right, or one of the numbers is out of range.
    """
    unit = unit_of(project, number)
    _check_one(unit.paired, number, "head")
    motion = HeadMotion(float(turn), float(lift), float(tilt), float(forward))
    _check({"turn of the head": turn, "lift of the head": lift, "tilt of the head": tilt}, WIDEST_TURN, "°")
    _check({"motion of the head": forward}, FARTHEST, " mm")
    return with_unit(project, replace(unit, head=motion or None))


def with_tongue(project: Project, number: int, out: float = 0.0, lift: float = 0.0) -> Project:
    """A project in which a unit moves the tongue, see `facemodel.motions.TongueMotion`.

    Raises
    ------
    UnitError
        If the unit has left and right, or one of the numbers is out of range.
    """
    unit = unit_of(project, number)
    _check_one(unit.paired, number, "tongue")
    motion = TongueMotion(float(out), float(lift))
    _check({"motion of the tongue": out}, FARTHEST, " mm")
    _check({"bend of the tongue": lift}, WIDEST_TURN, "°")
    return with_unit(project, replace(unit, tongue=motion or None))


def summed_eyes(parts: list[tuple[EyeMotion | None, float]]) -> EyeMotion | None:
    """Motions with their shares as one; none if nothing turns."""
    return EyeMotion(*_sum([(astuple(motion), share) for motion, share in parts if motion], 3)) or None


def summed_head(parts: list[tuple[HeadMotion | None, float]]) -> HeadMotion | None:
    """Motions with their shares as one; none if nothing moves."""
    return HeadMotion(*_sum([(astuple(motion), share) for motion, share in parts if motion], 4)) or None


def summed_tongue(parts: list[tuple[TongueMotion | None, float]]) -> TongueMotion | None:
    """Motions with their shares as one; none if nothing moves."""
    return TongueMotion(*_sum([(astuple(motion), share) for motion, share in parts if motion], 2)) or None


def _sum(rows: list[tuple[tuple[float, ...], float]], size: int) -> list[float]:
    return [sum(row[k] * share for row, share in rows) for k in range(size)]


def _check_one(paired: bool, number: int, what: str) -> None:
    if paired:
        raise UnitError(f"Action unit {number} has left and right, but {what} move as one; join its sides first.")


def _check(values: Mapping[str, float], most: float, unit: str) -> None:
    for what, value in values.items():
        if not (math.isfinite(value) and abs(value) <= most):
            raise UnitError(f"The {what} is {value:g}{unit}; choose a number from {-most:g} to {most:g}{unit}.")
