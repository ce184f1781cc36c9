"""The unit in hand on the face: its slider, and its forces, pull, motion and sculpted layer over the skin."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from app.actions.context import Context
from app.view_state import ViewState
from facemodel.actions import ActionUnit
from ui.panels.unit_row import UnitRow
from ui.panels.unit_text import muscle_titles
from ui.theme.metrics import GRID


@dataclass(frozen=True)
class Sight:
    """Something of the unit in hand that can be seen.

    Attributes
    ----------
    title, tip : for people
    on, off : members of the view state that show it, and that do not
    """

    title: str
    tip: str
    on: dict[str, Any]
    off: dict[str, Any]

    def is_on(self, state: ViewState) -> bool:
        """Whether it is shown."""
        return all(getattr(state, name) == value for name, value in self.on.items())


SIGHTS = (
    Sight("Forces", "Arrows: how the muscles of the unit pull at 1 (O)", {"forces": True}, {"forces": False}),
    Sight(
        "Pull",
        "Colours: how hard the muscles of the unit pull, in kPa (I)",
        {"influence": True},
        {"influence": False},
    ),
    Sight(
        "Motion",
        "Colours: how far the unit moves the skin at 1, in mm",
        {"unit_map": "motion", "influence": False},
        {"unit_map": ""},
    ),
    Sight(
        "Sculpted",
        "Colours: how far what is sculpted on the unit moves the skin at 1, in mm",
        {"unit_map": "sculpted", "influence": False},
        {"unit_map": ""},
    ),
)


class UnitShow(QWidget):
    """Binds slider and sights of the unit in hand to the document and the view, both ways.

    Signals
    -------
    hovered(object) : frozenset of the keys of the muscles under the pointer
    """

    hovered = Signal(object)

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self.row: UnitRow | None = None
        self.sights = {sight.title: self._button(sight) for sight in SIGHTS}
        line = QHBoxLayout()
        line.setSpacing(2)
        for button in self.sights.values():
            line.addWidget(button)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(GRID // 2)
        self._layout.addLayout(line)
        context.view.changed.connect(lambda now, _before: self._show_view(now))
        context.document.expression_changed.connect(self._show_expression)
        self._show_view(context.view.state)

    def show_unit(self, unit: ActionUnit) -> None:
        """Show the slider of a unit; it is made anew only for another one."""
        titles = muscle_titles(self._context.document.project.muscles)
        row = self.row
        known = row is not None and (row.unit.number, row.unit.name, row.unit.paired)
        if row is not None and known == (unit.number, unit.name, unit.paired):
            row.become(unit, titles)
        else:
            self._make_row(unit)
        self._show_expression()

    def _make_row(self, unit: ActionUnit) -> None:
        if self.row is not None:
            self.row.hide()
            self.row.deleteLater()
        document, view = self._context.document, self._context.view
        self.row = UnitRow(document, view, unit, muscle_titles(document.project.muscles))
        self.row.slider.label = "Slider"
        self.row.stand_alone()
        self.row.hovered.connect(self.hovered)
        self._layout.insertWidget(0, self.row)

    def _show_expression(self, _now: object = None) -> None:
        if self.row is not None:
            self.row.show_expression(self._context.document.shown)

    def _button(self, sight: Sight) -> QToolButton:
        button = QToolButton()
        button.setText(sight.title)
        button.setToolTip(sight.tip)
        button.setCheckable(True)
        button.setProperty("role", "choice")
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.clicked.connect(lambda on: self._context.view.change(**(sight.on if on else sight.off)))
        return button

    def _show_view(self, now: ViewState) -> None:
        for sight in SIGHTS:
            self.sights[sight.title].setChecked(sight.is_on(now))
