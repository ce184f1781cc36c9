"""The expression panel: search, emotions, and every action unit in the groups of FACS."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QLineEdit, QScrollArea, QToolButton, QVBoxLayout, QWidget

from app.authoring.sculpting import sculpted_units
from app.document import Document
from app.view import View
from app.view_state import ViewState
from facemodel.actions import GROUP_TITLES, Expression
from facemodel.project import Project
from ui.panels.emotion_bar import EmotionBar
from ui.panels.unit_row import UnitRow
from ui.panels.unit_text import muscle_titles, unit_matches
from ui.portraits import Portraits
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW
from ui.widgets.collapsible import Collapsible
from ui.widgets.paced import Paced

WIDTH = 43 * GRID
"""Wide enough for the longest name of a unit beside its number."""


class SearchLine(QLineEdit):
    """Filters while one types; Esc empties it, Enter goes to the first unit found."""

    left = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc and Enter lead away, the rest is typing."""
        if event.key() == Qt.Key.Key_Escape and self.text():
            self.clear()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Down):
            self.left.emit()
        else:
            super().keyPressEvent(event)


NOTHING_FOUND = "No action unit has that number, name or muscle."
NO_UNIT = "This head has no action unit yet. The Actions workspace makes them of muscles and jaw."


class ExpressionPanel(QWidget):
    """Shows the expression of a document and lets it be changed.

    Signals
    -------
    muscles_hovered(object) : frozenset of the keys of the muscles that move what is under the pointer
    folds_changed(object) : frozenset of the keys of the folded groups
    """

    muscles_hovered = Signal(object)
    folds_changed = Signal(object)

    def __init__(self, document: Document, view: View, portraits: Portraits) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setMinimumWidth(WIDTH)
        self._document = document
        self._view = view
        self.rows: dict[int, UnitRow] = {}
        self.groups: dict[str, Collapsible] = {}
        self._folded: frozenset[str] = frozenset()
        self._pace = Paced(self.show_expression, self)
        self._own = document.project.expression
        self.search = SearchLine()
        self.link = _tool("link-variant", "Move left and right together", view.state.linked)
        self.reset = _tool("restore", "Relax the whole face (0)")
        self.emotions = EmotionBar(document, portraits)
        self._nothing = QLabel()
        self._lay_out()
        self.show_project(document.project)
        self._connect()

    def show_project(self, project: Project) -> None:
        """Make the rows anew for the units of a project."""
        for group in self.groups.values():
            group.hide()
            group.deleteLater()
        titles = muscle_titles(project.muscles)
        self.groups = {}
        self.rows = {}
        for key, title in GROUP_TITLES.items():
            units = [unit for unit in project.units if unit.group == key]
            if units:
                self.groups[key] = Collapsible(title)
            for unit in units:
                self.rows[unit.number] = UnitRow(self._document, self._view, unit, titles)
                self.rows[unit.number].hovered.connect(self.muscles_hovered)
                self.groups[key].rows.addWidget(self.rows[unit.number])
        for place, (key, group) in enumerate(self.groups.items()):
            group.folded.connect(lambda folded, key=key: self._note_fold(key, folded))
            self._list.insertWidget(place, group)
        self.emotions.show_project(project)
        self.fold(self._folded)
        self._filter(self.search.text())
        self.show_expression(self._document.shown)

    def show_expression(self, expression: Expression) -> None:
        """Bring every row up to an expression."""
        for row in self.rows.values():
            row.show_expression(expression)
        for key, group in self.groups.items():
            group.heading.set_active(sum(r.changed for r in self.rows.values() if r.unit.group == key))
        self.emotions.show_expression(expression)
        self.reset.setEnabled(any(expression.values()))

    def fold(self, keys: frozenset[str]) -> None:
        """Fold the groups of these keys and unfold the others."""
        self._folded = keys
        for key, group in self.groups.items():
            group.fold(key in keys)

    def focus_search(self) -> None:
        """Let the keyboard search."""
        self.search.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.search.selectAll()

    def focus_unit(self, number: int) -> None:
        """Bring the row of an action unit into view and put the keyboard on its bar."""
        row = self.rows[number]
        self.search.clear()
        self.groups[row.unit.group].fold(False)
        row.slider.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self._area.ensureWidgetVisible(row, 0, 4 * ROW)

    def _connect(self) -> None:
        self._document.project_changed.connect(self.show_project)
        self._document.units_changed.connect(self._follow_units)
        self._document.muscles_changed.connect(self._follow_units)
        self._document.emotions_changed.connect(lambda _names: self.emotions.show_project(self._document.project))
        self._document.corrections_changed.connect(self._mark_sculpted)
        self._document.expression_changed.connect(self._follow)
        self._view.changed.connect(self._show_view)
        self.search.textChanged.connect(self._filter)
        self.search.left.connect(self._go_to_first)
        self.link.clicked.connect(lambda on: self._view.change(linked=on))
        self.reset.clicked.connect(lambda: self._document.reset_expression())

    def _follow(self, expression: Expression) -> None:
        """What people set is seen at once; what a playhead shows, as often as it can be read."""
        before, self._own = self._own, self._document.project.expression
        set_by_hand = self._document.held or self._own is not before
        (self._pace.hurry if set_by_hand else self._pace.offer)(expression)

    def _follow_units(self, _changed: object) -> None:
        """Rows stay where only what units are made of is other than before."""
        project = self._document.project
        listed = [(row.unit.number, row.unit.name, row.unit.paired) for row in self.rows.values()]
        ordered = [unit for key in GROUP_TITLES for unit in project.units if unit.group == key]
        if listed != [(unit.number, unit.name, unit.paired) for unit in ordered]:
            self.show_project(project)
            return
        titles = muscle_titles(project.muscles)
        for unit in ordered:
            self.rows[unit.number].become(unit, titles)

    def _mark_sculpted(self, _fields: object) -> None:
        sculpted = sculpted_units(self._document.project)
        for number, row in self.rows.items():
            row.mark_sculpted(number in sculpted)

    def _show_view(self, now: ViewState, _before: ViewState) -> None:
        self.link.setChecked(now.linked)
        self.link.setIcon(icon("link-variant" if now.linked else "link-variant-off"))

    def _filter(self, query: str) -> None:
        """Show the units that a search finds; folded groups open while one searches."""
        titles = muscle_titles(self._document.project.muscles)
        found: set[str] = set()
        for row in self.rows.values():
            matches = unit_matches(query, row.unit, titles)
            row.setVisible(matches)
            if matches:
                found.add(row.unit.group)
        for key, group in self.groups.items():
            group.setVisible(key in found)
            group.fold(key in self._folded and not query.strip())
        self._nothing.setText(NOTHING_FOUND if self.rows else NO_UNIT)
        self._nothing.setVisible(not found)

    def _go_to_first(self) -> None:
        visible = (row for row in self.rows.values() if row.isVisibleTo(self))
        first = next(visible, None)
        if first is not None:
            first.slider.setFocus(Qt.FocusReason.TabFocusReason)

    def _note_fold(self, key: str, folded: bool) -> None:
        self._folded = self._folded | {key} if folded else self._folded - {key}
        self.folds_changed.emit(self._folded)

    def _lay_out(self) -> None:
        self.search.setPlaceholderText("Search number, name or muscle")
        self.search.setAccessibleName("Search action units")
        self.search.setClearButtonEnabled(True)
        self.search.addAction(icon("magnify"), QLineEdit.ActionPosition.LeadingPosition)
        head = QHBoxLayout()
        head.setSpacing(2)
        for widget in (self.search, self.link, self.reset):
            head.addWidget(widget)
        top = QVBoxLayout()
        top.setContentsMargins(GRID, GRID, GRID, GRID)
        top.setSpacing(GRID)
        top.addLayout(head)
        top.addWidget(self.emotions)
        self._list = QVBoxLayout()
        self._list.setContentsMargins(0, 0, 0, GRID)
        self._list.setSpacing(0)
        self._nothing.setProperty("role", "muted")
        self._nothing.setWordWrap(True)
        self._nothing.setContentsMargins(2 * GRID, 2 * GRID, GRID, GRID)
        self._nothing.hide()
        self._list.addWidget(self._nothing)
        self._list.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(top)
        layout.addWidget(_line())
        self._area = _scrolled(self._list)
        layout.addWidget(self._area, 1)


def _tool(glyph: str, text: str, checked: bool | None = None) -> QToolButton:
    button = QToolButton()
    button.setIcon(icon(glyph))
    button.setToolTip(text)
    button.setAccessibleName(text)
    button.setFixedSize(ROW, ROW)
    if checked is not None:
        button.setCheckable(True)
        button.setChecked(checked)
    return button


def _line() -> QFrame:
    line = QFrame()
    line.setProperty("role", "line")
    return line


def _scrolled(content: QVBoxLayout) -> QScrollArea:
    inside = QWidget()
    inside.setLayout(content)
    area = QScrollArea()
    area.setWidget(inside)
    area.setWidgetResizable(True)
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    return area
