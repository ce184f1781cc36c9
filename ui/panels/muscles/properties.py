"""The numbers of the selected muscles, made of the parameters of their model, and what else can be said of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QGridLayout, QLabel, QLayout, QLineEdit, QVBoxLayout, QWidget

from app.actions.context import Context
from app.view_state import ViewState
from facemodel.errors import RisoriusError
from facemodel.laying.collection import muscle_of, renamed, with_muscle
from facemodel.laying.values import GROUPS, changed, grouped, titled, with_model
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS, comparable_models
from facemodel.muscles.parameters import Parameter, value_of
from facemodel.project import Project
from ui.panels.live_edit import LiveEdit
from ui.panels.muscles.deeds import users_text
from ui.panels.muscles.selection import chosen, titles
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

BENDS = {"width": 1.6, "strength": 2.0, "kappa": 1.6, "count": 1.6}
"""Parameters of which the smaller half of the range is the one that is used."""

CAPTION = 8 * GRID


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


class MuscleProperties(QWidget):
    """Binds the selected muscles to a title, a model and one bar for each of its numbers."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self._live = LiveEdit(context.document, context.solving)
        self._made_for: tuple[object, ...] = ()
        self.bars: dict[str, NumberBar] = {}
        self.title = QLineEdit()
        self.title.setAccessibleName("Title")
        self.title.setToolTip("The name for people, on both sides")
        self.name = QLineEdit()
        self.name.setAccessibleName("Name")
        self.name.setToolTip("The name for files, scripts and action units")
        self.model = QComboBox()
        self.model.setAccessibleName("Model")
        self.group = QComboBox()
        self.group.setAccessibleName("Group")
        for group in GROUPS:
            self.group.addItem(group.capitalize(), group)
        self.users = _quiet("")
        self._nothing = _quiet(
            "Select a muscle here or on the face. To lay a new one take the fibre tool (N), press on the skull and "
            "drag to the skin."
        )
        self._form = QWidget()
        self._rows = QVBoxLayout()
        self._lay_out()
        self.title.editingFinished.connect(self._retitle)
        self.name.editingFinished.connect(self._rename)
        self.model.activated.connect(lambda _row: self._each(partial(_to_model, model=self.model.currentData())))
        self.group.activated.connect(lambda _row: self._each(partial(_to_group, group=self.group.currentData())))
        document = context.document
        for changed_ in (document.project_changed, document.muscles_changed, document.units_changed):
            changed_.connect(lambda _what: self.show_muscles())
        context.view.changed.connect(self._follow)
        self.show_muscles()

    @property
    def muscles(self) -> tuple[Muscle, ...]:
        """The muscles that are shown, the one selected last first."""
        return chosen(self._context.document.project, self._context.view.state)

    def show_muscles(self) -> None:
        """Show what is selected; the bars are made anew only where other numbers are asked for."""
        muscles = self.muscles
        self._form.setVisible(bool(muscles))
        self._nothing.setVisible(not muscles)
        if not muscles:
            return
        first = muscles[0]
        one_name = all(muscle.name == first.name for muscle in muscles)
        self.title.setText(first.title if one_name else titles(muscles))
        self.title.setEnabled(one_name)
        self.name.setText(first.name if one_name else "")
        self.name.setEnabled(one_name)
        self.users.setText(users_text(self._context.document.project, muscles))
        self._show_choices(muscles)
        self._make_bars(muscles)
        for name, bar in self.bars.items():
            values = [value_of(muscle, name) for muscle in muscles]
            if not bar.held:
                bar.set_value(values[0], mixed=any(value != values[0] for value in values))

    def focus_title(self) -> None:
        """Put the keyboard into the title."""
        self.title.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.title.selectAll()

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if now.selected != before.selected or now.muscle != before.muscle:
            self.show_muscles()

    def _show_choices(self, muscles: tuple[Muscle, ...]) -> None:
        fitting = [model for model in MODELS if all(model in comparable_models(muscle) for muscle in muscles)]
        self.model.clear()
        for model in fitting:
            self.model.addItem(MODELS[model].title, model)
            self.model.setItemData(self.model.count() - 1, MODELS[model].source, Qt.ItemDataRole.ToolTipRole)
        alike = all(muscle.model == muscles[0].model for muscle in muscles)
        self.model.setCurrentIndex(fitting.index(muscles[0].model) if alike else -1)
        self.model.setToolTip(MODELS[muscles[0].model].source if alike else "Several models")
        self.model.setEnabled(len(fitting) > 1)
        groups = {muscle.group for muscle in muscles}
        self.group.setCurrentIndex(self.group.findData(muscles[0].group) if len(groups) == 1 else -1)

    def _make_bars(self, muscles: tuple[Muscle, ...]) -> None:
        """A bar for each number that all of the muscles have."""
        models = {muscle.model for muscle in muscles}
        shared = [
            parameter
            for parameter in MODELS[muscles[0].model].parameters
            if isinstance(parameter, Parameter) and all(parameter in MODELS[model].parameters for model in models)
        ]
        if self._made_for == (shared,):
            return
        self._made_for = (shared,)
        for bar in self.bars.values():
            bar.hide()
            bar.deleteLater()
        self.bars = {parameter.name: self._bar(parameter) for parameter in shared}
        for bar in self.bars.values():
            self._rows.addWidget(bar)

    def _bar(self, parameter: Parameter) -> NumberBar:
        title, _, explained = parameter.title.partition(": ")
        bar = NumberBar(title, scale_of(parameter))
        bar.setToolTip(
            f"{title}{': ' + explained if explained else ''}<br>"
            f"{parameter.least:g} to {parameter.most:g} {parameter.unit} · default {parameter.default:g}<br>"
            "Drag · double-click types · right-click resets · Shift finer"
        )
        bar.previewed.connect(lambda value: self._propose(parameter, value))
        bar.committed.connect(self._live.keep)
        bar.cancelled.connect(self._live.cancel)
        return bar

    def _propose(self, parameter: Parameter, value: float) -> None:
        muscles = self.muscles
        change = partial(_with_value, keys=[muscle.key for muscle in muscles], name=parameter.name, value=value)
        label = f"{parameter.title.partition(':')[0]} of {titles(muscles)}"
        self._told(lambda: self._live.propose(change, label))

    def _each(self, change: Callable[[Muscle], tuple[Muscle, str]]) -> None:
        """Change every selected muscle in one step."""
        muscles = self.muscles

        def act() -> None:
            project, label = self._context.document.project, ""
            for muscle in muscles:
                made, label = change(muscle_of(project, muscle.key))
                project = with_muscle(project, made)
            self._context.document.edit(project, f"{label} {titles(muscles)}")

        self._told(act)

    def _retitle(self) -> None:
        muscles = self.muscles
        wanted = self.title.text()
        if not muscles or not self.title.isEnabled() or wanted.strip() in ("", muscles[0].title):
            self.show_muscles()
            return

        def act() -> None:
            project = self._context.document.project
            both = tuple(titled(each, wanted) if each.name == muscles[0].name else each for each in project.muscles)
            self._context.document.edit(replace(project, muscles=both), f"Rename {muscles[0].title}")

        self._told(act)

    def _rename(self) -> None:
        muscles = self.muscles
        wanted = self.name.text().strip()
        if not muscles or not self.name.isEnabled() or wanted in ("", muscles[0].name):
            self.show_muscles()
            return

        def act() -> None:
            old = muscles[0].name
            project = renamed(self._context.document.project, old, wanted)
            keys = [replace(muscle, name=wanted).key for muscle in muscles]
            self._context.document.edit(project, f"Rename {old}")
            self._context.view.change(muscle=keys[0], others=frozenset(keys[1:]))

        self._told(act)

    def _told(self, act: Callable[[], None]) -> None:
        """Do something; what is wrong with it is told, and what is shown is what stands."""
        try:
            act()
        except RisoriusError as error:
            self._context.host.show_message(str(error))
            self.show_muscles()

    def _lay_out(self) -> None:
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(GRID)
        grid.setVerticalSpacing(GRID // 2)
        fields = (("Title", self.title), ("Name", self.name), ("Group", self.group), ("Model", self.model))
        for row, (caption, field) in enumerate(fields):
            words = _quiet(caption)
            words.setFixedWidth(CAPTION)
            words.setBuddy(field)
            grid.addWidget(words, row, 0)
            grid.addWidget(field, row, 1)
        self._rows.setSpacing(2)
        form = QVBoxLayout(self._form)
        form.setContentsMargins(0, 0, 0, 0)
        form.setSpacing(GRID)
        form.addLayout(grid)
        form.addLayout(self._rows)
        form.addWidget(self.users)
        layout = QVBoxLayout(self)
        layout.setSizeConstraint(QLayout.SizeConstraint.SetMinimumSize)
        layout.setContentsMargins(GRID, GRID, GRID, GRID)
        layout.addWidget(self._nothing)
        layout.addWidget(self._form)
        layout.addStretch(1)


def _with_value(project: Project, keys: list[str], name: str, value: float) -> Project:
    for key in keys:
        project = with_muscle(project, changed(muscle_of(project, key), name, value))
    return project


def _to_model(muscle: Muscle, model: str) -> tuple[Muscle, str]:
    return with_model(muscle, model), f"{MODELS[model].title} for"  # type: ignore[arg-type, index]


def _to_group(muscle: Muscle, group: str) -> tuple[Muscle, str]:
    return grouped(muscle, group), "Group of"


def _quiet(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "muted")
    label.setWordWrap(True)
    return label
