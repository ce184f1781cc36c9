"""What one action unit is made of: how strongly it contracts its muscles, the jaw, and how far the skin is to go."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLayout,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.actions.action import perform
from app.actions.context import Context
from app.authoring.units import renamed, renumbered, unit_of, with_group, with_note, with_unit
from app.view_state import ViewState
from facemodel.actions import GROUP_TITLES, ActionUnit, JawMotion
from facemodel.errors import RisoriusError
from facemodel.project import Project
from ui.panels.actions.unit_deeds import UNIT_ACTIONS, in_hand, reached
from ui.panels.actions.unit_range import UnitRange
from ui.panels.actions.unit_weights import UnitWeights, heading
from ui.panels.live_edit import LiveEdit
from ui.panels.unit_text import unit_title
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

CAPTION = 9 * GRID

OPENING = NumberScale(0.0, 45.0, 0.0, "°")
SLIDE = NumberScale(-5.0, 15.0, 0.0, "mm")
AMPLITUDE = NumberScale(0.0, 60.0, 5.0, "mm", bend=1.6)

FIT = next(action for action in UNIT_ACTIONS if action.id == "unit.fit")


class UnitEditor(QWidget):
    """Binds the action unit in hand to fields and bars, both ways.

    Signals
    -------
    hovered(object) : frozenset of the keys of the muscles under the pointer
    """

    hovered = Signal(object)

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self._live = LiveEdit(context.document, context.solving)
        self.number, self.name, self.note = _line("Number"), _line("Name"), _line("Note")
        self.note.setPlaceholderText("A line for people")
        self.group = QComboBox()
        self.group.setAccessibleName("Group")
        for group, title in GROUP_TITLES.items():
            self.group.addItem(title, group)
        self.muscles = UnitWeights(context, self._bar, self._change)
        self.muscles.hovered.connect(self.hovered)
        self.opening = self._bar("Opening", OPENING, lambda unit, value: _jaw(unit, degrees=value))
        self.slide = self._bar("Slide forward", SLIDE, lambda unit, value: _jaw(unit, slide=value))
        self.amplitude = self._bar("Meant to move", AMPLITUDE, lambda unit, value: replace(unit, amplitude=value))
        self.range = UnitRange(context)
        self.moved = _quiet("")
        self.fit = QPushButton("Fit")
        self.fit.setToolTip(FIT.hint)
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
        _put(self.number, str(unit.number))
        _put(self.name, unit_title(unit))
        _put(self.note, unit.note)
        self.group.setCurrentIndex(self.group.findData(unit.group))
        jaw = unit.jaw or JawMotion(0.0)
        shown = ((self.opening, jaw.degrees), (self.slide, jaw.slide), (self.amplitude, unit.amplitude))
        for bar, value in shown:
            if not bar.held:
                bar.set_value(value)
        self.range.show_unit(unit)
        self.muscles.show_unit(unit)
        self.show_result()

    def show_result(self, *_what: object) -> None:
        """Show how far the skin goes, as it is solved."""
        unit = self.unit
        if unit is None:
            return
        moved = reached(self._context, unit)
        self.moved.setText("solving …" if moved is None else f"moves {moved:.1f} mm at 1")
        self.fit.setEnabled(FIT.enabled(self._context))

    def focus_name(self) -> None:
        """Put the keyboard into the name."""
        self.name.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.name.selectAll()

    def _connect(self) -> None:
        document = self._context.document
        for changed in (document.project_changed, document.units_changed, document.muscles_changed):
            changed.connect(self.show_unit)
        document.solution_changed.connect(self.show_result)
        self._context.view.changed.connect(self._follow)
        self.number.editingFinished.connect(self._renumber)
        self.name.editingFinished.connect(self._rename)
        self.note.editingFinished.connect(self._annotate)
        self.group.activated.connect(lambda _row: self._regroup())
        self.fit.clicked.connect(lambda: perform(FIT, self._context))

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if now.unit != before.unit:
            self.show_unit()

    def _bar(self, label: str, scale: NumberScale, change: Callable[[ActionUnit, float], ActionUnit]) -> NumberBar:
        bar = NumberBar(label, scale)
        bar.previewed.connect(lambda value: self._propose(change, value, label))
        bar.committed.connect(self._live.keep)
        bar.cancelled.connect(self._live.cancel)
        return bar

    def _propose(self, change: Callable[[ActionUnit, float], ActionUnit], value: float, label: str) -> None:
        unit = self.unit
        if unit is None:
            return

        def act(project: Project) -> Project:
            return with_unit(project, change(unit_of(project, unit.number), value))

        self._told(lambda: self._live.propose(act, f"{label} in AU {unit.number}"))

    def _change(self, change: Callable[[ActionUnit], ActionUnit], label: str) -> None:
        """Change the unit in one step."""
        unit = self.unit
        if unit is not None:
            project = with_unit(self._context.document.project, change(unit))
            self._context.document.edit(project, f"{label} AU {unit.number}")

    def _rename(self) -> None:
        unit = self.unit
        wanted = self.name.text().strip()
        if unit is None or wanted.lower() in ("", unit.name.lower()):
            self.show_unit()
            return
        self._step(lambda project: renamed(project, unit.number, wanted), f"Rename {unit_title(unit)}")

    def _renumber(self) -> None:
        unit = self.unit
        text = self.number.text().strip()
        if unit is None or not text.isdecimal() or int(text) == unit.number:
            self.show_unit()
            return
        if self._step(lambda project: renumbered(project, unit.number, int(text)), f"Number of {unit_title(unit)}"):
            self._context.view.change(unit=int(text))

    def _annotate(self) -> None:
        unit = self.unit
        if unit is not None and self.note.text().strip() != unit.note:
            self._step(lambda project: with_note(project, unit.number, self.note.text()), f"Note of {unit_title(unit)}")

    def _regroup(self) -> None:
        unit = self.unit
        if unit is not None and self.group.currentData() != unit.group:
            group = self.group.currentData()
            self._step(lambda project: with_group(project, unit.number, group), f"Group of {unit_title(unit)}")

    def _step(self, change: Callable[[Project], Project], label: str) -> bool:
        """Change the project in one step; whether that was possible."""
        document = self._context.document
        return self._told(lambda: document.edit(change(document.project), label))

    def _told(self, act: Callable[[], None]) -> bool:
        """Do something; what is wrong with it is told, and what is shown is what stands."""
        try:
            act()
        except RisoriusError as error:
            self._context.host.show_message(str(error))
            self.show_unit()
            return False
        return True

    def _lay_out(self) -> None:
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(GRID)
        grid.setVerticalSpacing(GRID // 2)
        self.number.setFixedWidth(7 * GRID)
        named = QHBoxLayout()
        named.setSpacing(GRID // 2)
        named.addWidget(self.number)
        named.addWidget(self.name, 1)
        grid.addWidget(_caption("Unit"), 0, 0)
        grid.addLayout(named, 0, 1)
        for row, (caption, field) in enumerate((("Group", self.group), ("Note", self.note)), start=1):
            grid.addWidget(_caption(caption), row, 0)
            grid.addWidget(field, row, 1)
        result = QHBoxLayout()
        result.setSpacing(GRID)
        result.addWidget(self.amplitude, 1)
        result.addWidget(self.fit)
        form = QVBoxLayout(self._form)
        form.setContentsMargins(0, 0, 0, 0)
        form.setSpacing(GRID // 2)
        form.addLayout(grid)
        form.addWidget(self.muscles)
        form.addSpacing(GRID)
        form.addWidget(heading("Jaw"))
        form.addWidget(self.opening)
        form.addWidget(self.slide)
        form.addSpacing(GRID)
        form.addWidget(heading("Skin"))
        form.addLayout(result)
        form.addWidget(self.moved)
        form.addSpacing(GRID)
        form.addWidget(self.range)
        layout = QVBoxLayout(self)
        layout.setSizeConstraint(QLayout.SizeConstraint.SetMinimumSize)
        layout.setContentsMargins(GRID, GRID, GRID, GRID)
        layout.addWidget(self._nothing)
        layout.addWidget(self._form)
        layout.addStretch(1)


def _jaw(unit: ActionUnit, degrees: float | None = None, slide: float | None = None) -> ActionUnit:
    jaw = unit.jaw or JawMotion(0.0)
    jaw = JawMotion(jaw.degrees if degrees is None else degrees, jaw.slide if slide is None else slide)
    return replace(unit, jaw=jaw if jaw.degrees or jaw.slide else None)


def _put(line: QLineEdit, text: str) -> None:
    if line.text() != text and not line.hasFocus():
        line.setText(text)


def _line(name: str) -> QLineEdit:
    line = QLineEdit()
    line.setAccessibleName(name)
    return line


def _quiet(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "muted")
    return label


def _caption(text: str) -> QLabel:
    label = _quiet(text)
    label.setFixedWidth(CAPTION - 2 * GRID)
    return label
