"""What a script works on: a document of its own, which becomes one step of the real one when all went well."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from app.document import Document
from app.tools.ground import Ground
from app.view import View
from facemodel.errors import FaceError
from facemodel.project import Project
from facemodel.solution import Solution


class ScriptDesk:
    """Lends the state of a document to one run of a script after the other.

    Parameters
    ----------
    document : the real one
    view : what is shown of it, if there is a window
    """

    def __init__(self, document: Document, view: View | None = None) -> None:
        self._real, self._view = document, view
        self._wanted: dict[str, Any] = {}
        self.document = Document(document.project, document.path)
        self.ground = Ground()

    @property
    def project(self) -> Project:
        """What the script has made so far."""
        return self.document.project

    def begin(self) -> None:
        """Start from what the real document is now."""
        self._real.commit()
        self._wanted = {}
        self.document = Document(self._real.project, self._real.path)

    def keep(self, label: str) -> None:
        """Make what was done one step of the real document; nothing if nothing was done."""
        self.document.commit()
        if self._view is not None:
            self._view.change(**self._wanted)
        if self.document.project is not self._real.project:
            self._real.edit(self.document.project, label)

    def show(self, what: str, **members: Any) -> None:
        """Change what is shown, if all of the script goes well; that is no step.

        Parameters
        ----------
        what : it shows, for people
        members : of the `ViewState`

        Raises
        ------
        FaceError
            If nothing is shown.
        """
        if self._view is None:
            raise FaceError(f"There is no window here that could show {what}; open the project in one.")
        self._wanted.update(members)

    def edit(self, change: Callable[[Project], Project], label: str) -> None:
        """Change the project by a pure function, as one step that the script itself may undo."""
        self.document.edit(change(self.document.project), label)

    def solved(self) -> Solution:
        """The solution of the real document without what is sculpted; raises `FaceError` as `solution` does."""
        whole = self.solution()
        return self._real.solved or whole

    def solution(self) -> Solution:
        """The solution of the real document.

        Raises
        ------
        FaceError
            If there is none that holds for what it is.
        """
        if self._real.solution is None or self._real.stale:
            raise FaceError("The face is not solved as it is now; wait for the solver, then ask again.")
        return self._real.solution

    @property
    def solved_as_it_is(self) -> bool:
        """Whether the script has left alone what the fields follow from."""
        own, real = self.project, self._real.project
        return all(
            mine is theirs
            for mine, theirs in (
                (own.face, real.face),
                (own.muscles, real.muscles),
                (own.units, real.units),
                (own.settings, real.settings),
            )
        )
