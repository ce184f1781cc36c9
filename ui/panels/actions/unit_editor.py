"""What one action unit is made of: muscles, jaw, eyes and head, and how far the skin is to go."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLayout, QPushButton, QVBoxLayout, QWidget

from app.actions.action import perform
from app.actions.context import Context
from app.authoring.units import unit_of, with_unit
from app.view_state import ViewState
from facemodel.actions import ActionUnit
from facemodel.errors import RisoriusError
from facemodel.project import Project
from ui.panels.actions.unit_deeds import UNIT_ACTIONS, in_hand, reached
from ui.panels.actions.unit_head import UnitHead
from ui.panels.actions.unit_jaw import UnitJaw
from ui.panels.actions.unit_motion import UnitMotion
from ui.panels.actions.unit_range import UnitRange
from ui.panels.actions.unit_show import UnitShow
from ui.panels.actions.unit_weights import UnitWeights, heading
from ui.panels.live_edit import LiveEdit
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

AMPLITUDE = NumberScale(0.0, 60.0, 5.0, "mm", bend=1.6)

FIT = next(action for action in UNIT_ACTIONS if action.id == "unit.fit")


class UnitEditor(QWidget):
    """Binds the action unit in hand to fields and bars, both ways.

    Signals
    -------
    hovered(object) : frozenset of the keys of the muscles under the pointer
    """

    hovered = Signal(object)

    def __init__(self, context: Context, sculpting: tuple[QWidget, ...] = ()) -> None:
        super().__init__()
        self._context = context
        self._live = LiveEdit(context.document, context.solving)
        self.head = UnitHead(context)
        self.show_ = UnitShow(context)
        self.muscles = UnitWeights(context, self._bar, self._change)
        self.jaw = UnitJaw(self._bar)
        self.motion = UnitMotion(self._bar)
        self.amplitude = self._bar("Meant to move", AMPLITUDE, lambda unit, value: replace(unit, amplitude=value))
        self.range = UnitRange(context)
        self.moved = _quiet("")
        self.fit = QPushButton("Fit")
        self.fit.setToolTip(FIT.hint)
        self._sculpting = sculpting
        self._nothing = _quiet("Choose an action unit, or make a new one.")
        self._form = QWidget()
        self._lay_out()
        self._connect()
        self.show_unit()

    @property
    def unit(self) -> ActionUnit | None:
        """The unit that is shown."""
        return in_hand(self._context)

    def show_unit(self, *_what: object) -> None:
        """Show the unit in hand; bars are made anew only for other muscles."""
        unit = self.unit
        self._form.setVisible(unit is not None)
        self._nothing.setVisible(unit is None)
        if unit is None:
            return
        if not self.amplitude.held:
            self.amplitude.set_value(unit.amplitude)
        for part in (self.head, self.show_, self.muscles, self.jaw, self.motion, self.range):
            part.show_unit(unit)
        self.show_result()

    def show_result(self, *_what: object) -> None:
        """Show how far the skin goes, as it is solved."""
        unit = self.unit
        if unit is None:
            return
        moved = reached(self._context, unit)
        if not unit.moves_skin:
            self.moved.setText("moves no skin by itself")
        else:
            self.moved.setText("solving …" if moved is None else f"moves {moved:.1f} mm at 1")
        self.fit.setEnabled(FIT.enabled(self._context))

    def _connect(self) -> None:
        document = self._context.document
        for changed in (document.project_changed, document.units_changed, document.muscles_changed):
            changed.connect(self.show_unit)
        document.solution_changed.connect(self.show_result)
        self._context.view.changed.connect(self._follow)
        self.muscles.hovered.connect(self.hovered)
        self.show_.hovered.connect(self.hovered)
        self.fit.clicked.connect(lambda: perform(FIT, self._context))

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if now.unit != before.unit:
            self.show_unit()

    def _bar(self, label: str, scale: NumberScale, change: Callable[[ActionUnit, float], ActionUnit]) -> NumberBar:
        bar = NumberBar(label, scale)
        bar.previewed.connect(lambda value: self._propose(change, value, label))
        bar.committed.connect(self._keep)
        bar.cancelled.connect(self._cancel)
        return bar

    def _propose(self, change: Callable[[ActionUnit, float], ActionUnit], value: float, label: str) -> None:
        """Change the unit as a bar under the hand says; it is seen meanwhile even where its slider is at zero."""
        unit = self.unit
        if unit is None:
            return

        def act(project: Project) -> Project:
            return with_unit(project, change(unit_of(project, unit.number), value))

        self._context.view.change(trying=True)
        try:
            self._live.propose(act, f"{label} in AU {unit.number}")
        except RisoriusError as error:
            self._context.host.show_message(str(error))
            self.show_unit()

    def _keep(self) -> None:
        self._live.keep()
        self._context.view.change(trying=False)

    def _cancel(self) -> None:
        self._live.cancel()
        self._context.view.change(trying=False)

    def _change(self, change: Callable[[ActionUnit], ActionUnit], label: str) -> None:
        """Change the unit in one step."""
        unit = self.unit
        if unit is not None:
            project = with_unit(self._context.document.project, change(unit))
            self._context.document.edit(project, f"{label} AU {unit.number}")

    def _lay_out(self) -> None:
        result = QHBoxLayout()
        result.setSpacing(GRID)
        result.addWidget(self.amplitude, 1)
        result.addWidget(self.fit)
        form = QVBoxLayout(self._form)
        form.setContentsMargins(0, 0, 0, 0)
        form.setSpacing(GRID // 2)
        form.addWidget(self.head)
        form.addSpacing(GRID // 2)
        form.addWidget(self.show_)
        form.addWidget(self.muscles)
        form.addSpacing(GRID)
        form.addWidget(self.jaw)
        form.addSpacing(GRID // 2)
        form.addWidget(self.motion)
        form.addSpacing(GRID)
        form.addWidget(heading("Skin"))
        form.addLayout(result)
        form.addWidget(self.moved)
        if self._sculpting:
            form.addSpacing(GRID)
            form.addWidget(heading("Sculpt"))
        for part in self._sculpting:
            form.addWidget(part)
        form.addSpacing(GRID)
        form.addWidget(self.range)
        layout = QVBoxLayout(self)
        layout.setSizeConstraint(QLayout.SizeConstraint.SetMinimumSize)
        layout.setContentsMargins(GRID, GRID, GRID, GRID)
        layout.addWidget(self._nothing)
        layout.addWidget(self._form)
        layout.addStretch(1)


def _quiet(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "muted")
    return label
