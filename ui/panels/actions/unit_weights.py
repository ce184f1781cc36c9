"""The muscles that an action unit contracts: one bar each, and a menu of those that it does not."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from html import escape

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QToolButton, QVBoxLayout, QWidget

from app.actions.context import Context
from app.authoring.units import LET_GO
from facemodel.actions import ActionUnit
from facemodel.laying.values import GROUPS
from facemodel.muscles import Muscle
from ui.panels.unit_text import muscle_titles
from ui.theme.icons import icon
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale
from ui.widgets.plain_label import as_written

USUAL_MOST = 5.0
"""Activation at the end of a bar; more can be typed into the muscle's own strength."""

BUTTON = 22

Weigh = Callable[[ActionUnit, float], ActionUnit]
MakeBar = Callable[[str, NumberScale, Weigh], NumberBar]
"""Makes a bar that changes the unit in hand."""
ChangeUnit = Callable[[Callable[[ActionUnit], ActionUnit], str], None]
"""Changes the unit in hand in one step."""


def weight_scale(unit: ActionUnit, muscle: Muscle) -> NumberScale:
    """The range of a muscle's activation in a unit: below zero for lids, which a levator lowers as it lets go."""
    weight = unit.muscles.get(muscle.name, 0.0)
    most = max(USUAL_MOST, abs(weight))
    return NumberScale(-most if muscle.model in LET_GO else 0.0, most, 0.0, "")


class UnitWeights(QWidget):
    """Rows of muscles with their activations.

    Signals
    -------
    hovered(object) : frozenset of the keys of the muscles under the pointer
    """

    hovered = Signal(object)

    def __init__(self, context: Context, make_bar: MakeBar, change: ChangeUnit) -> None:
        super().__init__()
        self._context, self._make_bar, self._change = context, make_bar, change
        self._unit: ActionUnit | None = None
        self._made_for: tuple[object, ...] = ()
        self.weights: dict[str, NumberBar] = {}
        self.removers: dict[str, QToolButton] = {}
        self.add = QToolButton()
        self.add.setIcon(icon("plus"))
        self.add.setToolTip("Let the unit contract one more muscle")
        self.add.setAccessibleName("Add a muscle")
        self.add.clicked.connect(self._ask_muscle)
        head = QHBoxLayout()
        head.addWidget(heading("Muscles"), 1)
        head.addWidget(self.add)
        self._rows = QVBoxLayout()
        self._rows.setSpacing(2)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addLayout(head)
        layout.addLayout(self._rows)

    def show_unit(self, unit: ActionUnit) -> None:
        """Show the muscles of a unit; bars are made anew only for other muscles."""
        self._unit = unit
        self._make_bars(unit)
        for name, weight in unit.muscles.items():
            if not self.weights[name].held:
                self.weights[name].set_value(weight)

    def _ask_muscle(self) -> None:
        """The muscles that the unit does not contract yet, by their groups."""
        menu = self.muscle_menu()
        menu.exec(self.add.mapToGlobal(self.add.rect().bottomLeft()))
        menu.deleteLater()

    def muscle_menu(self) -> QMenu:
        """A menu of the muscles that the unit does not contract yet."""
        menu = QMenu(self.add)
        unit = self._unit
        for group in GROUPS:
            titles: dict[str, str] = {}
            for muscle in self._context.document.project.muscles:
                if unit is not None and muscle.group == group and muscle.name not in unit.muscles:
                    titles[muscle.name] = muscle.title
            if titles:
                part = menu.addMenu(group.capitalize())
                for name, title in titles.items():
                    entry = part.addAction(title)
                    entry.setData(name)
                    entry.triggered.connect(lambda _checked=False, name=name: self.add_muscle(name))
        menu.setEnabled(not menu.isEmpty())
        return menu

    def add_muscle(self, name: str) -> None:
        """Let the unit contract one more muscle."""
        self._change(partial(_weighed, value=1.0, muscle=name), f"Put {name} into")

    def _make_bars(self, unit: ActionUnit) -> None:
        there = {muscle.name: muscle for muscle in self._context.document.project.muscles}
        wanted = (unit.number, tuple(unit.muscles), tuple(name in there for name in unit.muscles))
        if wanted == self._made_for:
            return
        self._made_for = wanted
        while self._rows.count():
            row = self._rows.takeAt(0).widget()
            row.hide()
            row.deleteLater()
        self.weights, self.removers = {}, {}
        titles = muscle_titles(there.values())
        for name in unit.muscles:
            self._rows.addWidget(self._weight_row(unit, name, there.get(name), titles))

    def _weight_row(self, unit: ActionUnit, name: str, muscle: Muscle | None, titles: Mapping[str, str]) -> QWidget:
        scale = weight_scale(unit, muscle) if muscle is not None else NumberScale(0.0, USUAL_MOST, 0.0)
        bar = self._make_bar(titles.get(name, name), scale, partial(_weighed, muscle=name))
        bar.setToolTip(
            f"{escape(titles.get(name, name))}: times its strength at 1<br>Drag · double-click types · Shift finer"
        )
        keys = frozenset(each.key for each in self._context.document.project.muscles if each.name == name)
        bar.hovered.connect(lambda inside: self.hovered.emit(keys if inside else frozenset()))
        remove = QToolButton()
        remove.setIcon(icon("close", quiet=True))
        remove.setProperty("role", "small")
        remove.setFixedSize(BUTTON, BUTTON)
        remove.setToolTip(as_written(f"Let go of {titles.get(name, name)}"))
        remove.setAccessibleName(f"Let go of {titles.get(name, name)}")
        remove.clicked.connect(lambda: self._change(partial(_let_go, muscle=name), f"Take {name} out of"))
        self.weights[name], self.removers[name] = bar, remove
        row = QWidget()
        line = QHBoxLayout(row)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(2)
        line.addWidget(bar, 1)
        line.addWidget(remove)
        return row


def _weighed(unit: ActionUnit, value: float, muscle: str) -> ActionUnit:
    return replace(unit, muscles={**unit.muscles, muscle: float(value)})


def _let_go(unit: ActionUnit, muscle: str) -> ActionUnit:
    return replace(unit, muscles={name: weight for name, weight in unit.muscles.items() if name != muscle})


def heading(text: str) -> QLabel:
    """A heading in small capitals."""
    label = QLabel(text.upper())
    label.setProperty("role", "heading")
    return label
