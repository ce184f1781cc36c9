"""One bar for each number of a muscle's model, one curve for each of its profiles."""

from __future__ import annotations

from functools import partial

from PySide6.QtWidgets import QVBoxLayout, QWidget

from facemodel.laying.values import changed
from facemodel.muscles import Muscle, Profile
from facemodel.muscles.models import MODELS
from facemodel.muscles.parameters import Parameter, ProfileParameter, value_of
from ui.panels.muscles.editing import MuscleEdit
from ui.panels.muscles.profile_row import ProfileRow
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

BENDS = {"width": 1.6, "strength": 2.0, "kappa": 1.6, "count": 1.6}
"""Parameters of which the smaller half of the range is the one that is used."""


def scale_of(parameter: Parameter) -> NumberScale:
    """The range of a parameter as a bar shows it."""
    return NumberScale(
        parameter.least,
        parameter.most,
        parameter.default,
        parameter.unit,
        parameter.whole,
        BENDS.get(parameter.name, 1.0),
    )


class ParameterBars(QWidget):
    """Binds the parameters that all selected muscles have to bars and curves."""

    def __init__(self, edit: MuscleEdit) -> None:
        super().__init__()
        self._edit = edit
        self._made_for: list[Parameter | ProfileParameter] | None = None
        self.bars: dict[str, NumberBar] = {}
        self.curves: dict[str, ProfileRow] = {}
        self._rows = QVBoxLayout(self)
        self._rows.setContentsMargins(0, 0, 0, 0)
        self._rows.setSpacing(2)

    def show_muscles(self, muscles: tuple[Muscle, ...]) -> None:
        """Show the values of some muscles; rows are made anew only where other parameters are asked for."""
        models = [MODELS[muscle.model] for muscle in muscles]
        shared = [each for each in models[0].parameters if all(each in model.parameters for model in models)]
        if shared != self._made_for:
            self._make(shared)
        for name, bar in self.bars.items():
            values = [value_of(muscle, name) for muscle in muscles]
            if not bar.held:
                bar.set_value(values[0], mixed=any(value != values[0] for value in values))
        for name, row in self.curves.items():
            profile = value_of(muscles[0], name)
            assert isinstance(profile, Profile)
            row.show_profile(profile)

    def _make(self, parameters: list[Parameter | ProfileParameter]) -> None:
        self._made_for = parameters
        for row in (*self.bars.values(), *self.curves.values()):
            row.hide()
            row.deleteLater()
        self.bars = {each.name: self._bar(each) for each in parameters if isinstance(each, Parameter)}
        curves = [each for each in parameters if isinstance(each, ProfileParameter)]
        self.curves = {each.name: ProfileRow(each, self._edit) for each in curves}
        for row in (*self.bars.values(), *self.curves.values()):
            self._rows.addWidget(row)

    def _bar(self, parameter: Parameter) -> NumberBar:
        title, _, explained = parameter.title.partition(": ")
        bar = NumberBar(title, scale_of(parameter))
        bar.setToolTip(
            f"{title}{': ' + explained if explained else ''}<br>"
            f"{parameter.least:g} to {parameter.most:g} {parameter.unit} · default {parameter.default:g}<br>"
            "Drag · double-click types · right-click resets · Shift finer"
        )
        bar.previewed.connect(
            lambda value: self._edit.propose(partial(changed, name=parameter.name, value=value), f"{title} of")
        )
        bar.committed.connect(self._edit.keep)
        bar.cancelled.connect(self._edit.cancel)
        return bar
