"""One profile of the mouth sphincter in the panel: its curve, the knot in hand as numbers, and the way back."""

from __future__ import annotations

from functools import partial

from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from facemodel.laying.profiles import Axes
from facemodel.laying.values import changed, reset
from facemodel.muscles import Profile
from facemodel.muscles.parameters import ProfileParameter
from ui.panels.actions.tool_button import tool_button
from ui.panels.muscles.editing import MuscleEdit
from ui.theme.metrics import GRID
from ui.widgets.curve_edit import CurveEdit
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

RING = (1.0, "the ring")
"""Distance of the ring itself, in its half axes."""


class ProfileRow(QWidget):
    """Binds a profile of the selected muscles to a curve."""

    def __init__(self, parameter: ProfileParameter, edit: MuscleEdit) -> None:
        super().__init__()
        self._parameter, self._edit = parameter, edit
        axes = Axes(parameter.reach, parameter.least, parameter.most, RING)
        self.curve = CurveEdit(parameter.title, parameter.default, axes)
        self.curve.setToolTip(
            f"{parameter.title} (Choe, Lee and Ko 2001, eq. 2) over the distance in half axes of the ring<br>"
            "Drag a knot · double-click adds one · right-click or Delete takes it out · arrows step"
        )
        self.at = NumberBar("Distance", NumberScale(0.0, parameter.reach, 1.0))
        self.value = NumberBar("Value", NumberScale(parameter.least, parameter.most, 0.0))
        self.restore = tool_button("restore", "Reset: the profile that a new muscle gets", self._reset)
        self.restore.setProperty("role", "small")
        self._lay_out(parameter.title)
        self.curve.previewed.connect(self._propose)
        self.curve.knot_changed.connect(self._show_knot)
        self.at.previewed.connect(lambda at: self.curve.set_knot(at, self._knot[1]))
        self.value.previewed.connect(lambda value: self.curve.set_knot(self._knot[0], value))
        for control in (self.curve, self.at, self.value):
            control.committed.connect(edit.keep)
            control.cancelled.connect(edit.cancel)
        self._show_knot()

    def show_profile(self, profile: Profile) -> None:
        """Show what the selected muscle has, unless a hand is drawing."""
        if not (self.curve.held or self.at.held or self.value.held):
            self.curve.set_profile(profile)
        self.restore.setEnabled(profile != self._parameter.default)

    @property
    def _knot(self) -> tuple[float, float]:
        profile = self.curve.profile
        return profile.at[self.curve.knot], profile.values[self.curve.knot]

    def _propose(self, profile: Profile) -> None:
        name = self._parameter.name
        self._edit.propose(partial(changed, name=name, value=profile), f"{self._parameter.title} of")

    def _reset(self) -> None:
        self._edit.now(partial(reset, name=self._parameter.name), f"Reset {self._parameter.title} of")

    def _show_knot(self) -> None:
        at, value = self._knot
        self.at.setEnabled(self.curve.knot > 0)
        self.value.setEnabled(self.curve.knot < len(self.curve.profile.at) - 1)
        for bar, number in ((self.at, at), (self.value, value)):
            bar.set_value(number)

    def _lay_out(self, title: str) -> None:
        words = QLabel(title)
        words.setProperty("role", "muted")
        head = QHBoxLayout()
        head.addWidget(words, 1)
        head.addWidget(self.restore)
        foot = QHBoxLayout()
        foot.setSpacing(2)
        foot.addWidget(self.at)
        foot.addWidget(self.value)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, GRID // 2, 0, 0)
        layout.setSpacing(2)
        layout.addLayout(head)
        layout.addWidget(self.curve)
        layout.addLayout(foot)
