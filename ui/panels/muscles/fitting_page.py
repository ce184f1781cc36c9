"""A question: from which head muscles are taken, with a report of how they fit before anything is changed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.actions.context import FileQuestion
from app.actions.files import PROJECT, SUFFIX
from app.authoring.fitted_muscles import Fitted, Keeping, with_fitted_muscles
from app.jobs import Failure, Job
from facemodel.faces import face_keys
from facemodel.io.project_file import load_project
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solution import Progress
from ui.theme.metrics import GRID
from ui.widgets.plain_label import PlainLabel
from ui.window.delivery import UiThread
from ui.window.dialogs import ask_path

WIDTH = 56 * GRID
REPORT = 18 * GRID

KEEPING: dict[Keeping, str] = {
    "same": "Replace muscles of the same name, keep the others",
    "others": "Keep all muscles, add what is missing",
    "none": "Replace all muscles",
}


@dataclass(frozen=True, eq=False)
class FittingAsked:
    """What is to be fitted.

    Attributes
    ----------
    project : that gets muscles
    source : key of a shipped individual, or a project's file
    keeping : what becomes of the muscles that there are
    """

    project: Project
    source: str | Path
    keeping: Keeping


def fitted(asked: FittingAsked, progress: Progress) -> Fitted:
    """Read the other head and fit its muscles.

    Raises
    ------
    RisoriusError
        If its file cannot be read, or its muscles cannot be fitted.
    """
    progress("Reading the other head", 0.1)
    source = new_project(asked.source) if isinstance(asked.source, str) else load_project(asked.source)
    progress("Fitting its muscles", 0.5)
    return with_fitted_muscles(asked.project, source, asked.keeping)


class FittingPage(QDialog):
    """Asks for a head and fits its muscles in the background; the report is there before anything is changed."""

    def __init__(self, parent: QWidget | None, project: Project, folder: Path) -> None:
        super().__init__(parent)
        self.setWindowTitle("Fit muscles")
        self.setFixedWidth(WIDTH)
        self._project, self._folder = project, folder
        self._thread = UiThread(self)
        self.job: Job[FittingAsked, Fitted] = Job(fitted, self._thread.deliver)
        self.outcome: Fitted | None = None
        self.source = QComboBox()
        self.source.setAccessibleName("Head")
        for key in face_keys():
            self.source.addItem(f"The atlas of {key.capitalize()}", key)
        others = [place for place, key in enumerate(face_keys()) if key != project.face.key]
        self.source.setCurrentIndex(others[0] if others else 0)
        self.browse = QPushButton("A project…")
        self.browse.setAutoDefault(False)
        self.browse.setToolTip("Take the muscles of a project, whatever its head")
        self.keeping = QComboBox()
        self.keeping.setAccessibleName("Own muscles")
        for kept, title in KEEPING.items():
            self.keeping.addItem(title, kept)
        self.report = PlainLabel()
        self.report.setWordWrap(True)
        self.report.setProperty("role", "muted")
        self.report.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._told = QScrollArea()
        self._told.setWidgetResizable(True)
        self._told.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._told.setWidget(self.report)
        self._told.setFixedHeight(REPORT)
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.fit = self.buttons.addButton("Fit muscles", QDialogButtonBox.ButtonRole.AcceptRole)
        self.fit.setDefault(True)
        self._lay_out()
        self._connect()
        self.ask()

    def ask(self) -> None:
        """Fit anew what is chosen now."""
        self.outcome = None
        self.fit.setEnabled(False)
        self.job.request(FittingAsked(self._project, self.source.currentData(), self.keeping.currentData()))

    def take_file(self, path: Path) -> None:
        """Choose the muscles of a project's file."""
        place = self.source.findData(path)
        if place < 0:
            self.source.addItem(path.stem, path)
            place = self.source.count() - 1
        self.source.setCurrentIndex(place)
        self.ask()

    def done(self, result: int) -> None:
        """Wait for nothing any more."""
        self.job.close()
        super().done(result)

    def _connect(self) -> None:
        self.source.activated.connect(lambda _row: self.ask())
        self.keeping.activated.connect(lambda _row: self.ask())
        self.browse.clicked.connect(self._browse)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        self.job.progress.connect(lambda text, _share: self._say(f"{text} …", "muted"))
        self.job.finished.connect(self._show)
        self.job.failed.connect(self._fail)

    def _browse(self) -> None:
        path = ask_path(self, FileQuestion("Muscles of a project", PROJECT, SUFFIX, self._folder, writes=False))
        if path is not None:
            self.take_file(path)

    def _show(self, outcome: Fitted, _asked: FittingAsked) -> None:
        self.outcome = outcome
        self.fit.setEnabled(True)
        self._say("\n".join(outcome.fit.sentences), "")

    def _fail(self, failure: Failure) -> None:
        self._say(failure.sentence, "error")

    def _say(self, words: str, role: str) -> None:
        self.report.setText(words)
        self.report.setProperty("role", role)
        self.report.style().unpolish(self.report)
        self.report.style().polish(self.report)

    def _lay_out(self) -> None:
        title = PlainLabel(f"Fit muscles to {self._project.face.title}")
        title.setProperty("role", "title")
        words = QLabel(
            "They are carried by landmarks, scaled differently in width, height and depth, and laid on bone and skin "
            "again. One step of undo takes all of it back."
        )
        words.setWordWrap(True)
        words.setProperty("role", "muted")
        line = QHBoxLayout()
        line.setSpacing(GRID)
        line.addWidget(self.source, 1)
        line.addWidget(self.browse)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 2 * GRID)
        layout.setSpacing(GRID)
        layout.addWidget(title)
        layout.addWidget(words)
        layout.addLayout(line)
        layout.addWidget(self.keeping)
        layout.addSpacing(GRID)
        layout.addWidget(self._told)
        layout.addWidget(self.buttons)


def ask_fitting(parent: QWidget, project: Project, folder: Path) -> Fitted | None:
    """Ask from which head muscles are taken; none if the person thought better of it."""
    page = FittingPage(parent, project, folder)
    return page.outcome if page.exec() == QDialog.DialogCode.Accepted else None
