"""What the sounds of speech look like: each viseme with its symbols, its weights and how much it decides."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.expression_text import format_expression, parse_expression
from app.timeline.chosen import Chosen
from app.timeline.moving import Edited
from app.timeline.readings import Reading
from app.timeline.timeline import Timeline
from facemodel.actions import expand
from facemodel.animation.clip import Animation
from facemodel.animation.editing.speech import with_viseme, with_visemes
from facemodel.animation.speech import Viseme
from facemodel.animation.visemes import mouth_table
from facemodel.errors import RisoriusError
from ui.theme.metrics import GRID, ROW
from ui.timeline.dialogs.aside import stand_aside
from ui.timeline.inspector.field import FieldBar
from ui.timeline.inspector.page import push_button
from ui.widgets.number_scale import NumberScale
from ui.widgets.plain_label import PlainLabel

DOMINANCE = NumberScale(0.0, 1.0, 0.5)


class VisemePage(QDialog):
    """Edits the visemes of an animation, which speaks with them at once; every change is one step.

    The window stays in reach.  While a viseme is in hand the face looks like it; that is no step, and ends when time
    moves on, somebody sets weights, or this closes.

    Parameters
    ----------
    timeline : whose visemes they are
    """

    def __init__(self, parent: QWidget, timeline: Timeline) -> None:
        super().__init__(parent)
        self._timeline = timeline
        self._seen: Viseme | None = None
        self.setWindowTitle("Visemes")
        self.resize(72 * GRID, 60 * GRID)
        self.list = QListWidget()
        self.list.setAccessibleName("Visemes")
        self.list.setFixedWidth(14 * GRID)
        self.symbols, self.weights = QLineEdit(), QLineEdit()
        self.symbols.setAccessibleName("Symbols")
        self.weights.setAccessibleName("Weights")
        self._fill()
        self.list.setCurrentRow(1 if self.list.count() > 1 else 0)
        self.dominance = FieldBar(timeline, "Dominance", DOMINANCE, self._dominance, self._with_dominance)
        self.closes = QCheckBox("The lips have to meet")
        self.complaint = PlainLabel()
        self.complaint.setWordWrap(True)
        self.complaint.setProperty("role", "error")
        self._lay_out()
        self._open()
        self.list.currentRowChanged.connect(lambda _row: self._open())
        self.symbols.editingFinished.connect(self._take)
        self.weights.editingFinished.connect(self._take)
        self.closes.toggled.connect(lambda _on: self._take())
        for signal in (timeline.document.animation_changed, timeline.document.project_changed):
            signal.connect(self._follow)

    @property
    def visemes(self) -> tuple[Viseme, ...]:
        """All of them."""
        return self._timeline.animation.speech.visemes or mouth_table().visemes

    @property
    def viseme(self) -> Viseme:
        """The one in hand."""
        return self.visemes[self.list.currentRow()]

    def showEvent(self, event: QShowEvent) -> None:
        """Stand at the upper right, so that the face is seen."""
        super().showEvent(event)
        stand_aside(self)

    def done(self, how: int) -> None:
        """Let the face go back to what it does now."""
        document = self._timeline.document
        for signal in (document.animation_changed, document.project_changed):
            signal.disconnect(self._follow)
        self._timeline.playhead.show()
        super().done(how)

    def take_face(self) -> None:
        """Let the viseme in hand look as the face does."""
        shown = {name: weight for name, weight in self._timeline.document.shown.items() if weight}
        self._change(replace(self.viseme, weights=shown))

    def show_face(self) -> None:
        """Let the face look like the viseme in hand."""
        units = self._timeline.document.project.units
        neutral = {name: 0.0 for unit in units for name in unit.fields}
        self._timeline.document.play({**neutral, **expand(self.viseme.weights, units)})

    def restore(self) -> None:
        """Go back to the set that ships."""
        self._timeline.edit(with_visemes(self._timeline.animation, ()), "Visemes that ship")

    def _follow(self, *_what: object) -> None:
        """Another animation: show what it has, and the face as the viseme in hand if that is another one."""
        if [viseme.name for viseme in self.visemes] != [self.list.item(k).text() for k in range(self.list.count())]:
            self._fill()
        self.dominance.refresh()
        if self.viseme != self._seen:
            self._open()

    def _open(self) -> None:
        viseme, units = self.viseme, self._timeline.document.project.units
        self._seen = viseme
        self.symbols.setText(" ".join(symbol for symbol in viseme.symbols if symbol))
        self.weights.setText(format_expression(expand(viseme.weights, units), units))
        self.closes.blockSignals(True)
        self.closes.setChecked(viseme.closes)
        self.closes.blockSignals(False)
        self.dominance.refresh()
        self.complaint.setText("")
        self.show_face()

    def _take(self) -> None:
        """Take what the fields say."""
        units = self._timeline.document.project.units
        try:
            weights = parse_expression(self.weights.text(), units) if self.weights.text().strip() else {}
        except RisoriusError as error:
            self.complaint.setText(str(error))
            return
        self.complaint.setText("")
        before = self.viseme
        kept = ("",) if "" in before.symbols else ()
        same = format_expression(expand(before.weights, units), units) == self.weights.text()
        self._change(
            replace(
                before,
                symbols=(*kept, *self.symbols.text().split()),
                weights=before.weights if same else weights,
                closes=self.closes.isChecked(),
            )
        )

    def _change(self, viseme: Viseme) -> None:
        if viseme != self.viseme:
            self._timeline.edit(with_viseme(self._timeline.animation, viseme), f"Viseme {viseme.name}")

    def _dominance(self, _animation: Animation, _chosen: Chosen) -> Reading:
        return Reading(self.viseme.dominance)

    def _with_dominance(self, animation: Animation, chosen: Chosen, value: float) -> Edited:
        return with_viseme(animation, replace(self.viseme, dominance=value)), chosen

    def _fill(self) -> None:
        """List all, without a word about which one is in hand meanwhile."""
        row = max(self.list.currentRow(), 0)
        self.list.blockSignals(True)
        self.list.clear()
        for viseme in self.visemes:
            line = QListWidgetItem(viseme.name, self.list)
            line.setSizeHint(QSize(0, ROW))
        self.list.setCurrentRow(min(row, self.list.count() - 1))
        self.list.blockSignals(False)

    def _lay_out(self) -> None:
        right = QVBoxLayout()
        right.setSpacing(GRID)
        for text, widget in (
            ("Sounds that look like it, in ARPAbet and IPA", self.symbols),
            ("Weights, such as 25=0.6 26=0.3", self.weights),
        ):
            label = QLabel(text)
            label.setProperty("role", "muted")
            right.addWidget(label)
            right.addWidget(widget)
        right.addWidget(self.dominance)
        right.addWidget(self.closes)
        row = QHBoxLayout()
        row.addWidget(push_button("Take from the face", self.take_face, "Let it look as the face does now"))
        row.addWidget(push_button("Show on the face", self.show_face, "Look at it"))
        right.addLayout(row)
        right.addWidget(self.complaint)
        right.addStretch(1)
        right.addWidget(push_button("Go back to the set that ships", self.restore), 0, Qt.AlignmentFlag.AlignLeft)
        inner = QHBoxLayout()
        inner.setSpacing(2 * GRID)
        inner.addWidget(self.list)
        inner.addLayout(right, 1)
        buttons = QDialogButtonBox()
        buttons.addButton(push_button("Close", self.reject), QDialogButtonBox.ButtonRole.RejectRole)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(3 * GRID, 2 * GRID, 3 * GRID, 2 * GRID)
        layout.addLayout(inner, 1)
        layout.addWidget(buttons)
