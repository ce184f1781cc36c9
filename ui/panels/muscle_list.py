"""The muscles of a face: choose the one whose influence is shown."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSize, Qt
from PySide6.QtGui import QStandardItem, QStandardItemModel
from PySide6.QtWidgets import (
    QLineEdit,
    QListView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from app.document import Document
from app.view import View
from app.view_state import ViewState
from facemodel.muscles import Muscle
from facemodel.project import Project
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW

KEY = Qt.ItemDataRole.UserRole + 1
SIDES = {"L": "left", "R": "right", "M": ""}


def muscle_label(muscle: Muscle) -> str:
    """Title and side."""
    side = SIDES[muscle.side]
    return f"{muscle.title}, {side}" if side else muscle.title


class NarrowRow(QStyledItemDelegate):
    """A row as wide as the list, so that a long name is shortened and the list never scrolls sideways."""

    def sizeHint(self, _option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex) -> QSize:
        """One row of any width."""
        return QSize(0, ROW)


class MuscleList(QWidget):
    """Binds the selected muscle of a view to a list, both ways."""

    def __init__(self, document: Document, view: View) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setMinimumWidth(36 * GRID)
        self._view = view
        self.search = QLineEdit()
        self.search.setPlaceholderText("Search muscles")
        self.search.setAccessibleName("Search muscles")
        self.search.setClearButtonEnabled(True)
        self.search.addAction(icon("magnify"), QLineEdit.ActionPosition.LeadingPosition)
        self._model = QStandardItemModel(self)
        self.list = QListView()
        self.list.setModel(self._model)
        self.list.setItemDelegate(NarrowRow(self.list))
        self.list.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setEditTriggers(QListView.EditTrigger.NoEditTriggers)
        self.list.setAccessibleName("Muscles")
        self.list.selectionModel().currentChanged.connect(self._choose)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, GRID, GRID, GRID)
        layout.setSpacing(GRID)
        layout.addWidget(self.search)
        layout.addWidget(self.list)
        self.search.textChanged.connect(self._filter)
        document.project_changed.connect(self.show_project)
        view.changed.connect(self._show_view)
        self.show_project(document.project)

    def show_project(self, project: Project) -> None:
        """List the muscles of a project."""
        self.list.selectionModel().blockSignals(True)
        self._model.clear()
        for muscle in project.muscles:
            item = QStandardItem(muscle_label(muscle))
            item.setData(muscle.key, KEY)
            self._model.appendRow(item)
        self.list.selectionModel().blockSignals(False)
        self._filter(self.search.text())
        self._mark(self._view.state.muscle)

    def _choose(self) -> None:
        key = self.list.currentIndex().data(KEY)
        if key:
            self._view.change(muscle=key, influence=True)

    def _show_view(self, now: ViewState, before: ViewState) -> None:
        if now.muscle != before.muscle:
            self._mark(now.muscle)

    def _mark(self, key: str) -> None:
        for row in range(self._model.rowCount()):
            index = self._model.index(row, 0)
            if index.data(KEY) == key:
                self.list.setCurrentIndex(index)
                return
        self.list.clearSelection()

    def _filter(self, query: str) -> None:
        words = query.lower().split()
        for row in range(self._model.rowCount()):
            text = self._model.item(row).text().lower()
            self.list.setRowHidden(row, not all(word in text for word in words))
