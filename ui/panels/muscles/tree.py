"""The tree of muscles: groups from brow to chin, one row a muscle, its sides as chips of their colours."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QItemSelectionModel, QModelIndex, QPersistentModelIndex, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPalette
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTreeWidget,
    QTreeWidgetItem,
)

from app.document import Document
from app.view import View
from app.view_state import ViewState
from facemodel.laying.values import GROUPS
from facemodel.muscles import Muscle
from ui.theme.apply import current_theme
from ui.theme.colour import blend, contrast
from ui.theme.metrics import GRID, RADIUS, ROW
from ui.viewport.overlays.muscles import GROUPS as GROUPS_SEEN

KEYS = Qt.ItemDataRole.UserRole + 1
"""Keys of the muscles that a cell stands for."""
SIDE = Qt.ItemDataRole.UserRole + 2
"""Side of a chip."""
GROUP = Qt.ItemDataRole.UserRole + 3
"""Group that a heading names."""

NAME, LEFT, RIGHT = range(3)
CHIP = 22
SWATCH = 8
"""Side of the colour that a group has on the face."""
ROLES = {"L": "left", "R": "right", "M": "both"}
SIDE_NAMES = {"L": "the subject’s left", "R": "the subject’s right", "M": "across the midline"}
QUIET_TITLES = {group: group.capitalize() for group in GROUPS}

Cell = QModelIndex | QPersistentModelIndex
Flag = QItemSelectionModel.SelectionFlag
SELECTED, HOVERED = QStyle.StateFlag.State_Selected, QStyle.StateFlag.State_MouseOver


class MuscleCells(QStyledItemDelegate):
    """Draws names and chips; a cell that is selected is filled with the colour of its side."""

    def sizeHint(self, _option: QStyleOptionViewItem, _index: Cell) -> QSize:
        """One row of any width."""
        return QSize(0, ROW)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Cell) -> None:
        """Draw a heading, a name or a chip."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        side = index.data(SIDE)
        if side:
            _paint_chip(painter, option, side, index.data(Qt.ItemDataRole.DisplayRole))
        elif index.column() == NAME:
            _paint_name(painter, option, index)
        painter.restore()


def _paint_chip(painter: QPainter, option: QStyleOptionViewItem, side: str, letter: str) -> None:
    theme = current_theme()
    area = QRectF(option.rect).adjusted(2, 3, -2, -3)
    colour, on = QColor(getattr(theme, ROLES[side])), bool(option.state & SELECTED)
    hovered = bool(option.state & HOVERED)
    painter.setPen(Qt.PenStyle.NoPen)
    if on or hovered:
        painter.setBrush(colour if on else blend(theme.panel, colour, 0.25))
        painter.drawRoundedRect(area, RADIUS, RADIUS)
    dark, light = QColor(theme.window), QColor(theme.on_accent)
    readable = dark if contrast(dark, colour) > contrast(light, colour) else light
    painter.setPen(readable if on else colour)
    painter.drawText(area, Qt.AlignmentFlag.AlignCenter, letter)


def _paint_name(painter: QPainter, option: QStyleOptionViewItem, index: Cell) -> None:
    theme = current_theme()
    area = QRectF(option.rect)
    heading = index.data(GROUP)
    if heading in GROUPS_SEEN:
        swatch = QRectF(area.x(), area.center().y() - SWATCH / 2, SWATCH, SWATCH)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor.fromRgbF(*GROUPS_SEEN[heading]))
        painter.drawRoundedRect(swatch, 2, 2)
        area.setLeft(swatch.right() + GRID // 2)
    if option.state & SELECTED:
        painter.fillRect(area, blend(theme.window, theme.accent, 0.32))
    elif option.state & HOVERED and not heading:
        painter.fillRect(area, QColor(theme.hover))
    painter.setPen(QColor(theme.muted if heading else theme.text))
    words = index.data(Qt.ItemDataRole.DisplayRole)
    room = area.adjusted(GRID // 2, 0, -GRID // 2, 0)
    text = painter.fontMetrics().elidedText(words, Qt.TextElideMode.ElideRight, int(room.width()))
    painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, text)


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
        self.setColumnCount(3)
        self.setHeaderHidden(True)
        self.setIndentation(2 * GRID)
        self.setUniformRowHeights(True)
        self.setMouseTracking(True)
        self.setAccessibleName("Muscles")
        self.setItemDelegate(MuscleCells(self))
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
        for column in (LEFT, RIGHT):
            self.header().setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
            self.header().resizeSection(column, CHIP + 4)
        self.show_muscles()
        self.itemSelectionChanged.connect(self._choose)
        self.itemCollapsed.connect(lambda item: self._note_fold(item, True))
        self.itemExpanded.connect(lambda item: self._note_fold(item, False))
        self.itemEntered.connect(lambda item, column: self.hovered.emit(frozenset(item.data(column, KEYS) or ())))
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
        """A click beside all names selects nothing."""
        if self.itemAt(event.position().toPoint()) is None:
            self._view.change(muscle="")
        super().mousePressEvent(event)

    def leaveEvent(self, event: object) -> None:
        """Nothing is under the pointer any more."""
        super().leaveEvent(event)  # type: ignore[arg-type]
        self.hovered.emit(frozenset())

    def _add_group(self, group: str, rows: dict[str, list[Muscle]]) -> None:
        heading = QTreeWidgetItem(self, [QUIET_TITLES.get(group, group.capitalize())])
        heading.setData(NAME, GROUP, group)
        heading.setFlags(Qt.ItemFlag.ItemIsEnabled)
        heading.setFirstColumnSpanned(True)
        for muscles in rows.values():
            row = QTreeWidgetItem(heading, [muscles[0].title])
            row.setData(NAME, KEYS, tuple(muscle.key for muscle in muscles))
            row.setToolTip(NAME, f"{muscles[0].title} ({muscles[0].name})")
            for muscle in muscles:
                column = RIGHT if muscle.side == "R" else LEFT
                row.setText(column, "•" if muscle.side == "M" else muscle.side)
                row.setData(column, KEYS, (muscle.key,))
                row.setData(column, SIDE, muscle.side)
                row.setToolTip(column, f"{muscle.title}, {SIDE_NAMES[muscle.side]}")
        heading.setExpanded(group not in self._folded)

    def _headings(self) -> Iterator[QTreeWidgetItem]:
        return (self.topLevelItem(k) for k in range(self.topLevelItemCount()))

    def _note_fold(self, item: QTreeWidgetItem, folded: bool) -> None:
        (self._folded.add if folded else self._folded.discard)(item.data(NAME, GROUP))

    def _choose(self) -> None:
        """Tell the view which muscles the selected cells stand for; the cell in hand names the one selected last."""
        keys: dict[str, None] = {}
        current = self.currentIndex()
        cells = sorted(self.selectedIndexes(), key=lambda cell: cell != current)
        for cell in cells:
            keys |= dict.fromkeys(cell.data(KEYS) or ())
        first, *others = keys or [""]
        self._view.change(muscle=first, others=frozenset(others))

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if (now.muscle, now.others) != (before.muscle, before.others):
            self._mark(now)

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
