"""What is sculpted on an action unit, as layers over its solved fields: how much of it, cleared, mirrored, copied."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from app.authoring.units import unit_of
from app.errors import UnitError
from facemodel.actions import ActionUnit, Side
from facemodel.project import Project
from facemodel.sculpting.correction import (
    Correction,
    Corrections,
    correction_of,
    joined,
    mirrored,
    side_shares,
    summed,
)
from fem.types import FloatArray, IntArray

SIDE_TITLES: Mapping[Side, str] = {"L": "left", "R": "right"}


def layers_of(project: Project, unit: ActionUnit) -> dict[str, Correction]:
    """The corrections of a unit by field; fields that nobody has sculpted are left out."""
    return {name: project.corrections[name] for name in unit.fields if name in project.corrections}


def sculpted_units(project: Project) -> frozenset[int]:
    """Numbers of the units that somebody has sculpted."""
    return frozenset(unit.number for unit in project.units if layers_of(project, unit))


def with_corrections(project: Project, unit: ActionUnit, layers: Corrections) -> Project:
    """A project in which the fields of a unit have these corrections and no others; empty ones are left out."""
    others = {name: each for name, each in project.corrections.items() if name not in unit.fields}
    kept = {name: each for name, each in layers.items() if len(each.vertices)}
    return replace(project, corrections=dict(sorted({**others, **kept}.items())))


def with_amount(project: Project, number: int, amount: float) -> Project:
    """A project in which so much of what is sculpted on a unit is added to its fields, 0 to 1.

    Raises
    ------
    UnitError
        If nothing is sculpted on the unit, or the amount is out of range.
    """
    if not (math.isfinite(amount) and 0 <= amount <= 1):
        raise UnitError(f"The amount of what is sculpted is {amount:g}; choose a number from 0 to 1.")
    unit, layers = _sculpted(project, number)
    return with_corrections(project, unit, {f: replace(each, amount=float(amount)) for f, each in layers.items()})


def with_switch(project: Project, number: int, on: bool) -> Project:
    """A project in which what is sculpted on a unit is seen, or is not; raises `UnitError` if nothing is."""
    unit, layers = _sculpted(project, number)
    return with_corrections(project, unit, {f: replace(each, on=bool(on)) for f, each in layers.items()})


def cleared(project: Project, number: int) -> Project:
    """A project in which nothing is sculpted on a unit; raises `UnitError` if nothing was."""
    unit, _ = _sculpted(project, number)
    return with_corrections(project, unit, {})


def symmetric(project: Project, number: int, source: Side, partners: IntArray) -> Project:
    """A project in which one side of what is sculpted on a unit is the mirror image of the other.

    Parameters
    ----------
    source : the side that is taken, the subject's own
    partners : (N,) vertex across the midline or -1

    Raises
    ------
    UnitError
        If nothing is sculpted on the unit on that side.
    """
    unit, layers = _sculpted(project, number)
    if not unit.paired:
        (field,) = unit.fields
        made = {field: _folded(layers[field], project, source, partners)}
    else:
        one, other = unit.fields if source == "L" else unit.fields[::-1]
        made = {one: layers[one], other: mirrored(layers[one], partners)} if one in layers else {}
    if not any(len(each.vertices) for each in made.values()):
        raise UnitError(
            f"Nothing is sculpted on the {SIDE_TITLES[source]} of action unit {number}; sculpt there first."
        )
    return with_corrections(project, unit, made)


def copied_to(project: Project, number: int, other: int) -> Project:
    """A project in which another unit has what is sculpted on a unit, in place of what was sculpted on itself.

    A unit with sides takes its share on either side from one without, and one without takes both sides together.

    Raises
    ------
    UnitError
        If nothing is sculpted on the unit, or both are the same.
    """
    unit, layers = _sculpted(project, number)
    target = unit_of(project, other)
    if target is unit:
        raise UnitError(f"What is sculpted on action unit {number} cannot be copied to itself; choose another one.")
    if unit.paired == target.paired:
        names = dict(zip(unit.fields, target.fields, strict=True))
        return with_corrections(project, target, {names[field]: each for field, each in layers.items()})
    if unit.paired:
        one = list(layers.values())
        whole = one[0] if len(one) == 1 else joined(one[0], one[1], len(project.face.skin.positions))
        return with_corrections(project, target, {target.fields[0]: whole})
    (layer,) = layers.values()
    moved = layer.everywhere(len(project.face.skin.positions))
    shares = side_shares(target, project.face.skin)
    return with_corrections(
        project, target, {field: correction_of(share[:, None] * moved, layer) for field, share in shares.items()}
    )


def farthest(project: Project, unit: ActionUnit) -> float:
    """How far what is sculpted moves the skin at most with the unit at 1, as much of it as is added; millimetres."""
    total = summed(project.corrections, unit.fields, len(project.face.skin.positions))
    return float(np.linalg.norm(total, axis=1).max(initial=0.0))


def _sculpted(project: Project, number: int) -> tuple[ActionUnit, dict[str, Correction]]:
    unit = unit_of(project, number)
    layers = layers_of(project, unit)
    if not layers:
        raise UnitError(f"Nothing is sculpted on action unit {number} ({unit.name}) yet; sculpt it first.")
    return unit, layers


def _folded(layer: Correction, project: Project, source: Side, partners: IntArray) -> Correction:
    """A correction with one side in place of both; on the midline it goes straight ahead."""
    skin = project.face.skin.positions
    whole, image = layer.everywhere(len(skin)), mirrored(layer, partners).everywhere(len(skin))
    own = skin[:, 0] if source == "L" else -skin[:, 0]
    alone: FloatArray = partners == np.arange(len(skin))
    made = np.where((own > 0)[:, None], whole, image)
    return correction_of(np.where(alone[:, None], (whole + image) / 2, made), layer)
