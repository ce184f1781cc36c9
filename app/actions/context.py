"""What actions act on, and what they ask of the window."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Protocol

from psygnal import SignalInstance

from app.authoring.fitted_muscles import Fitted
from app.document import Document
from app.settings import UserSettings
from app.solving import Solving
from app.view import View
from facemodel.actions import ActionUnit
from facemodel.project import Project

Answer = Literal["save", "discard", "cancel"]


@dataclass(frozen=True)
class FileQuestion:
    """Which file a person is asked for.

    Attributes
    ----------
    title : of the dialog
    kind : what such files are called, for example ``Risorius project``
    suffix : their ending, with the dot
    start : the file or folder to begin with
    writes : whether the file is to be written
    also : further endings that such files may have
    """

    title: str
    kind: str
    suffix: str
    start: Path
    writes: bool
    also: tuple[str, ...] = ()


@dataclass(frozen=True)
class Merge:
    """How one action unit is made of two.

    Attributes
    ----------
    other : number of the one that goes into the first and is gone then
    own, share : how much of the first and of the other one is taken; 1 is all of it
    """

    other: int
    own: float = 1.0
    share: float = 1.0


class Host(Protocol):
    """Services of the window.  Questions return when they are answered."""

    def ask_path(self, question: FileQuestion) -> Path | None:
        """A file; none if the person thought better of it."""

    def ask_unsaved(self, name: str) -> Answer:
        """What to do with the unsaved changes of a document."""

    def ask_merge(self, unit: ActionUnit, others: Sequence[ActionUnit]) -> Merge | None:
        """Which action unit goes into another one, and how much of both; none if the person thought better of it."""

    def show_error(self, sentence: str) -> None:
        """Show what went wrong."""

    def show_message(self, sentence: str) -> None:
        """Say something in passing."""

    def clipboard(self) -> str:
        """The text in the clipboard."""

    def set_clipboard(self, text: str) -> None:
        """Put text into the clipboard."""

    def save_picture(self, path: Path) -> None:
        """Write what the viewport shows as a PNG; raises `RisoriusError` if that fails."""

    def show_export(self) -> None:
        """Open the page that exports the animation."""

    def perform(self) -> None:
        """Open the timeline and play what is open, as soon as its face is solved."""

    def may_stop_export(self) -> bool:
        """Ask whether an export may be stopped; nobody is asked where none is under way."""

    def frame_head(self) -> None:
        """Show the whole head."""

    def frame_selection(self) -> None:
        """Bring the selected muscle, or else the face, near."""

    def focus_search(self) -> None:
        """Put the keyboard into the search over the action units."""

    def focus_unit(self, number: int) -> None:
        """Show the row of an action unit and put the keyboard on its slider."""

    def ask_fitting(self, project: Project, folder: Path) -> Fitted | None:
        """A project with muscles of another head, fitted to its own; none if the person thought better of it."""

    def compare_models(self) -> None:
        """Show the models of the selected muscle side by side."""

    def show_palette(self) -> None:
        """Open the command palette."""

    def show_face_information(self) -> None:
        """Show the figures of the face."""

    def show_shortcuts(self) -> None:
        """Show all keys."""

    def show_about(self) -> None:
        """Show version and licences."""

    def reset_layout(self) -> None:
        """Put all panels where they were at the first start."""

    def toggle_full_screen(self) -> None:
        """Fill the screen, or leave it."""

    def quit(self) -> None:
        """Close the window, which asks about unsaved changes."""


@dataclass(frozen=True, eq=False)
class Context:
    """What actions act on."""

    document: Document
    view: View
    settings: UserSettings
    solving: Solving
    host: Host


def state_signals(context: Context) -> tuple[SignalInstance, ...]:
    """The signals after which an action may be possible, on, or called something else than before."""
    document, job = context.document, context.solving.job
    return (
        document.project_changed,
        document.muscles_changed,
        document.units_changed,
        document.emotions_changed,
        document.expression_changed,
        document.solution_changed,
        document.history_changed,
        document.saved_changed,
        context.view.changed,
        context.settings.changed,
        job.started,
        job.finished,
        job.failed,
        job.cancelled,
    )


def table_signals(context: Context) -> tuple[SignalInstance, ...]:
    """The signals after which there may be other actions than before."""
    document = context.document
    return (
        document.project_changed,
        document.muscles_changed,
        document.units_changed,
        document.emotions_changed,
        context.settings.changed,
    )
