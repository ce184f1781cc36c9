"""What actions ask of the window."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtGui import QGuiApplication

from app.actions.context import Answer, FileQuestion, Merge
from app.authoring.fitted_muscles import Fitted
from facemodel.actions import ActionUnit
from facemodel.project import Project
from ui.panels.actions.merge_page import ask_merge
from ui.panels.export.page import ExportPage
from ui.panels.muscles.fitting_page import ask_fitting
from ui.window import dialogs
from ui.window.about_page import about_page
from ui.window.delivery import UiThread
from ui.window.performing import perform
from ui.window.shortcut_page import ShortcutPage

if TYPE_CHECKING:
    from ui.window.main_window import MainWindow


class WindowHost:
    """`app.actions.context.Host` for one main window.

    Parameters
    ----------
    window : its parts may still be under construction; they are reached when an action asks for them
    """

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._export: ExportPage | None = None

    def ask_path(self, question: FileQuestion) -> Path | None:
        """A file; none if the person thought better of it."""
        return dialogs.ask_path(self._window, question)

    def ask_unsaved(self, name: str) -> Answer:
        """What to do with the unsaved changes of a document."""
        return dialogs.ask_unsaved(self._window, name)

    def ask_merge(self, unit: ActionUnit, others: Sequence[ActionUnit]) -> Merge | None:
        """Which action unit goes into another one, and how much of both; none if the person thought better of it."""
        return ask_merge(self._window, unit, others)

    def show_error(self, sentence: str) -> None:
        """Show what went wrong."""
        dialogs.show_error(self._window, sentence)

    def show_message(self, sentence: str) -> None:
        """Say something in passing."""
        self._window.status.notify(sentence)

    def clipboard(self) -> str:
        """The text in the clipboard."""
        return QGuiApplication.clipboard().text()

    def set_clipboard(self, text: str) -> None:
        """Put text into the clipboard."""
        QGuiApplication.clipboard().setText(text)

    def save_picture(self, path: Path) -> None:
        """Write what the viewport shows as a PNG; raises `RisoriusError` if that fails."""
        self._window.viewport.save_picture(path)

    def show_export(self) -> None:
        """Open the page that exports the animation; there is one, so that it remembers what was chosen."""
        if self._export is None:
            self._export = ExportPage(self._window, self._window.context, UiThread(self._window).deliver)
            self._window.closed.connect(self._export.shut)
        self._export.refresh()
        self._export.show()
        self._export.raise_()
        self._export.activateWindow()

    def perform(self) -> None:
        """Open the timeline and play what is open, as soon as its face is solved."""
        perform(self._window)

    def may_stop_export(self) -> bool:
        """Ask whether an export may be stopped; nobody is asked where none is under way."""
        name = self._export.exporting if self._export is not None else ""
        return not name or dialogs.ask_stop(self._window, name)

    def frame_head(self) -> None:
        """Show the whole head."""
        self._window.viewport.frame_head()

    def frame_selection(self) -> None:
        """Bring the selected muscle, or else the face, near."""
        self._window.viewport.frame_selection()

    def focus_search(self) -> None:
        """Put the keyboard into the search over the action units."""
        self._window.show_workspace("expression")
        self._window.expression.focus_search()

    def focus_unit(self, number: int) -> None:
        """Show the row of an action unit and put the keyboard on its slider."""
        self._window.show_workspace("expression")
        self._window.expression.focus_unit(number)

    def ask_fitting(self, project: Project, folder: Path) -> Fitted | None:
        """A project with muscles of another head, fitted to its own; none if the person thought better of it."""
        return ask_fitting(self._window, project, folder)

    def compare_models(self) -> None:
        """Show the models of the selected muscle side by side."""
        self._window.show_workspace("muscles")
        self._window.panels.panel("muscles").compared.emit()

    def show_palette(self) -> None:
        """Open the command palette."""
        self._window.palette_box.open_palette()

    def show_face_information(self) -> None:
        """Show the figures of the face."""
        self._window.arrangement.show("information")

    def show_shortcuts(self) -> None:
        """Show all keys."""
        ShortcutPage(self._window, self._window.binding, self._window.context.settings).exec()

    def show_about(self) -> None:
        """Show version and licences."""
        about_page(self._window).exec()

    def reset_layout(self) -> None:
        """Put all panels where they were at the first start."""
        self._window.arrangement.reset()

    def toggle_full_screen(self) -> None:
        """Fill the screen, or leave it."""
        if self._window.isFullScreen():
            self._window.showNormal()
        else:
            self._window.showFullScreen()

    def quit(self) -> None:
        """Close the window, which asks about unsaved changes."""
        self._window.close()
