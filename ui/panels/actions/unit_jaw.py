"""What an action unit does to the jaw: how far it opens, comes forward and goes aside."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from PySide6.QtWidgets import QVBoxLayout, QWidget

from facemodel.actions import ActionUnit, JawMotion
from ui.panels.actions.unit_weights import MakeBar, heading
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

OPENING = NumberScale(0.0, 45.0, 0.0, "°")
SLIDE = NumberScale(-5.0, 15.0, 0.0, "mm")
SIDE = NumberScale(-12.0, 12.0, 0.0, "mm")


class UnitJaw(QWidget):
    """Bars for the motion of the jaw in the unit in hand."""

    def __init__(self, make_bar: MakeBar) -> None:
        super().__init__()
        self.opening = make_bar("Opening", OPENING, partial(_moved, member="degrees"))
        self.slide = make_bar("Slide forward", SLIDE, partial(_moved, member="slide"))
        self.side = make_bar("Shift to the left", SIDE, partial(_moved, member="side"))
        self.slide.setToolTip("How far the condyles come forward; below zero they go back")
        self.side.setToolTip(
            "How far the lower incisors go to the subject’s left; below zero to the right.<br>"
            "Of a unit with two sides the right one is the mirror image."
        )
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(heading("Jaw"))
        for bar in self.bars:
            layout.addWidget(bar)

    @property
    def bars(self) -> tuple[NumberBar, ...]:
        """The bars from top to bottom."""
        return self.opening, self.slide, self.side

    def show_unit(self, unit: ActionUnit) -> None:
        """Show what a unit does to the jaw; a bar that is held stays."""
        jaw = unit.jaw or JawMotion(0.0)
        for bar, value in zip(self.bars, (jaw.degrees, jaw.slide, jaw.side), strict=True):
            if not bar.held:
                bar.set_value(value)


def _moved(unit: ActionUnit, value: float, member: str) -> ActionUnit:
    return replace(unit, jaw=replace(unit.jaw or JawMotion(0.0), **{member: value}) or None)
