"""What an action unit does to eyes, head and tongue: how far they turn, in degrees, and how far they are moved."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from PySide6.QtWidgets import QVBoxLayout, QWidget

from facemodel.actions import ActionUnit
from facemodel.motions import EyeMotion, HeadMotion, TongueMotion
from ui.panels.actions.unit_weights import MakeBar
from ui.widgets.collapsible import Collapsible
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

TURN = NumberScale(-60.0, 60.0, 0.0, "°")
SHIFT = NumberScale(-60.0, 60.0, 0.0, "mm")

EYES = (("turn", "Turn to the left"), ("lift", "Look up"), ("spread", "Spread"))
HEAD = (("turn", "Turn to the left"), ("lift", "Raise the chin"), ("tilt", "Tilt to the left"), ("forward", "Forward"))
TONGUE = (("out", "Come out"), ("lift", "Bend up"))
"""Members of the motions and what their bars are called."""


class UnitMotion(QWidget):
    """Bars for the motion of eyes, head and tongue by the unit in hand, folded away where there is none."""

    def __init__(self, make_bar: MakeBar) -> None:
        super().__init__()
        self.eyes = {name: make_bar(title, TURN, partial(_eyes, member=name)) for name, title in EYES}
        self.head = {
            name: make_bar(title, SHIFT if name == "forward" else TURN, partial(_head, member=name))
            for name, title in HEAD
        }
        self.eyes["spread"].setToolTip("How far each eye turns outwards; below zero they squint at the nose")
        self.tongue = {
            name: make_bar(title, SHIFT if name == "out" else TURN, partial(_tongue, member=name))
            for name, title in TONGUE
        }
        self.fold_eyes, self.fold_head, self.fold_tongue = (Collapsible(part) for part in ("Eyes", "Head", "Tongue"))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        folds = (self.fold_eyes, self.eyes), (self.fold_head, self.head), (self.fold_tongue, self.tongue)
        for fold, bars in folds:
            for bar in bars.values():
                fold.rows.addWidget(bar)
            layout.addWidget(fold)
        self._shown: int | None = None

    def show_unit(self, unit: ActionUnit) -> None:
        """Show what a unit does to eyes, head and tongue; a bar that is held stays."""
        eyes, head, tongue = unit.eyes or EyeMotion(), unit.head or HeadMotion(), unit.tongue or TongueMotion()
        for bars, motion in ((self.eyes, eyes), (self.head, head), (self.tongue, tongue)):
            for name, bar in bars.items():
                _show(bar, getattr(motion, name))
        if unit.number != self._shown:
            self._shown = unit.number
            self.fold_eyes.fold(not eyes)
            self.fold_head.fold(not head)
            self.fold_tongue.fold(not tongue)
        self.setEnabled(not unit.paired)
        self.setToolTip("Eyes, head and tongue move as one; join the sides of this unit first." if unit.paired else "")


def _show(bar: NumberBar, value: float) -> None:
    if not bar.held:
        bar.set_value(value)


def _eyes(unit: ActionUnit, value: float, member: str) -> ActionUnit:
    return replace(unit, eyes=replace(unit.eyes or EyeMotion(), **{member: value}) or None)


def _head(unit: ActionUnit, value: float, member: str) -> ActionUnit:
    return replace(unit, head=replace(unit.head or HeadMotion(), **{member: value}) or None)


def _tongue(unit: ActionUnit, value: float, member: str) -> ActionUnit:
    return replace(unit, tongue=replace(unit.tongue or TongueMotion(), **{member: value}) or None)
