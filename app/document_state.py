"""What a document is at a moment, as everyone may read it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from app.differences import same_content
from app.history import History
from app.signals import DocumentSignals
from app.solved import Solutions
from app.weights import in_order
from facemodel.actions import Expression
from facemodel.project import Project
from facemodel.solve import Solution
from fem.types import Float32Array

Keying = Callable[[Project, Expression], Project]
"""Makes keys of weights by field."""


class DocumentState(DocumentSignals):
    """The part of a document that is only read; `app.document.Document` adds what is done to it.

    Parameters
    ----------
    project : what to start with
    path : the file it came from, if any

    Attributes
    ----------
    keying : while it is given, weights that people set become keys as it makes them, and sliders stay
    """

    def __init__(self, project: Project, path: Path | None = None) -> None:
        self._project: Project = in_order(project)
        self._saved: Project | None = self._project
        self._path = path
        self._history = History()
        self._played: dict[str, float] = {}
        self.keying: Keying | None = None
        self._held: dict[str, float] = {}
        self._shown: Expression = project.expression
        self._solutions = Solutions(self._project)

    @property
    def project(self) -> Project:
        """What would be saved."""
        return self._project

    @property
    def path(self) -> Path | None:
        """The file it was read from or last written to."""
        return self._path

    @property
    def name(self) -> str:
        """What people call it: its file's name, or that it has none yet."""
        return self._path.stem if self._path else f"Untitled, {self._project.face.title}"

    @property
    def history(self) -> History:
        """Steps that can be undone and redone; to be read."""
        return self._history

    @property
    def dirty(self) -> bool:
        """Whether it differs from what was last saved, read or begun."""
        if self._history.at_saved:
            return False
        return self._saved is None or not same_content(self._project, self._saved)

    @property
    def shown(self) -> Expression:
        """The expression to draw: the project's own, over it what is played, over that the weights that are held."""
        return self._shown

    @property
    def held(self) -> bool:
        """Whether weights are held that are not committed."""
        return bool(self._held)

    @property
    def solution(self) -> Solution | None:
        """The last solution for this head with what is sculpted on it, even if `stale`; the last good face stays."""
        return self._solutions.shown

    @property
    def previous_solution(self) -> Solution | None:
        """The solution for this head before the last one, with the same corrections; none if there was only one."""
        return self._solutions.before(self._project)

    @property
    def solved(self) -> Solution | None:
        """The last solution as it was solved, without what is sculpted on it."""
        return self._solutions.last.solution if self._solutions.last else None

    @property
    def stale(self) -> bool:
        """Whether the project has to be solved: it never was, or what fields depend on changed since."""
        return self._solutions.stale

    @property
    def stale_fields(self) -> frozenset[str]:
        """Fields that the solution does not hold for; the others can be trusted as they are drawn."""
        return self._solutions.stale_fields

    def last_change_map(self) -> Float32Array | None:
        """How far (P,) the last solve moved every drawn point of the skin under what is shown, millimetres.

        None as long as there is nothing to compare.
        """
        return self._solutions.last_change(self._shown)
