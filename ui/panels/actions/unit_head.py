"""What an action unit is called: number, name, group and note."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QGridLayout, QHBoxLayout, QLabel, QLineEdit, QWidget

from app.actions.context import Context
from app.authoring.units import renamed, renumbered, with_group, with_note
from facemodel.actions import GROUP_TITLES, ActionUnit
from ui.panels.actions.unit_deeds import in_hand
from ui.panels.telling import step
from ui.panels.unit_text import unit_title
from ui.theme.metrics import GRID
from ui.widgets.plain_label import as_written

CAPTION = 7 * GRID
NUMBER = 7 * GRID


class UnitHead(QWidget):
    """Binds number, name, group and note of the unit in hand to fields, both ways."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self.number, self.name, self.note = _line("Number"), _line("Name"), _line("Note")
        self.number.setFixedWidth(NUMBER)
        self.note.setPlaceholderText("A line for people")
        self.group = QComboBox()
        self.group.setAccessibleName("Group")
        for group, title in GROUP_TITLES.items():
            self.group.addItem(title, group)
        self._lay_out()
        self.number.editingFinished.connect(self._renumber)
        self.name.editingFinished.connect(self._rename)
        self.note.editingFinished.connect(self._annotate)
        self.group.activated.connect(lambda _row: self._regroup())

    def show_unit(self, unit: ActionUnit) -> None:
        """Show what a unit is called; what is being typed stays."""
        _put(self.number, str(unit.number))
        _put(self.name, unit_title(unit))
        _put(self.note, one_line(unit.note))
        self.note.setToolTip(as_written(unit.note))
        self.group.setCurrentIndex(self.group.findData(unit.group))

    def focus_name(self) -> None:
        """Put the keyboard into the name."""
        self.name.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.name.selectAll()

    @property
    def _unit(self) -> ActionUnit | None:
        return in_hand(self._context)

    def _rename(self) -> None:
        unit = self._unit
        wanted = self.name.text().strip()
        if unit is not None and wanted and wanted.lower() != unit.name.lower():
            step(self._context, lambda project: renamed(project, unit.number, wanted), f"Rename {unit_title(unit)}")
        self._correct()

    def _renumber(self) -> None:
        unit = self._unit
        text = self.number.text().strip()
        if unit is not None and text.isdecimal() and int(text) != unit.number:
            label = f"Number of {unit_title(unit)}"
            if step(self._context, lambda project: renumbered(project, unit.number, int(text)), label):
                self._context.view.change(unit=int(text))
        self._correct()

    def _annotate(self) -> None:
        unit = self._unit
        text = self.note.text().strip()
        if unit is not None and text != one_line(unit.note):
            step(self._context, lambda project: with_note(project, unit.number, text), f"Note of {unit_title(unit)}")
        self._correct()

    def _regroup(self) -> None:
        unit, group = self._unit, self.group.currentData()
        if unit is not None and group != unit.group:
            step(self._context, lambda project: with_group(project, unit.number, group), f"Group of {unit_title(unit)}")

    def _correct(self) -> None:
        """Show what stands in place of what could not be taken, even where the keyboard still is."""
        unit = self._unit
        if unit is not None:
            self.number.setText(str(unit.number))
            self.name.setText(unit_title(unit))
            self.note.setText(one_line(unit.note))

    def _lay_out(self) -> None:
        named = QHBoxLayout()
        named.setSpacing(GRID // 2)
        named.addWidget(self.number)
        named.addWidget(self.name, 1)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(GRID)
        grid.setVerticalSpacing(GRID // 2)
        grid.addWidget(_caption("Unit"), 0, 0)
        grid.addLayout(named, 0, 1)
        for row, (caption, field) in enumerate((("Group", self.group), ("Note", self.note)), start=1):
            grid.addWidget(_caption(caption), row, 0)
            grid.addWidget(field, row, 1)


def one_line(note: str) -> str:
    """A note as a field of one line shows it; one of several lines is not changed by being looked at."""
    return " ".join(note.split())


def _put(line: QLineEdit, text: str) -> None:
    if line.text() != text and not line.hasFocus():
        line.setText(text)
        line.setCursorPosition(0)


def _line(name: str) -> QLineEdit:
    line = QLineEdit()
    line.setAccessibleName(name)
    return line


def _caption(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "muted")
    label.setFixedWidth(CAPTION)
    return label
