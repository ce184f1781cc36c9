"""The list of action units, in the groups of FACS; one of them is being worked on."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QPoint, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTreeWidget,
    QTreeWidgetItem,
)

from app.authoring.sculpting import sculpted_units
from app.document import Document
from app.view import View
from app.view_state import ViewState
from facemodel.actions import GROUP_TITLES, ActionUnit
from ui.panels.unit_text import muscle_titles, unit_matches, unit_title
from ui.theme.apply import current_theme, interface_font
from ui.theme.chosen import chosen_ground, quiet_ink
from ui.theme.metrics import GRID, ROW, SMALL_TYPE
from ui.widgets.empty_view import paint_empty
from ui.widgets.row_drag import Drop, RowDrag
from ui.widgets.sculpted_mark import paint_sculpted

NUMBER = Qt.ItemDataRole.UserRole + 1
EMPTY = Qt.ItemDataRole.UserRole + 2
"""Whether a unit moves nothing yet."""

GROUP = Qt.ItemDataRole.UserRole + 3
"""Which group a heading is of."""

WEIGHT = Qt.ItemDataRole.UserRole + 4
"""What the sliders of a unit say, as it is written; empty at zero."""

SCULPTED = Qt.ItemDataRole.UserRole + 5
"""Whether somebody has sculpted a unit."""

NO_UNITS = "No action unit yet. Make one with the plus above, or fill all of them from the FACS table."

NUMBER_WIDTH = 4 * GRID
STEPS = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}

Cell = QModelIndex | QPersistentModelIndex
SELECTED, HOVERED = QStyle.StateFlag.State_Selected, QStyle.StateFlag.State_MouseOver


class UnitCells(QStyledItemDelegate):
    """Draws a heading, or number, name and weight; a unit that moves nothing recedes."""

    def sizeHint(self, _option: QStyleOptionViewItem, _index: Cell) -> QSize:
        """One row of any width."""
        return QSize(0, ROW)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Cell) -> None:
        """Draw one row."""
        theme, area = current_theme(), QRectF(option.rect)
        painter.save()
        if index.data(NUMBER) is None:
            words = index.data(Qt.ItemDataRole.DisplayRole)
            painter.setFont(interface_font(SMALL_TYPE))
            painter.setPen(QColor(theme.muted))
            painter.drawText(area.adjusted(GRID, 0, -GRID, 0), CENTRE | LEFT, words.upper())
        else:
            if option.state & SELECTED:
                painter.fillRect(area, chosen_ground(theme))
            elif option.state & HOVERED:
                painter.fillRect(area, QColor(theme.hover))
            if index.data(SCULPTED):
                paint_sculpted(painter, area)
            self._paint_unit(painter, area, index, bool(option.state & SELECTED))
        painter.restore()

    def _paint_unit(self, painter: QPainter, area: QRectF, index: Cell, chosen: bool) -> None:
        theme = current_theme()
        quiet = quiet_ink(theme, chosen)
        words, weight = index.data(Qt.ItemDataRole.DisplayRole), index.data(WEIGHT) or ""
        painter.setPen(quiet)
        painter.drawText(
            QRectF(area.x(), area.y(), NUMBER_WIDTH, area.height()), CENTRE | RIGHT, str(index.data(NUMBER))
        )
        room = area.adjusted(NUMBER_WIDTH + GRID, 0, -GRID, 0)
        painter.setPen(QColor(theme.text))
        painter.drawText(room, CENTRE | RIGHT, weight)
        painter.setPen(quiet if index.data(EMPTY) else QColor(theme.text))
        width = room.width() - painter.fontMetrics().horizontalAdvance(weight) - (GRID if weight else 0)
        name = painter.fontMetrics().elidedText(words, Qt.TextElideMode.ElideRight, int(width))
        painter.drawText(room, CENTRE | LEFT, name)


CENTRE, LEFT, RIGHT = (Qt.AlignmentFlag.AlignVCenter, Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignRight)


class UnitList(RowDrag, QTreeWidget):
    """Binds the action unit in hand to a list, both ways.

    Signals
    -------
    hovered(object) : the ActionUnit under the pointer, or None
    deleted(), renamed() : the keys Delete and F2 were pressed
    stepped(int) : Alt and an arrow were pressed, up -1 or down 1
    dropped(object, object) : the number of a unit that was dragged, and the group and the unit in front of which it
        is to stand, none for the end of the group
    """

    hovered = Signal(object)
    deleted = Signal()
    renamed = Signal()
    stepped = Signal(int)
    dropped = Signal(object, object)

    def __init__(self, document: Document, view: View) -> None:
        super().__init__()
        self._document, self._view = document, view
        self._query = ""
        self._listed: list[tuple[int, str, str]] = []
        self.setHeaderHidden(True)
        self.setIndentation(0)
        self.setRootIsDecorated(False)
        self.setUniformRowHeights(True)
        self.setMouseTracking(True)
        self.setAccessibleName("Action units")
        self.setItemDelegate(UnitCells(self))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.show_units()
        self.currentItemChanged.connect(self._choose)
        self.itemEntered.connect(lambda item, _column: self.hovered.emit(self._unit(item.data(0, NUMBER))))
        document.project_changed.connect(lambda _project: self.show_units())
        document.units_changed.connect(lambda _numbers: self.show_units())
        document.corrections_changed.connect(lambda _fields: self._show_state())
        document.expression_changed.connect(lambda _now: self._show_state())
        view.changed.connect(self._follow)

    def show_units(self) -> None:
        """List the units anew, if any of them is listed otherwise."""
        units = self._document.project.units
        listed = [(unit.number, unit.name, unit.group) for unit in units]
        if listed != self._listed:
            self._listed = listed
            self._fill()
        self._show_state()
        self.filter(self._query)
        self._mark(self._view.state.unit)

    def _show_state(self) -> None:
        """Show what units weigh, and which of them move nothing or are sculpted."""
        shown, sculpted = self._document.shown, sculpted_units(self._document.project)
        units = {unit.number: unit for unit in self._document.project.units}
        self.blockSignals(True)
        for row in self._rows():
            unit = units.get(row.data(0, NUMBER))
            if unit is not None:
                row.setData(0, EMPTY, _moves_nothing(unit) and unit.number not in sculpted)
                row.setData(0, SCULPTED, unit.number in sculpted)
                row.setData(0, WEIGHT, _written([shown.get(field, 0.0) for field in unit.fields]))
        self.blockSignals(False)
        self.viewport().update()

    def filter(self, query: str) -> None:
        """Show the units that a search means, by number, name or muscle."""
        self._query = query
        titles = muscle_titles(self._document.project.muscles)
        for place in range(self.topLevelItemCount()):
            heading = self.topLevelItem(place)
            shown = 0
            for k in range(heading.childCount()):
                unit = self._unit(heading.child(k).data(0, NUMBER))
                fits = unit is not None and unit_matches(query, unit, titles)
                heading.child(k).setHidden(not fits)
                shown += fits
            heading.setHidden(not shown)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Delete, F2 and Alt with an arrow mean the unit, the rest moves through the list."""
        if event.modifiers() & Qt.KeyboardModifier.AltModifier and event.key() in STEPS:
            self.stepped.emit(STEPS[Qt.Key(event.key())])
        elif event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.deleted.emit()
        elif event.key() == Qt.Key.Key_F2:
            self.renamed.emit()
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The rows, or what to do to have some."""
        super().paintEvent(event)
        if not self._document.project.units:
            paint_empty(self, NO_UNITS)

    def leaveEvent(self, event: object) -> None:
        """Nothing is under the pointer any more."""
        super().leaveEvent(event)  # type: ignore[arg-type]
        self.hovered.emit(None)

    def row_at(self, place: QPoint) -> object:
        """The number of the unit at a place."""
        item = self.itemAt(place)
        return item.data(0, NUMBER) if item is not None else None

    def drop_at(self, place: QPoint) -> Drop | None:
        """In front of the unit or behind it, whichever half the pointer is on; on a heading at the top of its group."""
        item = self.itemAt(place)
        if item is None:
            *_, last = (None, *(row for row in self._rows() if not row.isHidden()))
            return last and Drop((last.parent().data(0, GROUP), None), self.visualItemRect(last).bottom())
        area = self.visualItemRect(item)
        if item.parent() is None:
            first = item.child(0)
            return Drop((item.data(0, GROUP), first.data(0, NUMBER)), area.bottom())
        group = item.parent().data(0, GROUP)
        if place.y() < area.center().y():
            return Drop((group, item.data(0, NUMBER)), area.top())
        after = item.parent().child(item.parent().indexOfChild(item) + 1)
        return Drop((group, after.data(0, NUMBER) if after is not None else None), area.bottom() + 1)

    def row_of(self, number: int) -> QTreeWidgetItem | None:
        """The row of a unit."""
        return next((item for item in self._rows() if item.data(0, NUMBER) == number), None)

    def _fill(self) -> None:
        self.blockSignals(True)
        self.clear()
        for group, title in GROUP_TITLES.items():
            units = [unit for unit in self._document.project.units if unit.group == group]
            if not units:
                continue
            heading = QTreeWidgetItem(self, [title])
            heading.setData(0, GROUP, group)
            heading.setFlags(Qt.ItemFlag.ItemIsEnabled)
            for unit in units:
                row = QTreeWidgetItem(heading, [unit_title(unit)])
                row.setData(0, NUMBER, unit.number)
            heading.setExpanded(True)
        self.blockSignals(False)

    def _rows(self) -> Iterator[QTreeWidgetItem]:
        for place in range(self.topLevelItemCount()):
            heading = self.topLevelItem(place)
            yield from (heading.child(k) for k in range(heading.childCount()))

    def _unit(self, number: int | None) -> ActionUnit | None:
        return next((unit for unit in self._document.project.units if unit.number == number), None)

    def _choose(self, item: QTreeWidgetItem | None) -> None:
        if item is not None and item.data(0, NUMBER) is not None:
            self._view.change(unit=item.data(0, NUMBER))

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if now.unit != before.unit:
            self._mark(now.unit)

    def _mark(self, number: int | None) -> None:
        self.blockSignals(True)
        row = self.row_of(number) if number is not None else None
        if row is None:
            self.clearSelection()
            self.setCurrentItem(None)
        else:
            self.setCurrentItem(row)
            self.scrollToItem(row)
        self.blockSignals(False)
        self.viewport().update()


def _moves_nothing(unit: ActionUnit) -> bool:
    return not (unit.muscles or unit.jaw or unit.eyes or unit.head or unit.tongue)


def _written(weights: list[float]) -> str:
    """Weights of one side or two as few figures; nothing where all are zero."""
    if not any(weights):
        return ""
    return f"{weights[0]:.2f}" if len(set(weights)) == 1 else " · ".join(f"{weight:.2f}" for weight in weights)
