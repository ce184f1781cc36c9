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
    """Whether a unit may be another one than its mirror image: it brings the jaw to one side, or is sculpted."""
    return bool((unit.jaw and unit.jaw.side and not unit.paired) or layers_of(project, unit))


def mirrored_unit(project: Project, number: int, partners: IntArray) -> Project:
    """A project in which a unit does on the right what it did on the left, and the other way round.

    The muscles of a unit are named without their side, so that both sides contract them alike: what is turned over is
    where the jaw goes and what is sculpted.

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
    turned = unit if unit.paired or unit.jaw is None else replace(unit, jaw=unit.jaw.mirrored)
    return with_unit(with_corrections(project, unit, layers), turned)
