"""What the command line needs from a program that can draw; it is handed in, since nothing here may know how."""

from __future__ import annotations

from collections.abc import Callable, Set
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from app.film.shoot import Draw
from app.view_state import ViewName
from facemodel.actions import Expression
from facemodel.project import Project
from facemodel.solve import Solution


class Render(Protocol):
    """Draws one picture into a file."""

    def __call__(
        self,
        project: Project,
        solution: Solution,
        expression: Expression,
        path: Path,
        view: ViewName,
        size: tuple[int, int],
        show: Set[str],
        linear: bool,
    ) -> None:
        """Draw ``expression`` seen from ``view``, ``size`` pixels wide and high, with the overlays ``show``.

        ``linear`` leaves it at the pure linear sum of the fields.
        """


class Gallery(Protocol):
    """Draws the sheet of all action units and emotions into a file."""

    def __call__(self, project: Project, solution: Solution, path: Path) -> None:
        """Draw the sheet."""


class Edit(Protocol):
    """Opens the editor."""

    def __call__(self, path: Path | None, project: Project | None = None) -> int:
        """Open a file, or a project that has none, or the default face; return the exit status when it is closed."""


@dataclass(frozen=True)
class Screen:
    """The commands that draw.

    Attributes
    ----------
    render, gallery, edit, frames : see their types
    displays : whether there is a display on which the editor can open
    """

    render: Render
    gallery: Gallery
    edit: Edit
    frames: Draw
    displays: Callable[[], bool]
