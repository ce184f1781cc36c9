"""The tree of muscles: groups from brow to chin, one row a muscle, its sides as chips, an eye and a padlock."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QItemSelectionModel, QModelIndex, QRect, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPalette, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTreeWidget, QTreeWidgetItem

from app.document import Document
from app.view import View
from app.view_state import ViewState
from facemodel.laying.values import GROUPS
from facemodel.muscles import Muscle
from ui.panels.muscles.tree_cells import (
    COLOUR,
    EYE,
    GROUP,
    KEYS,
    LEFT,
    LOCK,
    NAME,
    RIGHT,
    SHARE,
    SIDE,
    Cell,
    MuscleCells,
)
from ui.theme.metrics import GRID
from ui.viewport.overlays.muscle_colours import GROUPS as GROUPS_SEEN
from ui.viewport.overlays.muscle_colours import OTHER
from ui.widgets.plain_label import as_written

CHIP = 22
SIDE_NAMES = {"L": "the subject’s left", "R": "the subject’s right", "M": "across the midline"}
QUIET_TITLES = {group: group.capitalize() for group in GROUPS}
SWITCHES = {EYE: ("Hide", "Show"), LOCK: ("Lock", "Unlock")}
"""What a click on a switch does that is off, and on one that is on."""

Flag = QItemSelectionModel.SelectionFlag


class MuscleTree(QTreeWidget):
    """Binds the selected muscles of a view to a tree, both ways.

    Signals
    -------
    hovered(object) : frozenset of the keys under the pointer
    deleted(), renamed() : the keys Delete and F2 were pressed
    """

    hovered = Signal(object)
    deleted = Signal()
    renamed = Signal()

    def __init__(self, document: Document, view: View) -> None:
        super().__init__()
        self._document = document
        self._view = view
        self._query = ""
        self._folded: set[str] = set()
        self._drawing: tuple[int, bool] | None = None
        self.setColumnCount(5)
        self.setHeaderHidden(True)
        self.setIndentation(2 * GRID)
        self.setUniformRowHeights(True)
        self.setMouseTracking(True)
        self.setAccessibleName("Muscles")
        self._cells = MuscleCells(self)
        self.setItemDelegate(self._cells)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectItems)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        bare = self.palette()
        bare.setColor(QPalette.ColorRole.Highlight, QColor(0, 0, 0, 0))
        self.setPalette(bare)
        self.header().setStretchLastSection(False)
        self.header().setMinimumSectionSize(CHIP)
        self.header().setSectionResizeMode(NAME, QHeaderView.ResizeMode.Stretch)
        for column in (LEFT, RIGHT, EYE, LOCK):
            self.header().setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
            self.header().resizeSection(column, CHIP + 4)
        self.show_muscles()
        self.itemSelectionChanged.connect(self._choose)
        self.itemCollapsed.connect(lambda item: self._note_fold(item, True))
        self.itemExpanded.connect(lambda item: self._note_fold(item, False))
        self.itemEntered.connect(self._enter)
        document.project_changed.connect(lambda _project: self.show_muscles())
        document.muscles_changed.connect(lambda _keys: self.show_muscles())
        view.changed.connect(self._follow)

    def show_muscles(self) -> None:
        """List the muscles anew; folds and selection stay."""
        self.blockSignals(True)
        self.clear()
        muscles = self._document.project.muscles
        groups = (*GROUPS, *sorted({muscle.group for muscle in muscles} - set(GROUPS)))
        for group in groups:
            rows = _by_name(muscle for muscle in muscles if muscle.group == group)
            if rows:
                self._add_group(group, rows)
        self.blockSignals(False)
        self.filter(self._query)
        self._mark(self._view.state)
        self._show_switches(self._view.state)

    def filter(self, query: str) -> None:
        """Show the muscles whose title, name or group has every word of a search."""
        self._query = query
        words = query.lower().split()
        for heading in self._headings():
            shown = 0
            for row in _children(heading):
                keys = " ".join(row.data(NAME, KEYS)).replace("_", " ")
                text = f"{row.text(NAME)} {keys} {heading.text(NAME)}".lower()
                row.setHidden(not all(word in text for word in words))
                shown += not row.isHidden()
            heading.setHidden(not shown)
            if words:
                self.blockSignals(True)
                heading.setExpanded(True)
                self.blockSignals(False)

    def item_of(self, key: str) -> tuple[QTreeWidgetItem, int] | None:
        """Row and column of a muscle's own cell."""
        for heading in self._headings():
            for row in _children(heading):
                for column in (LEFT, RIGHT):
                    if key in (row.data(column, KEYS) or ()):
                        return row, column
        return None

    def drawBranches(self, painter: QPainter, rect: QRect, index: Cell) -> None:
        """The triangles of the headings, and nothing beside the names."""
        if index.data(GROUP):
            super().drawBranches(painter, rect, index)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Delete and F2 mean the muscles, the rest moves through the tree."""
        if event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.deleted.emit()
        elif event.key() == Qt.Key.Key_F2:
            self.renamed.emit()
        else:
            super().keyPressEvent(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A click beside all names selects nothing; on an eye or a padlock it switches that and nothing else."""
        place = event.position().toPoint()
        item, column = self.itemAt(place), self.columnAt(place.x())
        if item is None:
            self._view.change(muscle="")
        elif column in SWITCHES:
            if event.button() == Qt.MouseButton.LeftButton:
                self._drawing = column, item.data(column, SHARE) != 1.0
                self._switch(item)
            return
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drawn over other rows, a switch that is held does the same to them."""
        if self._drawing is None:
            super().mouseMoveEvent(event)
            return
        item = self.itemAt(event.position().toPoint())
        if item is not None:
            self._switch(item)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go of a switch."""
        if self._drawing is None:
            super().mouseReleaseEvent(event)
        self._drawing = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """The second click on a switch is one more click; on a heading it folds the group."""
        if self.columnAt(int(event.position().x())) in SWITCHES:
            self.mousePressEvent(event)
        else:
            super().mouseDoubleClickEvent(event)

    def leaveEvent(self, event: object) -> None:
        """Nothing is under the pointer any more."""
        super().leaveEvent(event)  # type: ignore[arg-type]
        self._cells.under = QModelIndex()
        self.viewport().update()
        self.hovered.emit(frozenset())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """What is selected stays in sight."""
        super().resizeEvent(event)
        if self.currentIndex().isValid():
            self.scrollTo(self.currentIndex())

    def _add_group(self, group: str, rows: dict[str, list[Muscle]]) -> None:
        heading = QTreeWidgetItem(self, [QUIET_TITLES.get(group, group.capitalize())])
        heading.setData(NAME, GROUP, group)
        heading.setData(NAME, COLOUR, QColor.fromRgbF(*GROUPS_SEEN.get(group, OTHER)).name())
        heading.setToolTip(NAME, as_written(f"Click to select all muscles of this group ({group})"))
        keys = tuple(muscle.key for muscles in rows.values() for muscle in muscles)
        for column in (NAME, EYE, LOCK):
            heading.setData(column, KEYS, keys)
        for muscles in rows.values():
            row = QTreeWidgetItem(heading, [muscles[0].title])
            row.setData(NAME, KEYS, tuple(muscle.key for muscle in muscles))
            row.setToolTip(NAME, as_written(f"{muscles[0].title} ({muscles[0].name})"))
            row.setData(NAME, COLOUR, muscles[0].colour)
            for column in (EYE, LOCK):
                row.setData(column, KEYS, row.data(NAME, KEYS))
            for muscle in muscles:
                column = RIGHT if muscle.side == "R" else LEFT
                row.setText(column, "•" if muscle.side == "M" else muscle.side)
                row.setData(column, KEYS, (muscle.key,))
                row.setData(column, SIDE, muscle.side)
                row.setToolTip(column, as_written(f"{muscle.title}, {SIDE_NAMES[muscle.side]}"))
        heading.setExpanded(group not in self._folded)

    def _headings(self) -> Iterator[QTreeWidgetItem]:
        return (self.topLevelItem(k) for k in range(self.topLevelItemCount()))

    def _note_fold(self, item: QTreeWidgetItem, folded: bool) -> None:
        (self._folded.add if folded else self._folded.discard)(item.data(NAME, GROUP))

    def _enter(self, item: QTreeWidgetItem, column: int) -> None:
        """Tell what is under the pointer, and show the switches of its row."""
        self._cells.under = self.indexFromItem(item, NAME)
        self.viewport().update()
        self.hovered.emit(frozenset(item.data(column, KEYS) or ()) if not item.data(NAME, GROUP) else frozenset())

    def _switch(self, item: QTreeWidgetItem) -> None:
        """Do to the muscles of a row what the switch that is held does."""
        assert self._drawing is not None
        column, on = self._drawing
        (self._view.hide if column == EYE else self._view.lock)(item.data(column, KEYS), on)

    def _show_switches(self, state: ViewState) -> None:
        """Eyes and padlocks as what is hidden and locked asks for."""
        for heading in self._headings():
            for row in (heading, *_children(heading)):
                for column, keys in ((EYE, state.hidden), (LOCK, state.locked)):
                    own = row.data(column, KEYS)
                    share = sum(key in keys for key in own) / len(own)
                    row.setData(column, SHARE, share)
                    row.setToolTip(column, SWITCHES[column][share == 1.0])
                row.setData(NAME, SHARE, row.data(EYE, SHARE) == 1.0)
                for column in (LEFT, RIGHT):
                    row.setData(column, SHARE, bool(set(row.data(column, KEYS) or ()) & state.hidden))

    def _choose(self) -> None:
        """Tell the view which muscles the selected cells stand for; the cell in hand names the one selected last."""
        keys: dict[str, None] = {}
        current = self.currentIndex()
        cells = sorted(self.selectedIndexes(), key=lambda cell: cell != current)
        cells = [cell for cell in cells if cell.column() not in SWITCHES]
        for cell in cells:
            keys |= dict.fromkeys(cell.data(KEYS) or ())
        first, *others = keys or [""]
        self._view.change(muscle=first, others=frozenset(others))

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if (now.muscle, now.others) != (before.muscle, before.others):
            self._mark(now)
        if (now.hidden, now.locked) != (before.hidden, before.locked):
            self._show_switches(now)

    def _mark(self, state: ViewState) -> None:
        """Select the cells of the selected muscles: a name where both of its sides are."""
        self.blockSignals(True)
        selection = self.selectionModel()
        selection.clearSelection()
        for heading in self._headings():
            for row in _children(heading):
                chosen = [key for key in row.data(NAME, KEYS) if key in state.selected]
                if not chosen:
                    continue
                whole = len(chosen) == len(row.data(NAME, KEYS))
                columns = (NAME, LEFT, RIGHT) if whole else ()
                for column in (LEFT, RIGHT, *columns):
                    own = row.data(column, KEYS) or ()
                    if set(own) & set(chosen):
                        selection.select(self.indexFromItem(row, column), Flag.Select)
                if state.muscle in chosen:
                    self.scrollToItem(row)
                    column = NAME if whole else (LEFT if state.muscle in (row.data(LEFT, KEYS) or ()) else RIGHT)
                    selection.setCurrentIndex(self.indexFromItem(row, column), Flag.NoUpdate)
        self.blockSignals(False)
        self.viewport().update()


def _by_name(muscles: Iterator[Muscle]) -> dict[str, list[Muscle]]:
    rows: dict[str, list[Muscle]] = {}
    for muscle in muscles:
        rows.setdefault(muscle.name, []).append(muscle)
    return rows


def _children(item: QTreeWidgetItem) -> Iterator[QTreeWidgetItem]:
    return (item.child(k) for k in range(item.childCount()))
