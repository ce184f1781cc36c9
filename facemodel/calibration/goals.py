"""Measured expressions as goals that one action unit is to come near to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from facemodel.actions import ActionUnit, JawMotion
from fem.types import FloatArray


@dataclass(frozen=True, eq=False)
class Goal:
    """One measured expression.

    Attributes
    ----------
    name : of the expression
    unit : number of the action unit that answers it
    groups : names of its muscles with the keys that contract together
    jaw : motion of the mandible
    field : (N, 3) what was measured, millimetres
    """

    name: str
    unit: int
    groups: Mapping[str, tuple[str, ...]]
    jaw: JawMotion | None
    field: FloatArray


def goals(
    measured: Mapping[str, FloatArray], wanted: Mapping[str, Mapping[str, float]], units: Sequence[ActionUnit]
) -> tuple[Goal, ...]:
    """The expressions that one action unit alone answers, which can be learned from.

    Parameters
    ----------
    measured : fields (N, 3) by the name of the expression
    wanted : weights of displacement fields that answer each, see `facemodel.calibration.report.wanted_fields`
    units : the action units of those fields
    """
    made = []
    for name, weights in wanted.items():
        unit = next((u for u in units if set(weights) <= set(u.fields)), None)
        if unit is None or not (unit.muscles or unit.jaw):
            continue
        sides = [field[-1] if unit.paired else "" for field in weights]
        both = sides if sides != [""] else ["L", "R"]
        groups = {m: (m, *(f"{m}_{side}" for side in both)) for m, w in unit.muscles.items() if w}
        jaw = unit.jaw_of(next(iter(weights))) if unit.jaw else None
        made.append(Goal(name, unit.number, groups, jaw, measured[name]))
    return tuple(made)


def signs(units: Sequence[ActionUnit]) -> dict[int, dict[str, float]]:
    """Whether each muscle of an action unit contracts or yields, 1 or -1, by the unit's number."""
    return {unit.number: {name: float(np.sign(weight)) for name, weight in unit.muscles.items()} for unit in units}


def with_mixtures(units: Sequence[ActionUnit], mixtures: Mapping[int, Mapping[str, float]]) -> tuple[ActionUnit, ...]:
    """Action units that contract their muscles as was learned, the strongest as strongly as before.

    Units of which nothing was learned stay as they are.
    """
    return tuple(_mixed(unit, mixtures.get(unit.number, {})) for unit in units)


def _mixed(unit: ActionUnit, pulls: Mapping[str, float]) -> ActionUnit:
    if not pulls:
        return unit
    most = max(abs(weight) for weight in unit.muscles.values())
    return replace(unit, muscles={**unit.muscles, **{name: most * pull for name, pull in pulls.items()}})
