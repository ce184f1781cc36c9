"""One action unit of two, each in a share of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from app.authoring.motions import summed_eyes, summed_head, summed_tongue
from app.authoring.renaming import refielded
from app.authoring.units import check_range, unit_of
from app.errors import UnitError
from facemodel.actions import EXAGGERATED, JawMotion
from facemodel.project import Project
from facemodel.sculpting.correction import Corrections, correction_of


def merged(project: Project, number: int, other: int, own: float = 1.0, share: float = 1.0) -> Project:
    """A project in which one unit does what two did; it keeps the number and name of the first.

    In expression and emotions it has the larger weight of both; what is sculpted on either lies on it, in its share.

    Parameters
    ----------
    own, share : how much of the first and of the other one goes into it, 0 to `EXAGGERATED`; 1 is all of it

    Raises
    ------
    UnitError
        If both are the same, only one of them has left and right, or a share is out of range.
    """
    for each, part in ((number, own), (other, share)):
        check_range(f"The share of action unit {each}", part, 0.0, EXAGGERATED, "")
    first, second = unit_of(project, number), unit_of(project, other)
    if number == other:
        raise UnitError(f"Action unit {number} cannot be merged with itself; choose another one.")
    if first.paired != second.paired:
        raise UnitError(f"Only one of action units {number} and {other} has left and right; split or join one first.")
    names = {**first.muscles, **second.muscles}
    sums = {name: own * first.muscles.get(name, 0.0) + share * second.muscles.get(name, 0.0) for name in names}
    jaws = [(unit.jaw, part) for unit, part in ((first, own), (second, share)) if unit.jaw and part]
    names_of = ("degrees", "slide", "side")
    jaw = JawMotion(*(sum(getattr(each, name) * part for each, part in jaws) for name in names_of))
    both = replace(
        first,
        muscles={name: total for name, total in sums.items() if total},
        jaw=jaw or None,
        amplitude=max(own * first.amplitude, share * second.amplitude),
        eyes=summed_eyes([(first.eyes, own), (second.eyes, share)]),
        head=summed_head([(first.head, own), (second.head, share)]),
        tongue=summed_tongue([(first.tongue, own), (second.tongue, share)]),
    )
    fields = dict(zip(second.fields, both.fields, strict=True))
    shared = replace(project, corrections=_shared(project, {number: own, other: share}))
    return refielded(shared, {number: both, other: None}, lambda name: fields.get(name, name))


def _shared(project: Project, shares: Mapping[int, float]) -> Corrections:
    """The corrections of a project with those of some units, by number, taken so many times."""
    factors = {field: share for number, share in shares.items() for field in unit_of(project, number).fields}
    count = len(project.face.skin.positions)
    found = {
        name: each if factors.get(name, 1.0) == 1.0 else correction_of(factors[name] * each.everywhere(count), each)
        for name, each in project.corrections.items()
    }
    return {name: each for name, each in found.items() if len(each.vertices)}
