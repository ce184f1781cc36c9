"""The superposition check: how far the sum of solved fields is from the solution of the summed loads."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from facemodel.actions import ActionUnit, Expression, JawMotion, field_names
from facemodel.basis import Basis
from facemodel.fields import jaw_table
from facemodel.loads import contractions
from facemodel.muscles import Muscle
from facemodel.project import Project
from facemodel.solution import Solution
from facemodel.superposition import Superposition
from fem.types import FloatArray

WHOLE = 1
"""Number of the one unit that holds all loads of an expression."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """Two ways to the same expression.

    Attributes
    ----------
    apart : (P,) distance of every drawn point of the skin, millimetres
    moved : largest displacement of the skin by the expression, millimetres
    """

    apart: FloatArray
    moved: float

    @property
    def largest(self) -> float:
        """Largest distance, millimetres."""
        return float(self.apart.max(initial=0.0))

    @property
    def rms(self) -> float:
        """Root of the mean square distance over all drawn points that move, millimetres."""
        return float(np.sqrt(np.mean(self.apart**2))) if len(self.apart) else 0.0


def summed(project: Project, expression: Expression) -> Project:
    """A project with one unit that holds the loads of an expression, to be solved in full.

    Every muscle is made one of its own, so that left and right may contract differently in one field; the jaw turns
    by the sum of all angles at once, which is what a basis of turns can only approach.
    """
    contracted = contractions(project.units, project.muscles)
    pull: dict[str, float] = {}
    for field, weight in expression.items():
        for key, share in contracted.get(field, {}).items():
            pull[key] = pull.get(key, 0.0) + weight * share
    unit = ActionUnit(WHOLE, "whole", "upper", False, pull, 1.0, _jaw(project, expression))
    return replace(project, muscles=tuple(map(_alone, project.muscles)), units=(unit,), emotions=(), expression={})


def compared(project: Project, expression: Expression, basis: Basis, whole: Solution) -> Comparison:
    """Compare the superposed fields of a basis, as they are drawn, with the solution of the summed loads.

    Parameters
    ----------
    whole : of `summed`, sampled on the same display surface
    """
    superposed = Superposition(project.face, basis)
    superposed.pose(expression)
    in_full = Superposition(project.face, whole.basis, glide=False)
    in_full.pose({str(WHOLE): 1.0})
    moving = basis.display.moving
    apart = np.linalg.norm(superposed.points.astype(np.float64) - in_full.points, axis=1)
    moved = np.linalg.norm(in_full.points[:moving] - basis.display.points[:moving], axis=1)
    return Comparison(apart, float(moved.max(initial=0.0)))


def _alone(muscle: Muscle) -> Muscle:
    return replace(muscle, name=muscle.key, side="M", linked=False)


def _jaw(project: Project, expression: Expression) -> JawMotion | None:
    names, table = field_names(project.units), jaw_table(project.units)
    weights = np.array([expression.get(name, 0.0) for name in names])
    degrees, slide = (float(total) for total in weights @ table)
    return JawMotion(degrees, slide) if degrees or slide else None
