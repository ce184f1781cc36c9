"""The superposition check of what is shown: where the sum of the fields is not what the summed loads would do."""

from __future__ import annotations

from dataclasses import dataclass

from app.document import Document
from app.jobs import Job
from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.comparison import Comparison, compared, in_full
from facemodel.errors import FaceError
from facemodel.project import Project
from facemodel.solution import Progress


@dataclass(frozen=True, eq=False)
class Posed:
    """An expression of a solved project."""

    project: Project
    basis: Basis
    expression: Expression


SuperpositionJob = Job[Posed, Comparison]
"""Checks what was posed; make it with `check_superposition`."""


def posed(document: Document) -> Posed:
    """What a document shows.

    Raises
    ------
    FaceError
        If it is not solved as it is now.
    """
    if document.solution is None or document.stale:
        raise FaceError("There is nothing to check before this face is solved; choose “Solve now” first.")
    return Posed(document.project, document.solution.basis, document.shown)


def check_superposition(asked: Posed, progress: Progress) -> Comparison:
    """Solve the summed loads in full and compare.

    Raises
    ------
    FaceError, Cancelled
        As `facemodel.comparison.in_full` does.
    """
    whole = in_full(asked.project, asked.expression, progress)
    return compared(asked.project, asked.expression, asked.basis, whole)
