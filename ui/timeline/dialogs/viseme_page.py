"""What the sounds of speech look like: each viseme with its symbols, its weights and how much it decides."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QVBoxLayout,
    QWidget,
)

from app.expression_text import format_expression, parse_expression
from app.timeline.timeline import LiveChange, Timeline
from facemodel.actions import expand
from facemodel.animation.editing.speech import with_visemes
from facemodel.animation.speech import Viseme
from facemodel.animation.visemes import mouth_table
from facemodel.errors import RisoriusError
from ui.theme.metrics import GRID
from ui.timeline.inspector.page import push_button
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

DOMINANCE = NumberScale(0.0, 1.0, 0.5)


class VisemePage(QDialog):
    """Edits the visemes of an animation, which speaks with them at once; Cancel takes everything back.

    Parameters
    ----------
    timeline : whose visemes they are
    """

    def __init__(self, parent: QWidget, timeline: Timeline) -> None:
        super().__init__(parent)
        self._timeline = timeline
        self._live = LiveChange(timeline, "Visemes")
        self._visemes = list(timeline.animation.speech.visemes or mouth_table().visemes)
        self.setWindowTitle("Visemes")
        self.resize(72 * GRID, 52 * GRID)
        self.list = QListWidget()
        self.list.setAccessibleName("Visemes")
        self.list.setFixedWidth(14 * GRID)
        self.symbols, self.weights = QLineEdit(), QLineEdit()
        self.symbols.setAccessibleName("Symbols")
        self.weights.setAccessibleName("Weights")
        self.dominance = NumberBar("Dominance", DOMINANCE)
        self.closes = QCheckBox("The lips have to meet")
        self.complaint = QLabel()
        self.complaint.setWordWrap(True)
        self.complaint.setProperty("role", "error")
        self._lay_out()
        self._fill()
        self.list.currentRowChanged.connect(self._open)
        self.symbols.editingFinished.connect(self._take)
        self.weights.editingFinished.connect(self._take)
        self.dominance.committed.connect(self._take)
        self.closes.toggled.connect(lambda _on: self._take())
        self.list.setCurrentRow(1 if len(self._visemes) > 1 else 0)

    @property
    def viseme(self) -> Viseme:
        """The one in hand."""
        return self._visemes[self.list.currentRow()]

    def done(self, how: int) -> None:
        """Let the face go back to what it was; what was changed stays only if it was accepted."""
        self._timeline.document.cancel_preview()
        if how != QDialog.DialogCode.Accepted:
            self._live.cancel()
        super().done(how)

    def take_face(self) -> None:
        """Let the viseme in hand look as the sliders stand."""
        shown = {name: weight for name, weight in self._timeline.document.shown.items() if weight}
        self._change(replace(self.viseme, weights=shown))
        self._open(self.list.currentRow())

    def show_face(self) -> None:
        """Let the face look like the viseme in hand, for as long as this is open."""
        units = self._timeline.document.project.units
        wanted = expand(self.viseme.weights, units)
        neutral = {name: 0.0 for unit in units for name in unit.fields}
        self._timeline.document.preview({**neutral, **wanted})

    def restore(self) -> None:
        """Go back to the set that ships."""
        self._visemes = list(mouth_table().visemes)
        self._fill()
        self._show()

    def _open(self, row: int) -> None:
        if not 0 <= row < len(self._visemes):
            return
        viseme, units = self._visemes[row], self._timeline.document.project.units
        self.closes.blockSignals(True)
        self.symbols.setText(" ".join(symbol for symbol in viseme.symbols if symbol))
        self.weights.setText(format_expression(expand(viseme.weights, units), units))
        self.dominance.set_value(viseme.dominance)
        self.closes.setChecked(viseme.closes)
        self.closes.blockSignals(False)
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
        kept = ("",) if "" in self.viseme.symbols else ()
        symbols = (*kept, *self.symbols.text().split())
        changed = replace(
            self.viseme,
            symbols=symbols,
            weights=weights,
            dominance=self.dominance.value,
            closes=self.closes.isChecked(),
        )
        self._change(changed)
        self.show_face()

    def _change(self, viseme: Viseme) -> None:
        if viseme != self.viseme:
            self._visemes[self.list.currentRow()] = viseme
            self._show()

    def _show(self) -> None:
        self._timeline.document.cancel_preview()
        self._live.show(with_visemes(self._live.base, self._visemes))

    def _fill(self) -> None:
        row = max(self.list.currentRow(), 0)
        self.list.clear()
        self.list.addItems([viseme.name for viseme in self._visemes])
        self.list.setCurrentRow(min(row, len(self._visemes) - 1))

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
        row.addWidget(push_button("Take from the face", self.take_face, "Let it look as the sliders stand"))
        row.addWidget(push_button("Show on the face", self.show_face, "Look at it"))
        right.addLayout(row)
        right.addWidget(self.complaint)
        right.addStretch(1)
        right.addWidget(push_button("Go back to the set that ships", self.restore), 0, Qt.AlignmentFlag.AlignLeft)
        inner = QHBoxLayout()
        inner.setSpacing(2 * GRID)
        inner.addWidget(self.list)
        inner.addLayout(right, 1)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(3 * GRID, 2 * GRID, 3 * GRID, 2 * GRID)
        layout.addLayout(inner, 1)
        layout.addWidget(buttons)
