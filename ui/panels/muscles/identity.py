"""Who a muscle is: its title and name, group and colour, its model, and whether its sides are in step or locked."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QLineEdit, QSizePolicy, QToolButton, QWidget

from app.actions.action import Action, perform
from facemodel.laying.collection import renamed
from facemodel.laying.values import GROUPS, coloured, grouped, titled, with_model
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS, comparable_models
from ui.panels.actions.tool_button import tool_button
from ui.panels.muscles.actions import MUSCLE_ACTIONS
from ui.panels.muscles.colour_button import ColourButton
from ui.panels.muscles.editing import MuscleEdit
from ui.panels.muscles.selection import titles
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ICON
from ui.viewport.overlays.muscle_colours import colour_of
from ui.widgets.narrow_choice import narrow_choice

CAPTION = 8 * GRID

STATES = {
    "muscle.link": ("In step", "link-variant"),
    "muscle.lock": ("Locked", "lock-outline"),
    "muscle.hide": ("Hide", "eye-off-outline"),
}
"""Actions that say how the selected muscles are, with a word and a glyph."""


class MuscleIdentity(QWidget):
    """Binds what names and tells the selected muscles.

    Signals
    -------
    compared() : the models are to be compared side by side
    """

    compared = Signal()

    def __init__(self, edit: MuscleEdit) -> None:
        super().__init__()
        self._edit = edit
        self.title = _line("Title", "The name for people, on both sides")
        self.name = _line("Name", "The name for files, scripts and action units")
        self.model = narrow_choice("Model")
        self.group = narrow_choice("Group", "Where it belongs in the tree, and its colour")
        for group in GROUPS:
            self.group.addItem(group.capitalize(), group)
        self.colour = ColourButton()
        self.compare = tool_button("compare", "Compare all models side by side on this face", self.compared.emit)
        self.states = {action.id: self._state(action) for action in MUSCLE_ACTIONS if action.id in STATES}
        self._lay_out()
        self.title.editingFinished.connect(self._retitle)
        self.name.editingFinished.connect(self._rename)
        self.model.activated.connect(lambda _row: self.take_model(self.model.currentData()))
        self.group.activated.connect(
            lambda _row: edit.now(partial(grouped, group=self.group.currentData()), "Group of")
        )
        self.colour.chosen.connect(lambda colour: edit.now(partial(coloured, colour=colour), "Colour of"))

    def show_muscles(self, muscles: tuple[Muscle, ...]) -> None:
        """Show what is selected."""
        first = muscles[0]
        one_name = all(muscle.name == first.name for muscle in muscles)
        self.title.setText(first.title if one_name else titles(muscles))
        self.title.setCursorPosition(0)
        self.name.setText(first.name if one_name else "")
        self.name.setCursorPosition(0)
        free = not self._edit.locked
        for field in (self.title, self.name):
            field.setEnabled(one_name and free)
        self._show_choices(muscles)
        for control in (self.group, self.colour):
            control.setEnabled(free)
        self.model.setEnabled(free and self.model.count() > 1)
        context = self._edit.context
        for action in MUSCLE_ACTIONS:
            if action.id in self.states:
                self.states[action.id].setEnabled(action.enabled(context))
                self.states[action.id].setChecked(action.kind == "toggle" and action.checked(context))

    def take_model(self, model: str) -> None:
        """Let the selected muscles act by another model."""
        title = MODELS[model].title  # type: ignore[index]
        self._edit.now(partial(with_model, model=model), f"{title} for")  # type: ignore[arg-type]

    def _show_choices(self, muscles: tuple[Muscle, ...]) -> None:
        fitting = [model for model in MODELS if all(model in comparable_models(muscle) for muscle in muscles)]
        self.model.clear()
        for model in fitting:
            self.model.addItem(MODELS[model].title, model)
            self.model.setItemData(self.model.count() - 1, MODELS[model].source, Qt.ItemDataRole.ToolTipRole)
        alike = all(muscle.model == muscles[0].model for muscle in muscles)
        self.model.setCurrentIndex(fitting.index(muscles[0].model) if alike else -1)
        self.model.setToolTip(MODELS[muscles[0].model].source if alike else "Several models")
        self.compare.setEnabled(len(comparable_models(muscles[0])) > 1)
        groups = {muscle.group for muscle in muscles}
        self.group.setCurrentIndex(self.group.findData(muscles[0].group) if len(groups) == 1 else -1)
        colours = {_hex(muscle) for muscle in muscles}
        own = any(muscle.colour for muscle in muscles)
        self.colour.show_colour(colours.pop() if len(colours) == 1 else "", own)

    def _retitle(self) -> None:
        muscles = self._edit.muscles
        wanted = self.title.text()
        if not muscles or not self.title.isEnabled() or wanted.strip() in ("", muscles[0].title):
            return

        def act() -> None:
            self._edit.refuse_locked(muscles)
            project = self._edit.context.document.project
            both = tuple(titled(each, wanted) if each.name == muscles[0].name else each for each in project.muscles)
            self._edit.context.document.edit(replace(project, muscles=both), f"Rename {muscles[0].title}")

        self._edit.told(act)

    def _rename(self) -> None:
        muscles = self._edit.muscles
        wanted = self.name.text().strip()
        if not muscles or not self.name.isEnabled() or wanted in ("", muscles[0].name):
            return

        def act() -> None:
            self._edit.refuse_locked(muscles)
            context, old = self._edit.context, muscles[0].name
            project = renamed(context.document.project, old, wanted)
            keys = [replace(muscle, name=wanted).key for muscle in muscles]
            context.document.edit(project, f"Rename {old}")
            context.view.change(muscle=keys[0], others=frozenset(keys[1:]))

        self._edit.told(act)

    def _state(self, action: Action) -> QToolButton:
        words, glyph = STATES[action.id]
        button = QToolButton()
        button.setText(words)
        button.setIcon(icon(glyph))
        button.setIconSize(QSize(ICON, ICON))
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setToolTip(f"{action.title}: {action.hint}")
        button.setProperty("role", "choice")
        button.setCheckable(action.kind == "toggle")
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.clicked.connect(lambda _checked=False: perform(action, self._edit.context))
        return button

    def _lay_out(self) -> None:
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(GRID)
        grid.setVerticalSpacing(GRID // 2)
        states = QHBoxLayout()
        states.setSpacing(GRID // 2)
        for button in self.states.values():
            states.addWidget(button, 1)
        rows = (
            ("Title", (self.title,)),
            ("Name", (self.name,)),
            ("Group", (self.group, self.colour)),
            ("Model", (self.model, self.compare)),
        )
        for row, (caption, fields) in enumerate(rows):
            words = QLabel(caption)
            words.setProperty("role", "muted")
            words.setFixedWidth(CAPTION)
            words.setBuddy(fields[0])
            line = QHBoxLayout()
            line.setSpacing(GRID // 2)
            line.addWidget(fields[0], 1)
            for more in fields[1:]:
                line.addWidget(more)
            grid.addWidget(words, row, 0)
            grid.addLayout(line, row, 1)
        grid.addLayout(states, len(rows), 0, 1, 2)


def _line(name: str, hint: str) -> QLineEdit:
    line = QLineEdit()
    line.setAccessibleName(name)
    line.setToolTip(hint)
    return line


def _hex(muscle: Muscle) -> str:
    return "#" + "".join(f"{round(255 * part):02x}" for part in colour_of(muscle))
