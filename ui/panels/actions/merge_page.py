"""A question: which action unit goes into another one, and how much of each."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QComboBox, QDialog, QDialogButtonBox, QLabel, QVBoxLayout, QWidget

from app.actions.context import Merge
from facemodel.actions import EXAGGERATED, ActionUnit
from ui.panels.unit_text import unit_title
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale
from ui.widgets.plain_label import PlainLabel

WIDTH = 46 * GRID
SHARE = NumberScale(0.0, EXAGGERATED, 1.0)


class MergePage(QDialog):
    """Asks for a partner of a unit and for the shares of both."""

    def __init__(self, parent: QWidget | None, unit: ActionUnit, others: Sequence[ActionUnit]) -> None:
        super().__init__(parent)
        self.setWindowTitle("Merge action units")
        self.setFixedWidth(WIDTH)
        self.partner = QComboBox()
        self.partner.setAccessibleName("Merge with")
        for each in others:
            self.partner.addItem(f"{each.number}  {unit_title(each)}", each.number)
        self.own = _share(f"Of {unit.number} {unit_title(unit)}")
        self.share = _share("Of the other one")
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.merge = buttons.addButton("Merge", QDialogButtonBox.ButtonRole.AcceptRole)
        self.merge.setDefault(True)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        title = PlainLabel(f"Merge into {unit.number} {unit_title(unit)}")
        title.setProperty("role", "title")
        words = QLabel(
            "The unit then does what both did, and the other one is gone. Expressions that used it use this one."
        )
        words.setWordWrap(True)
        words.setProperty("role", "muted")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 2 * GRID)
        layout.setSpacing(GRID)
        for part in (title, words, self.partner, self.own, self.share):
            layout.addWidget(part)
        layout.addSpacing(GRID)
        layout.addWidget(buttons)

    @property
    def asked(self) -> Merge:
        """What was chosen."""
        return Merge(self.partner.currentData(), self.own.value, self.share.value)


def ask_merge(parent: QWidget, unit: ActionUnit, others: Sequence[ActionUnit]) -> Merge | None:
    """Ask which of some units goes into one, and how much of both; none if the person thought better of it."""
    page = MergePage(parent, unit, others)
    return page.asked if page.exec() == QDialog.DialogCode.Accepted else None


def _share(caption: str) -> NumberBar:
    bar = NumberBar(caption, SHARE)
    bar.setToolTip("How much of what it does goes into the merged unit; 1 is all of it")
    return bar
