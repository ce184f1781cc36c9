"""Fill the weights of all action units from the table of FACS, in one step."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from facemodel.actions import ActionUnit
from facemodel.faces import face_keys
from facemodel.facs import action_units
from facemodel.project import Project
from facemodel.projects import new_project


@dataclass(frozen=True, eq=False)
class Filling:
    """What filling from the table comes to.

    Attributes
    ----------
    project : with the units of the table
    missing : by number of a unit, the muscles that the table names and the project does not have
    """

    project: Project
    missing: Mapping[int, tuple[str, ...]]


def filled_from_facs(project: Project) -> Filling:
    """A project whose units contract the muscles of the table, as far as the project has them.

    Units that the table knows get its weights and motions and keep their name, sides and note; those that the
    project lacks are put in, and those that the table does not know stay.  On a shipped face the weights are the
    ones that move it as far as the table says.
    """
    there = {muscle.name for muscle in project.muscles}
    table = {unit.number: unit for unit in _table(project)}
    missing = {n: tuple(sorted(unit.muscles.keys() - there)) for n, unit in table.items()}
    fitting = {number: _with_those(unit, there) for number, unit in table.items()}
    known = {unit.number for unit in project.units}
    kept = tuple(_filled(unit, fitting.get(unit.number)) for unit in project.units)
    added = tuple(unit for number, unit in fitting.items() if number not in known)
    return Filling(
        replace(project, units=(*kept, *added)), {number: names for number, names in missing.items() if names}
    )


def _table(project: Project) -> tuple[ActionUnit, ...]:
    return new_project(project.face.key).units if project.face.key in face_keys() else action_units()


def _with_those(unit: ActionUnit, there: set[str]) -> ActionUnit:
    return replace(unit, muscles={name: weight for name, weight in unit.muscles.items() if name in there})


def _filled(unit: ActionUnit, table: ActionUnit | None) -> ActionUnit:
    if table is None:
        return unit
    return replace(
        unit,
        muscles=table.muscles,
        jaw=table.jaw,
        amplitude=table.amplitude,
        eyes=table.eyes,
        head=table.head,
        tongue=table.tongue,
    )
