"""A solution with the project it belongs to, and what of it still holds for another one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.differences import same_head
from facemodel.actions import Expression, skin_fields
from facemodel.basis import Basis
from facemodel.project import Project
from facemodel.sameness import Kept
from facemodel.sculpting.corrected import Corrector
from facemodel.sculpting.correction import Corrections
from facemodel.solution import Solution
from facemodel.staleness import stale_fields
from fem.types import Float32Array


@dataclass(frozen=True, eq=False)
class Solved:
    """A solution and the project that was solved."""

    solution: Solution
    project: Project

    def shows(self, project: Project) -> bool:
        """Whether its points and fields are those of the same head, so that it can go on being drawn."""
        return same_head(self.project.face, project.face)

    def stale_for(self, project: Project) -> frozenset[str]:
        """Fields of another project that this solution does not hold for."""
        return stale_fields(self.project, project)

    def holds_for(self, project: Project) -> bool:
        """Whether it is what solving another project would give."""
        return same_fields(self.project, project)


def same_fields(one: Project, other: Project) -> bool:
    """Whether two projects have the same displacement fields under the same names, in the same order, on one head."""
    return (
        same_head(one.face, other.face)
        and skin_fields(one.units) == skin_fields(other.units)
        and not stale_fields(one, other)
    )


def moved_by(basis: Basis, expression: Expression) -> Float32Array:
    """Displacement (P, 3) of the drawn skin by an expression, the linear sum of its fields; millimetres."""
    total = np.zeros_like(basis.display.points)
    for name, weight in expression.items():
        if weight and name in basis.index:
            total[: basis.display.moving] += np.float32(weight) * basis.moving_field(name)
    return total


def change_between(before: Basis, after: Basis, expression: Expression) -> Float32Array | None:
    """How far (P,) another basis moves every drawn point of the skin under an expression, millimetres.

    None if both are not sampled at the same points.
    """
    if before.display.points.shape != after.display.points.shape or before.display.density != after.display.density:
        return None
    apart: Float32Array = np.linalg.norm(moved_by(after, expression) - moved_by(before, expression), axis=1)
    return apart


class Solutions:
    """The last solution of a document and the one before it, and how far they hold for its project now.

    Parameters
    ----------
    project : of the document
    """

    def __init__(self, project: Project) -> None:
        self.last: Solved | None = None
        self.previous: Solved | None = None
        self.shown: Solution | None = None
        self._made_of: tuple[Solution, Corrections] | None = None
        self._correct = Corrector()
        self._correct_before = Corrector()
        self._earlier: Kept[Solution] = Kept()
        self.stale_fields: frozenset[str] = frozenset()
        self.stale = True
        self.follow(project)

    @property
    def standing(self) -> tuple[Solution | None, bool, frozenset[str]]:
        """All that a listener would want to know of, to be compared."""
        return self.shown, self.stale, self.stale_fields

    def before(self, project: Project) -> Solution | None:
        """The solution before the last one, with the corrections that a project has now."""
        if self.previous is None:
            return None
        raw = self.previous.solution
        return self._earlier.get((raw, project.corrections), lambda: self._correct_before(raw, project))

    def follow(self, project: Project) -> None:
        """Find out what holds for another state of the project; a solution of another head is let go."""
        if self.last is not None and not self.last.shows(project):
            self.last = self.previous = None
        if self.last is None:
            self.stale_fields, self.stale = frozenset(skin_fields(project.units)), True
        else:
            self.stale_fields = self.last.stale_for(project)
            self.stale = not self.last.holds_for(project)
        self._follow_corrections(project)

    def accept(self, solved: Solved, project: Project) -> bool:
        """Take a solution if it holds for the project; whether it does."""
        if not solved.holds_for(project):
            return False
        if self.last is not None and self.last.solution.basis is not solved.solution.basis:
            self.previous = self.last
        self.last, self.stale_fields, self.stale = solved, frozenset(), False
        self._follow_corrections(project)
        return True

    def _follow_corrections(self, project: Project) -> None:
        """Put on the solution what is sculpted; the one that is shown stays if that is the same as before."""
        if self.last is None:
            self.shown, self._made_of = None, None
            return
        made_of = self.last.solution, project.corrections
        if self._made_of is None or any(one is not other for one, other in zip(self._made_of, made_of, strict=True)):
            self.shown, self._made_of = self._correct(self.last.solution, project), made_of

    def last_change(self, expression: Expression) -> Float32Array | None:
        """How far (P,) the last solve moved every drawn point under an expression; None if there is but one."""
        if self.last is None or self.previous is None:
            return None
        return change_between(self.previous.solution.basis, self.last.solution.basis, expression)
