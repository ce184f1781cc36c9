"""How a capture becomes weights of the face: a table that can be edited while face and timeline show what it does."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QHeaderView,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from app.actions.context import FileQuestion, Host
from app.authoring.importing import Imported, with_capture
from app.film.order import counted
from app.timeline.exchange import Again
from app.timeline.timeline import LiveChange, Timeline
from facemodel.animation.capture import KIND_TITLES, Capture
from facemodel.animation.mapping import Mapping, MapRow, default_mapping
from facemodel.errors import ProjectError
from facemodel.io.weights.mapping_file import load_mapping, save_mapping
from ui.theme.metrics import GRID, ROW
from ui.timeline.dialogs.aside import stand_aside
from ui.timeline.dialogs.mapping_table import MappingTable
from ui.timeline.dialogs.rest_row import RestRow
from ui.timeline.inspector.page import push_button
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale
from ui.widgets.plain_label import PlainLabel

REST = 200
"""Milliseconds after an edit until the capture is mapped anew: ten minutes of it take a while."""

SMOOTHING = NumberScale(0.0, 0.5, 0.0, "s", bend=2.0)
START = NumberScale(0.0, 60.0, 0.0, "s", bend=2.0)


class MappingPage(QDialog):
    """Asks how a capture is to be taken in; until it is closed the timeline shows it as a preview.

    The window stays in reach, so that one can scrub and play meanwhile.  Whoever changes the project there takes the
    capture in as it is seen.

    Parameters
    ----------
    timeline : what it comes into
    host : asks for files of tables
    capture, path : what was read, and from where
    again : reads it again for another moment of rest
    """

    def __init__(
        self, parent: QWidget, timeline: Timeline, host: Host, capture: Capture, path: Path, again: Again
    ) -> None:
        super().__init__(parent)
        self._timeline, self._host, self._capture = timeline, host, capture
        project = timeline.document.project
        self._live = LiveChange(timeline, f"Import {path.name}")
        self._base, self._again = project, again
        self._showing = self._over = False
        self.table = MappingTable(_rows_of(capture), capture, project.units)
        self.setWindowTitle("Import weights over time")
        self.resize(86 * GRID, 64 * GRID)
        self.view = QTableView()
        self.smoothing, self.start = NumberBar("Smoothing", SMOOTHING), NumberBar("Begins at", START)
        self.smoothing.set_value(self.table.mapping.smoothing)
        self.start.set_value(capture.start)
        self.rest = None if capture.rest is None else RestRow(capture.duration, capture.rest)
        self.notes = PlainLabel()
        self.name = PlainLabel()
        self._timer = QTimer(self, singleShot=True, interval=REST)
        self._timer.timeout.connect(self.preview)
        self._lay_out(path)
        self.table.edited.connect(lambda _mapping: self._timer.start())
        self.smoothing.previewed.connect(lambda _value: self._timer.start())
        self.start.previewed.connect(lambda _value: self._timer.start())
        if self.rest is not None:
            self.rest.looked.connect(lambda seconds: timeline.playhead.go(self.start.value + seconds))
            self.rest.chosen.connect(self._compare)
            self.rest.at_playhead.connect(self._rest_here)
        self.preview()
        timeline.document.history_changed.connect(self._settle)
        timeline.document.project_changed.connect(self._settle)

    @property
    def mapping(self) -> Mapping:
        """The table as it is now."""
        own = self.table.mapping
        return Mapping(own.name, own.rows, self.smoothing.value)

    def showEvent(self, event: QShowEvent) -> None:
        """Stand at the upper right, so that the face and the timeline can be seen to move."""
        super().showEvent(event)
        stand_aside(self)

    def preview(self) -> None:
        """Show what the capture looks like on this face."""
        self._timer.stop()
        found: Imported = with_capture(self._base, self._capture, self.mapping, self.start.value)
        self._showing = True
        try:
            self._live.show(found.project.animation)
        finally:
            self._showing = False
        tracks = sum(track.captured is not None for track in found.project.animation.tracks)
        self.notes.setText(
            "  ".join((f"{counted(tracks, 'channel')} {'moves' if tracks == 1 else 'move'}.", *found.notes))
        )

    def accept(self) -> None:
        """Take it in as it is seen."""
        self.preview()
        super().accept()

    def done(self, how: int) -> None:
        """Close; what was not taken in goes."""
        self._timer.stop()
        self._over = True
        document = self._timeline.document
        document.history_changed.disconnect(self._settle)
        document.project_changed.disconnect(self._settle)
        if how != QDialog.DialogCode.Accepted:
            self._live.cancel()
        super().done(how)

    def _settle(self, *_what: object) -> None:
        """The project was changed elsewhere: what is seen of the capture stays, and the change stands over it."""
        if not self._showing:
            self.done(QDialog.DialogCode.Accepted)

    def _compare(self, rest: float) -> None:
        """Have the landmarks compared with the face at rest at another moment; until then the old ones are seen."""
        self.notes.setText(f"Compared with the face at rest at {rest:.2f} s …")
        self._again(rest, self._take_capture)

    def _rest_here(self) -> None:
        assert self.rest is not None
        self.rest.choose(self._timeline.playhead.time - self.start.value)

    def _take_capture(self, capture: Capture) -> None:
        if not self._over:
            self._capture = capture
            self.preview()

    def load(self) -> None:
        """Ask for a table and use it."""
        path = self._host.ask_path(FileQuestion("Open mapping table", "Mapping table", ".json", Path.home(), False))
        if path is None:
            return
        try:
            self._take(load_mapping(path))
        except ProjectError as error:
            self._host.show_error(str(error))

    def save(self) -> None:
        """Ask for a file and keep the table in it."""
        start = Path.home() / f"{self._capture.kind} mapping.json"
        path = self._host.ask_path(FileQuestion("Save mapping table", "Mapping table", ".json", start, True))
        if path is None:
            return
        try:
            save_mapping(self.mapping, path)
        except ProjectError as error:
            self._host.show_error(str(error))

    def _take(self, mapping: Mapping) -> None:
        self.table.take(mapping)
        self.smoothing.set_value(mapping.smoothing)
        self.name.setText(mapping.name)
        self.preview()

    def _remove(self) -> None:
        places = {index.row() for index in self.view.selectionModel().selectedIndexes()}
        if places:
            self.table.remove_rows(sorted(places))

    def _lay_out(self, path: Path) -> None:
        capture = self._capture
        title = PlainLabel(path.name)
        title.setProperty("role", "title")
        seconds = f"{capture.duration:.1f} s" if capture.duration < 60 else f"{capture.duration / 60:.1f} min"
        frames = f"{len(capture.values):,} frames at {capture.rate:g} a second, {seconds}"
        about = PlainLabel(f"{KIND_TITLES[capture.kind]} · {counted(len(capture.channels), 'channel')} · {frames}")
        about.setProperty("role", "muted")
        self.name.setText(self.table.mapping.name)
        self.notes.setWordWrap(True)
        self.notes.setProperty("role", "muted")
        self._dress_view()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(3 * GRID, 2 * GRID, 3 * GRID, 2 * GRID)
        layout.setSpacing(GRID)
        for widget in (title, about):
            layout.addWidget(widget)
        layout.addLayout(self._tools())
        layout.addWidget(self.view, 1)
        bars = QHBoxLayout()
        bars.addWidget(self.smoothing)
        bars.addWidget(self.start)
        layout.addLayout(bars)
        if self.rest is not None:
            layout.addWidget(self.rest)
        layout.addWidget(self.notes)
        layout.addWidget(self._buttons())

    def _dress_view(self) -> None:
        view = self.view
        view.setModel(self.table)
        view.setAccessibleName("Mapping table")
        view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        view.setShowGrid(False)
        view.verticalHeader().hide()
        view.verticalHeader().setDefaultSectionSize(ROW)
        head = view.horizontalHeader()
        head.setHighlightSections(False)
        head.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        head.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        head.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        for column, width in ((2, 8), (3, 8), (4, 8), (5, 9)):
            view.setColumnWidth(column, width * GRID)

    def _tools(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(GRID)
        row.addWidget(self.name, 1)
        first = self._capture.channels[0] if self._capture.channels else ""
        usual = _rows_of(self._capture)
        for text, act, tip in (
            ("Add row", lambda: self.table.add_row(first), "One more row"),
            ("Remove", self._remove, "Take the selected rows out"),
            ("Default", lambda: self._take(usual), "The table that ships"),
            ("Open…", self.load, "A table from a file"),
            ("Save…", self.save, "Keep this table in a file"),
        ):
            row.addWidget(push_button(text, act, tip))
        return row

    def _buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.take_in = buttons.addButton("Import", QDialogButtonBox.ButtonRole.AcceptRole)
        self.take_in.setDefault(True)
        self.take_in.setFocus()
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        return buttons


def _rows_of(capture: Capture) -> Mapping:
    """The table that ships for a capture; of a plain one, a row for every channel."""
    usual = default_mapping(capture.kind)
    if usual.rows:
        return usual
    return Mapping(usual.name, tuple(MapRow(name, name) for name in capture.channels), usual.smoothing)
