"""Compare the models of a muscle in the background, on a face that stays factorised as long as that is wanted."""

from __future__ import annotations

from dataclasses import dataclass

from app.document import Document
from app.view import View
from facemodel.errors import MuscleError
from facemodel.model_fields import ModelFields, model_fields
from facemodel.muscles import Muscle
from facemodel.muscles.models import comparable_models
from facemodel.project import Project
from facemodel.solution import Progress, silent
from facemodel.solver import FaceSolver


@dataclass(frozen=True, eq=False)
class Comparing:
    """A muscle of a project whose models are to be compared."""

    project: Project
    muscle: Muscle


class ModelComparison:
    """Compares one muscle after the other; belongs to one worker thread."""

    def __init__(self) -> None:
        self._solver = FaceSolver()

    def __call__(self, asked: Comparing, progress: Progress = silent) -> ModelFields:
        """What the muscle does under each of its models.

        Raises
        ------
        FaceError, Cancelled
            As `facemodel.model_fields.model_fields` does.
        """
        return model_fields(asked.project, asked.muscle, self._solver, progress)

    def forget(self) -> None:
        """Let go of the factorised face, which is large."""
        self._solver = FaceSolver()


def to_compare(document: Document, view: View) -> Comparing:
    """The muscle that was selected last.

    Raises
    ------
    MuscleError
        If none is selected, or there is nothing to compare it with.
    """
    muscle = next((each for each in document.project.muscles if each.key == view.state.muscle), None)
    if muscle is None:
        raise MuscleError("No muscle is selected; click one to compare its models.")
    if len(comparable_models(muscle)) < 2:
        raise MuscleError(f"“{muscle.title}” can act by one model only, so there is nothing to compare it with.")
    return Comparing(document.project, muscle)
