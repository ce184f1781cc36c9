"""Action units that are parted into left and right, and joined again."""

from __future__ import annotations

from dataclasses import replace

from app.authoring.renaming import refielded
from app.authoring.units import WIDEST, unit_of, with_unit
from app.errors import UnitError
from facemodel.actions import ActionUnit, JawMotion
from facemodel.animation.respelling import respelled
from facemodel.project import Project
from facemodel.sculpting.correction import halved


def split(project: Project, number: int) -> Project:
    """A project in which left and right of a unit move apart; both keep the weight it has, and together do the same.

    Of a unit that brings the jaw to one side that side's field does all of it, and the other one its mirror image.

    Raises
    ------
    UnitError
        If they do already.
    """
    unit = unit_of(project, number)
    if unit.paired:
        raise UnitError(f"Action unit {number} ({unit.name}) has left and right already.")
    if unit.eyes or unit.head or unit.tongue:
        raise UnitError(f"Action unit {number} ({unit.name}) moves eyes, head or tongue, which have no sides to part.")
    if unit.jaw and unit.jaw.side:
        return _split_sideways(project, unit, unit.jaw)
    both = replace(unit, paired=True, jaw=_times(unit.jaw, 0.5))
    weight = project.expression.get(unit.fields[0])
    expression = {name: each for name, each in project.expression.items() if name != unit.fields[0]}
    if weight is not None:
        expression |= dict.fromkeys(both.fields, weight)
    corrections = halved(project.corrections, both, project.face.skin)
    animation = respelled(project.animation, lambda name: both.fields if name == unit.fields[0] else (name,))
    return with_unit(replace(project, expression=expression, corrections=corrections, animation=animation), both)


def joined(project: Project, number: int) -> Project:
    """A project in which left and right of a unit move as one, with the larger of both weights.

    Raises
    ------
    UnitError
        If they do already.
    """
    unit = unit_of(project, number)
    if not unit.paired:
        raise UnitError(f"Action unit {number} ({unit.name}) has no left and right to join.")
    one = replace(unit, paired=False, jaw=_times(unit.jaw, 1.0 if unit.jaw and unit.jaw.side else 2.0))
    return refielded(project, {number: one}, lambda name: one.fields[0] if name in unit.fields else name)


def _split_sideways(project: Project, unit: ActionUnit, jaw: JawMotion) -> Project:
    both = replace(unit, paired=True, jaw=replace(jaw, side=abs(jaw.side)))
    (whole,), own = unit.fields, both.fields[0 if jaw.side > 0 else 1]
    return refielded(project, {unit.number: both}, lambda name: own if name == whole else name)


def _times(jaw: JawMotion | None, factor: float) -> JawMotion | None:
    if jaw is None:
        return None
    return replace(jaw, degrees=min(max(factor * jaw.degrees, -WIDEST), WIDEST), slide=factor * jaw.slide)
