"""Functions of scripts that lay, fit and compare muscles, beside those of `app.scripting.names`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from app.authoring.fitted_muscles import Keeping, with_fitted_muscles
from app.scripting.desk import ScriptDesk
from app.scripting.muscle_handle import MuscleHandle
from app.scripting.painting import Painter, Where
from facemodel.faces import face_keys
from facemodel.io.project_file import load_project
from facemodel.laying import collection
from facemodel.laying.rings import laid_ring
from facemodel.model_fields import model_fields
from facemodel.projects import new_project


class MuscleNames:
    """What can be called to lay and compare muscles.

    Parameters
    ----------
    desk : what the script works on
    painter : which finds places
    """

    def __init__(self, desk: ScriptDesk, painter: Painter) -> None:
        self._desk, self._painter = desk, painter

    def namespace(self) -> dict[str, Callable[..., Any]]:
        """All of it by name."""
        return {
            "new_ring": self.new_ring,
            "new_jaw_force": self.new_jaw_force,
            "fit_muscles": self.fit_muscles,
            "compare_models": self.compare_models,
        }

    def new_ring(self, title: str, centre: Where, tip: Where, height: float, group: str = "lip") -> MuscleHandle:
        """A new sphincter about a place on the skin, its long half axis to another, and so many millimetres high."""
        project = self._desk.project
        ring = laid_ring(project.face, self._painter.place(centre), self._painter.place(tip), height)
        made = collection.new_muscle(project, title, group, ring=ring)
        self._desk.edit(lambda before: collection.with_muscle(before, made), f"Lay {made.title}")
        return MuscleHandle(self._desk, made.key)

    def new_jaw_force(self) -> MuscleHandle:
        """A new muscle that pushes the skin over the mandible round the jaw's axis."""
        made = collection.jaw_muscle(self._desk.project)
        self._desk.edit(lambda before: collection.with_muscle(before, made), f"Lay {made.title}")
        return MuscleHandle(self._desk, made.key)

    def fit_muscles(self, source: str, keeping: Keeping = "same") -> tuple[str, ...]:
        """Take the muscles of a shipped individual, or of a project's file, fitted to this head; returns the report.

        Own muscles of the ``same`` names are replaced, or all ``others`` stay and only what is missing comes, or
        ``none`` of them is kept.
        """
        other = new_project(source) if source in face_keys() else load_project(Path(source))
        fitted = with_fitted_muscles(self._desk.project, other, keeping)
        self._desk.edit(lambda _: fitted.project, f"Fit muscles of {other.face.title}")
        return fitted.fit.sentences

    def compare_models(self, key: str) -> dict[str, tuple[float, float | None]]:
        """What a muscle does under each of its models: the largest displacement in millimetres, and the cosine to
        the field of the model in use.
        """
        project = self._desk.project
        fields = model_fields(project, collection.muscle_of(project, key)).fields
        return {str(model): (field.largest, field.cosine) for model, field in fields.items()}
