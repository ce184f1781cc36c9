"""What is sculpted on the unit in hand, as a layer over its solved fields: on or off, how much, mirrored, copied."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QMenu, QPushButton, QVBoxLayout, QWidget

from app.actions.action import Action, perform
from app.actions.context import Context
from app.authoring.ordering import listed
from app.authoring.sculpting import farthest, layers_of, with_amount, with_switch
from ui.panels.actions.sculpt_deeds import SCULPT_ACTIONS, copy
from ui.panels.actions.unit_deeds import in_hand
from ui.panels.live_edit import LiveEdit
from ui.panels.telling import told
from ui.panels.unit_text import unit_title
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

AMOUNT = NumberScale(0, 100, 100, "%", whole=True)
DEEDS = {"sculpt.left": "Left to right", "sculpt.right": "Right to left", "sculpt.clear": "Clear"}
NOTHING = "Nothing is sculpted on this unit yet."


class SculptLayerBox(QWidget):
    """Binds the layers of the unit in hand to fields, both ways; left and right of a unit are one to the hand."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self._live = LiveEdit(context.document)
        self._actions = {action.id: action for action in SCULPT_ACTIONS}
        self.on = QCheckBox("Added to what is solved")
        self.on.setToolTip("Off shows the unit as it is solved; the layer is kept")
        self.amount = NumberBar("Amount", AMOUNT)
        self.amount.setToolTip("How much of what is sculpted is added to what is solved")
        self.told = QLabel("")
        self.told.setProperty("role", "muted")
        self.told.setWordWrap(True)
        self.deeds = {key: self._deed(title, self._actions[key]) for key, title in DEEDS.items()}
        self.copy = QPushButton("Copy to…")
        self.copy.setToolTip("Put the layer on another action unit, in place of what is sculpted there")
        self.copy.clicked.connect(self._ask_target)
        self._lay_out()
        self.amount.previewed.connect(self._weigh)
        self.amount.committed.connect(self._live.keep)
        self.amount.cancelled.connect(self._live.cancel)
        self.on.toggled.connect(self._switch)
        document = context.document
        for signal in (document.project_changed, document.units_changed, document.corrections_changed):
            signal.connect(self.show_unit)
        context.view.changed.connect(lambda now, before: self.show_unit() if now.unit != before.unit else None)
        self.show_unit()

    def show_unit(self, *_what: object) -> None:
        """Show what is sculpted on the unit in hand."""
        unit, project = in_hand(self._context), self._context.document.project
        layers = layers_of(project, unit) if unit is not None else {}
        for widget in (self.on, self.amount, self.copy):
            widget.setEnabled(bool(layers))
        for key, button in self.deeds.items():
            button.setEnabled(self._actions[key].enabled(self._context))
        self.on.blockSignals(True)
        self.on.setChecked(all(each.on for each in layers.values()))
        self.on.blockSignals(False)
        if not self.amount.held:
            amounts = {each.amount for each in layers.values()} or {1.0}
            self.amount.set_value(100 * max(amounts), mixed=len(amounts) > 1)
        moved = farthest(project, unit) if unit is not None and layers else 0.0
        self.told.setText(f"Moves the skin up to {moved:.1f} mm at 1." if layers else NOTHING)

    def target_menu(self) -> QMenu:
        """A menu of the units that the layer can be copied to."""
        menu = QMenu(self.copy)
        unit = in_hand(self._context)
        for other in listed(self._context.document.project):
            if unit is not None and other.number != unit.number:
                entry = menu.addAction(f"{other.number}  {unit_title(other)}")
                entry.triggered.connect(lambda _on=False, number=other.number: self._copy(number))
        return menu

    def _ask_target(self) -> None:
        menu = self.target_menu()
        menu.exec(self.copy.mapToGlobal(self.copy.rect().bottomLeft()))
        menu.deleteLater()

    def _copy(self, number: int) -> None:
        self._told(lambda: copy(self._context, number))

    def _weigh(self, value: float) -> None:
        unit = in_hand(self._context)
        if unit is not None:
            label = f"Sculpted amount of {unit_title(unit)}"
            self._told(lambda: self._live.propose(lambda p: with_amount(p, unit.number, value / 100), label))

    def _switch(self, on: bool) -> None:
        unit, document = in_hand(self._context), self._context.document
        if unit is not None:
            label = f"{'Show' if on else 'Hide'} what is sculpted on {unit_title(unit)}"
            self._told(lambda: document.edit(with_switch(document.project, unit.number, on), label))

    def _told(self, act: Callable[[], None]) -> None:
        """Do something; what is wrong with it is told."""
        if not told(self._context, act):
            self.show_unit()

    def _deed(self, title: str, action: Action) -> QPushButton:
        button = QPushButton(title)
        button.setToolTip(action.hint)
        button.clicked.connect(lambda: perform(action, self._context))
        return button

    def _lay_out(self) -> None:
        layer = QHBoxLayout()
        layer.setSpacing(GRID // 2)
        layer.addWidget(self.amount, 1)
        layer.addWidget(self.deeds["sculpt.clear"])
        deeds = QHBoxLayout()
        deeds.setSpacing(GRID // 2)
        for button in (self.deeds["sculpt.left"], self.deeds["sculpt.right"], self.copy):
            deeds.addWidget(button, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GRID // 2)
        layout.addWidget(self.told)
        layout.addWidget(self.on)
        layout.addLayout(layer)
        layout.addLayout(deeds)
