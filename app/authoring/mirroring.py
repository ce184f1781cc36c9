"""The mirror image of an action unit."""

from __future__ import annotations

from dataclasses import replace

from app.authoring.sculpting import layers_of, with_corrections
from app.authoring.units import unit_of, with_unit
from app.errors import UnitError
from facemodel.actions import ActionUnit
from facemodel.project import Project
from facemodel.sculpting.correction import mirrored
from fem.types import IntArray


def one_sided(project: Project, unit: ActionUnit) -> bool:
    """Whether a unit may be another one than its mirror image: it moves something to one side, or is sculpted."""
    sideways = (
        (unit.jaw and unit.jaw.side)
        or (unit.eyes and unit.eyes.turn)
        or (unit.head and (unit.head.turn or unit.head.tilt))
    )
    return bool((sideways and not unit.paired) or layers_of(project, unit))


def mirrored_unit(project: Project, number: int, partners: IntArray) -> Project:
    """A project in which a unit does on the right what it did on the left, and the other way round.

    The muscles of a unit are named without their side, so that both sides contract them alike: what is turned over is
    where jaw, eyes and head go and what is sculpted.

    Parameters
    ----------
    partners : (N,) vertex across the midline or -1

    Raises
    ------
    UnitError
        If the unit is its own mirror image, or contracts a muscle that lies on one side alone.
    """
    unit = unit_of(project, number)
    for name in unit.muscles:
        sides = {muscle.side for muscle in project.muscles if muscle.name == name}
        if sides in ({"L"}, {"R"}):
            where = "left" if sides == {"L"} else "right"
            raise UnitError(f"The muscle “{name}” lies on the {where} alone; duplicate it to the other side first.")
    if not one_sided(project, unit):
        raise UnitError(f"Action unit {number} ({unit.name}) is its own mirror image; there is nothing to turn over.")
    across = dict(zip(unit.fields, reversed(unit.fields), strict=True))
    layers = {across[field]: mirrored(each, partners) for field, each in layers_of(project, unit).items()}
    return with_unit(with_corrections(project, unit, layers), unit if unit.paired else _turned(unit))


def _turned(unit: ActionUnit) -> ActionUnit:
    return replace(
        unit,
        jaw=unit.jaw and unit.jaw.mirrored,
        eyes=unit.eyes and unit.eyes.mirrored,
        head=unit.head and unit.head.mirrored,
    )
