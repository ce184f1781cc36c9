"""The sliders of one action unit: one for both sides or one for each, where they end, and how they are scored."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from app.actions.context import Context
from app.authoring.intensities import with_letter
from app.authoring.parting import joined, split
from app.authoring.units import SMALLEST_LIMIT, with_limit
from facemodel.actions import EXAGGERATED, ActionUnit
from facemodel.errors import RisoriusError
from facemodel.project import Project
from ui.panels.actions.unit_weights import heading
from ui.panels.live_edit import LiveEdit
from ui.widgets.letter_bar import LetterBar
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

LIMIT = NumberScale(SMALLEST_LIMIT, EXAGGERATED, EXAGGERATED)
SIDES = {True: "Left and right apart", False: "Both sides as one"}


class UnitRange(QWidget):
    """Binds limit, letters and sides of the unit that is shown to bars, both ways."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self._unit: ActionUnit | None = None
        self._live = LiveEdit(context.document)
        self.sides = QComboBox()
        self.sides.setAccessibleName("Sides")
        self.sides.setToolTip("Whether left and right of the unit have a slider each")
        for paired, title in SIDES.items():
            self.sides.addItem(title, paired)
        self.limit = NumberBar("Ends at", LIMIT)
        self.limit.setToolTip("The largest weight that its sliders take; 1 is full contraction")
        self.letters = LetterBar()
        row = QHBoxLayout()
        row.addWidget(heading("Sliders"), 1)
        row.addWidget(self.sides)
        scored = QLabel("Scored by FACS as")
        scored.setProperty("role", "muted")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addLayout(row)
        layout.addWidget(self.limit)
        layout.addWidget(scored)
        layout.addWidget(self.letters)
        self._connect()

    def show_unit(self, unit: ActionUnit) -> None:
        """Show what is said of the sliders of a unit."""
        self._unit = unit
        self.sides.setCurrentIndex(self.sides.findData(unit.paired))
        if not self.limit.held:
            self.limit.set_value(unit.limit)
        self.letters.show_letters(unit.letters)

    def _connect(self) -> None:
        self.sides.activated.connect(lambda _row: self._part())
        self.limit.previewed.connect(
            lambda value: self._propose(lambda project, number: with_limit(project, number, value), "Limit of")
        )
        self.letters.previewed.connect(
            lambda letter, value: self._propose(
                lambda project, number: with_letter(project, number, letter, value), f"{letter} of"
            )
        )
        for bar in (self.limit, self.letters):
            bar.committed.connect(self._live.keep)
            bar.cancelled.connect(self._live.cancel)

    def _part(self) -> None:
        """Give each side a slider of its own, or both one."""
        unit, document = self._unit, self._context.document
        if unit is None or self.sides.currentData() == unit.paired:
            return
        change, verb = (joined, "Join") if unit.paired else (split, "Split")
        document.edit(change(document.project, unit.number), f"{verb} sides of AU {unit.number}")

    def _propose(self, change: Callable[[Project, int], Project], label: str) -> None:
        unit = self._unit
        if unit is None:
            return
        try:
            self._live.propose(lambda project: change(project, unit.number), f"{label} AU {unit.number}")
        except RisoriusError as error:
            self._context.host.show_message(str(error))
            self.show_unit(unit)
