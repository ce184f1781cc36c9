"""The superposition check: how far the sum of solved fields is from the solution of the summed loads."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from facemodel.actions import ActionUnit, Expression, JawMotion, skin_fields
from facemodel.basis import Basis
from facemodel.displaced import MEMBRANE, displaced_columns, displaces
from facemodel.fields import jaw_table
from facemodel.loads import contractions
from facemodel.muscles import Muscle
from facemodel.muscles.models import muscle_action
from facemodel.project import Project
from facemodel.solution import Progress, silent
from facemodel.solve import FaceSystem, face_system, sampled_basis
from facemodel.superposition import Superposition
from facemodel.system import face_supports
from fem import SmoothInterpolation
from fem.types import FloatArray

WHOLE = 1
"""Number of the one unit that holds all loads of an expression."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """Two ways to the same expression.

    Attributes
    ----------
    apart : (S,) distance of every drawn point of the skin that moves, millimetres
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


def in_full(project: Project, expression: Expression, progress: Progress = silent) -> Basis:
    """The solution of the summed loads of an expression, each solved for once and none superposed.

    Returns
    -------
    basis : of one field, `WHOLE`

    Raises
    ------
    FaceError, Cancelled
        As `facemodel.solve.solve_project` does.
    """
    progress("Summing the loads", 0.05)
    whole = summed(project, expression)
    assembled = face_system(whole)
    progress("Solving the summed loads", 0.3)
    fields = assembled.system.solve(assembled.loads) + _displaced(whole, assembled)
    progress("Sampling the smooth surface", 0.9)
    return sampled_basis(whole, assembled, fields)


def compared(
    project: Project,
    expression: Expression,
    basis: Basis,
    whole: Basis,
    *,
    linear: bool = False,
    contact: bool = True,
) -> Comparison:
    """Compare the superposed fields of a basis, as they are drawn, with the solution of the summed loads.

    Where lids and lips meet something they are drawn elsewhere than the loads alone would take them.

    Parameters
    ----------
    whole : as `in_full` gives it, sampled on the same display surface
    linear : compare the pure linear sum of the fields
    contact : keep lids and lips from going through what they meet, unless it is linear
    """
    superposed = Superposition(project.face, basis, linear=linear, contact=contact)
    superposed.pose(expression)
    full = Superposition(project.face, whole, contact=False)
    full.pose({str(WHOLE): 1.0})
    moving = basis.display.moving
    apart = np.linalg.norm(superposed.points.astype(np.float64) - full.points, axis=1)
    moved = np.linalg.norm(full.points[:moving] - basis.display.points[:moving], axis=1)
    return Comparison(apart[:moving], float(moved.max(initial=0.0)))


def _displaced(whole: Project, assembled: FaceSystem) -> FloatArray:
    """Coefficients (n_dofs, 3, 1) of what muscles displace that know no forces."""
    (unit,) = whole.units
    pulling = [(muscle, unit.muscles[muscle.key]) for muscle in whole.muscles if unit.muscles.get(muscle.key)]
    moves = [weight * muscle_action(muscle, whole.face) for muscle, weight in pulling if displaces(muscle)]
    region = assembled.region
    if not moves:
        return np.zeros((len(region.dofs), 3, 1))
    smooth = SmoothInterpolation(assembled.head.assembler, MEMBRANE)
    return displaced_columns(np.sum(moves, axis=0)[None], smooth, region, face_supports(whole.face, region.vertices))


def _alone(muscle: Muscle) -> Muscle:
    return replace(muscle, name=muscle.key, side="M", linked=False)


def _jaw(project: Project, expression: Expression) -> JawMotion | None:
    names, table = skin_fields(project.units), jaw_table(project.units)
    weights = np.array([expression.get(name, 0.0) for name in names])
    return JawMotion(*(float(total) for total in weights @ table)) or None
