"""The page that exports the animation of the open project, in the background."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QDialog, QHBoxLayout, QLabel, QLineEdit, QPushButton, QVBoxLayout, QWidget

from app.actions.context import Context, FileQuestion
from app.actions.paths import folder, with_suffix
from app.film.elsewhere import Errand, run_errand
from app.film.order import KINDS, Order, OrderKind, counted
from app.jobs import Deliver, Failure, Job
from facemodel.io.export import Asked
from facemodel.io.sequence import numbered
from ui.panels.export.film_box import FilmBox
from ui.panels.export.form import Form, choice, part_groups
from ui.panels.export.frames_box import FramesBox
from ui.panels.export.model_box import ModelBox
from ui.panels.export.progress_line import ProgressLine
from ui.theme.metrics import GRID

WIDTH = 60 * GRID

Work = Job[Errand, str]


class ExportPage(QDialog):
    """Asks what is to be made of the animation and has it made while work goes on.

    Parameters
    ----------
    parent : the window it belongs to
    context : what is open, and services of the window
    deliver : brings calls from other threads to this one
    """

    def __init__(self, parent: QWidget, context: Context, deliver: Deliver) -> None:
        super().__init__(parent)
        self._context = context
        self.job: Work = Job(run_errand, deliver)
        self._exporting = ""
        self.setWindowTitle("Export animation")
        self.setFixedWidth(WIDTH)
        self.kind = choice("Format", {kind.key: f"{kind.title} ({kind.suffix})" for kind in KINDS.values()})
        part_groups(self.kind, [kind.key for before, kind in pairwise(KINDS.values()) if before.group != kind.group])
        self.place = QLineEdit()
        self.place.setAccessibleName("File")
        self.browse = _button("Browse…", "Choose the file in the system's dialog", self._browse)
        self.holds = QLabel()
        self.holds.setProperty("role", "muted")
        self.holds.setWordWrap(True)
        self.frames, self.film, self.model = FramesBox(), FilmBox(), ModelBox()
        self.progress = ProgressLine()
        self.export = _button("Export", "Write the file; you can go on working meanwhile", self.start)
        self.export.setDefault(True)
        self.stop = _button("Cancel", "Stop the export; the file that was there before stays", self.job.cancel)
        self.leave = _button("Close", "An export that is under way goes on (Esc)", self.close)
        self._lay_out()
        self._connect()
        self._offer_place()
        self.refresh()

    @property
    def exporting(self) -> str:
        """The name of the file that is being exported; empty if none is."""
        return self._exporting if self.job.running else ""

    @property
    def order(self) -> Order:
        """What is asked for now."""
        shaping, most = self.model.chosen
        rate, span = self.frames.rate.value, self.frames.span
        asked = Asked(True, rate, span, shaping, most)
        film = replace(self.film.film, rate=rate, span=span)
        return Order(Path(self.place.text().strip()).expanduser(), self.chosen.key, film, asked)

    @property
    def chosen(self) -> OrderKind:
        """The format that is chosen."""
        return KINDS[self.kind.currentData()]

    def start(self) -> None:
        """Begin the export that is asked for."""
        if self.missing() or self.problem() or self.job.running:
            return
        document = self._context.document
        document.commit()
        assert document.solved is not None
        home = document.path.absolute().parent if document.path else None
        self.job.request(Errand(self.order, document.project, document.solved, home))

    def missing(self) -> str:
        """What has to come before there is anything to export; empty if it is there."""
        document = self._context.document
        if document.solved is None or document.stale:
            return "The face is being solved; wait a moment."
        turning = self.chosen.films and self.film.film.turns
        if not document.project.animation.moves and not turning:
            turntable = ", or film a turntable" if self.chosen.films else ""
            return f"Nothing moves yet: add keys, events or speech{turntable}."
        return ""

    def problem(self) -> str:
        """What is wrong with the order; empty if nothing is."""
        order = self.order
        if not self.place.text().strip() or order.out.suffix.lower() != self.chosen.suffix:
            return f"Name a file that ends in {self.chosen.suffix}."
        if not order.out.is_absolute():
            return "Name the file with its folder, from the first one on, or choose it with “Browse”."
        if not order.out.parent.is_dir():
            return f"There is no folder “{order.out.parent}”."
        if order.film.span is not None and order.film.span[1] <= order.film.span[0]:
            return "The range is empty; let it end after its begin."
        return ""

    def refresh(self, *_now: object) -> None:
        """Follow the document and what is chosen."""
        self.frames.follow(self._context.document.project.animation)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Go out of the way; an export goes on."""
        event.accept()

    def shut(self) -> None:
        """End with the window: an export is stopped, and leaves nothing behind."""
        self.job.cancel()
        self.job.close()
        self.close()

    def _follow(self) -> None:
        """Show what belongs to the format, and how it stands."""
        kind = self.chosen
        self.holds.setText(kind.holds[0].upper() + kind.holds[1:])
        self.film.setVisible(kind.films)
        self.model.setVisible(kind.shapes)
        audio = self._context.document.project.animation.audio
        silent = "The clip has no sound" if audio is None or audio.muted else "Pictures have no sound"
        self.film.offer_sound(audio is not None and not audio.muted and not kind.numbered, silent)
        self._stand()
        self.adjustSize()

    def _stand(self) -> None:
        """How it stands while nothing is done."""
        busy, missing, problem = self.job.running, self.missing(), self.problem()
        for part in (self.kind, self.place, self.browse, self.frames, self.film, self.model):
            part.setEnabled(not busy)
        self.export.setEnabled(not (busy or missing or problem))
        self.export.setVisible(not busy)
        self.stop.setVisible(busy)
        if not busy:
            self.progress.rest(missing or problem or self._summary(), bool(problem) and not missing)

    def _summary(self) -> str:
        order = self.order
        start, end = self.frames.span
        # The last frame of a film ends where the range does; a model has a key there.
        count = max(1, round((end - start) * self.frames.rate.value) + (not self.chosen.films))
        words = f"{counted(count, 'frame')}, {end - start:.2f} s"
        first = numbered(order.out, 1, count) if self.chosen.numbered else order.out
        return f"{words} · replaces the {first.name} that is there" if first.exists() else words

    def _offer_place(self) -> None:
        """A name in the folder of the last file, like the project's own."""
        document = self._context.document
        name = document.path.stem if document.path else document.project.face.key
        self.place.setText(str(folder(self._context) / f"{name}{self.chosen.suffix}"))

    def _take_kind(self, _index: int) -> None:
        text = self.place.text().strip()
        if text:
            self.place.setText(str(Path(text).with_suffix(self.chosen.suffix)))
        self._follow()

    def _browse(self) -> None:
        kind = self.chosen
        start = Path(self.place.text().strip() or folder(self._context))
        path = self._context.host.ask_path(
            FileQuestion("Export animation", kind.title, kind.suffix, start, writes=True)
        )
        if path is not None:
            self.place.setText(str(with_suffix(path, kind.suffix)))

    def _done(self, said: str, errand: Errand) -> None:
        self._stand()
        self.progress.rest(f"Exported {errand.order.out.name}: {said}.")
        self._context.host.show_message(f"Exported {errand.order.out.name}")

    def _failed(self, failure: Failure) -> None:
        self._stand()
        self.progress.rest(failure.sentence, wrong=True)
        if not self.isVisible():
            self._context.host.show_error(failure.sentence)

    def _cancelled(self) -> None:
        self._stand()
        self.progress.rest("The export was cancelled; nothing was written.")

    def _begun(self, errand: Errand) -> None:
        self._exporting = errand.order.out.name
        self._stand()
        self.progress.begin()

    def _connect(self) -> None:
        self.kind.activated.connect(self._take_kind)
        self.place.textChanged.connect(lambda _text: self._stand())
        for box in (self.frames, self.film, self.model):
            box.changed.connect(self._follow)
        job, document = self.job, self._context.document
        job.started.connect(self._begun)
        job.progress.connect(self.progress.show_share)
        job.finished.connect(self._done)
        job.failed.connect(self._failed)
        job.cancelled.connect(self._cancelled)
        for signal in (document.animation_changed, document.project_changed, document.solution_changed):
            signal.connect(self.refresh)

    def _lay_out(self) -> None:
        title = QLabel("Export animation")
        title.setProperty("role", "title")
        form = Form()
        form.row("Format", self.kind)
        form.row("", self.holds)
        form.row("File", _side_by_side(self.place, self.browse))
        foot = QHBoxLayout()
        foot.setSpacing(GRID)
        foot.addStretch(1)
        for button in (self.leave, self.stop, self.export):
            foot.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 2 * GRID)
        layout.setSpacing(0)
        layout.setAlignment(Qt.AlignmentFlag.AlignTop)
        layout.addWidget(title)
        layout.addSpacing(2 * GRID)
        layout.addLayout(form)
        for part in (self.frames, self.film, self.model):
            layout.addWidget(part)
        layout.addSpacing(2 * GRID)
        layout.addWidget(self.progress)
        layout.addSpacing(2 * GRID)
        layout.addLayout(foot)


def _side_by_side(field: QWidget, button: QWidget) -> QWidget:
    """A field that takes the room which a button leaves."""
    both = QWidget()
    line = QHBoxLayout(both)
    line.setContentsMargins(0, 0, 0, 0)
    line.setSpacing(GRID)
    line.addWidget(field, 1)
    line.addWidget(button)
    return both


def _button(text: str, tip: str, act: object) -> QPushButton:
    button = QPushButton(text)
    button.setAutoDefault(False)
    button.setToolTip(tip)
    button.clicked.connect(act)
    return button
