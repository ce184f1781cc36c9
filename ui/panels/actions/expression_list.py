"""The named expressions: keep the sliders under a name, show, rename, order and delete them."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractItemView, QHBoxLayout, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from app.actions.context import Context
from app.authoring.emotions import free_name, moved, renamed, with_expression, without
from facemodel.actions import Emotion
from facemodel.errors import RisoriusError
from facemodel.project import Project
from ui.panels.actions.tool_button import tool_button
from ui.theme.metrics import GRID
from ui.widgets.narrow_row import NarrowRow

NAME = Qt.ItemDataRole.UserRole + 1


class Names(QListWidget):
    """The list itself: Delete and Enter mean the expression, a slow click or F2 edits its name."""

    def __init__(self, delete: Callable[[], None], show: Callable[[], None]) -> None:
        super().__init__()
        self._delete, self._show = delete, show
        self.setAccessibleName("Expressions")
        self.setItemDelegate(NarrowRow(self))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        triggers = QAbstractItemView.EditTrigger
        self.setEditTriggers(triggers.EditKeyPressed | triggers.SelectedClicked)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Delete takes it away, Enter shows it; while a name is edited all keys are its own."""
        editing = self.state() == QAbstractItemView.State.EditingState
        if not editing and event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self._delete()
        elif not editing and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._show()
        else:
            super().keyPressEvent(event)


class ExpressionList(QWidget):
    """Binds the named expressions of a document to a list, both ways."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self.names = Names(self.delete, self.load)
        self.keep = tool_button("plus", "Keep the sliders as a new expression", self.save)
        self.renew = tool_button("content-save-outline", "Make the expression what the sliders are now", self.update_it)
        self.show_it = tool_button("play-outline", "Show the expression (double click)", self.load)
        self.up = tool_button("arrow-up", "Further to the front", lambda: self._move(-1))
        self.down = tool_button("arrow-down", "Further to the back", lambda: self._move(1))
        self.take_away = tool_button("trash-can-outline", "Delete the expression", self.delete)
        line = QHBoxLayout()
        line.setSpacing(2)
        for button in (self.keep, self.renew, self.show_it, self.up, self.down):
            line.addWidget(button)
        line.addStretch(1)
        line.addWidget(self.take_away)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, GRID, GRID, GRID)
        layout.setSpacing(GRID // 2)
        layout.addWidget(self.names, 1)
        layout.addLayout(line)
        document = context.document
        document.project_changed.connect(self.show_emotions)
        document.emotions_changed.connect(self.show_emotions)
        document.units_changed.connect(self.show_emotions)
        document.expression_changed.connect(self._show_possible)
        self.names.itemDoubleClicked.connect(lambda _item: self.load())
        self.names.itemChanged.connect(self._rename)
        self.names.currentRowChanged.connect(self._show_possible)
        self.show_emotions()

    @property
    def chosen(self) -> Emotion | None:
        """The expression that is chosen."""
        item = self.names.currentItem()
        name = item.data(NAME) if item is not None else None
        return next((each for each in self._context.document.project.emotions if each.name == name), None)

    def show_emotions(self, *_what: object) -> None:
        """List the expressions anew; the chosen one stays so."""
        kept, place = self.chosen, self.names.currentRow()
        self.names.blockSignals(True)
        self.names.clear()
        for emotion in self._context.document.project.emotions:
            item = QListWidgetItem(emotion.title, self.names)
            item.setData(NAME, emotion.name)
            item.setToolTip(" + ".join(f"{name} {weight:g}" for name, weight in emotion.weights.items()))
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)
        self.names.setCurrentRow(min(place, self.names.count() - 1))
        if kept is not None:
            self.choose(kept.name)
        self.names.blockSignals(False)
        self._show_possible()

    def choose(self, name: str) -> None:
        """Choose an expression by its name."""
        for row in range(self.names.count()):
            if self.names.item(row).data(NAME) == name:
                self.names.setCurrentRow(row)

    def save(self) -> None:
        """Keep the sliders as a new expression, whose name can be typed at once."""
        document = self._context.document
        name = free_name(document.project)
        if self._step(lambda project: with_expression(project, name, document.shown), "Keep expression"):
            self.choose(name)
            self.names.editItem(self.names.currentItem())

    def update_it(self) -> None:
        """Make the chosen expression what the sliders are now."""
        emotion, document = self.chosen, self._context.document
        if emotion is not None:
            self._step(lambda p: with_expression(p, emotion.name, document.shown), f"Change {emotion.title}")

    def load(self) -> None:
        """Show the chosen expression."""
        if self.chosen is not None:
            self._context.document.apply_emotion(self.chosen.name)

    def delete(self) -> None:
        """Delete the chosen expression."""
        emotion = self.chosen
        if emotion is not None:
            self._step(lambda project: without(project, [emotion.name]), f"Delete {emotion.title}")

    def _move(self, by: int) -> None:
        emotion, row = self.chosen, self.names.currentRow()
        if emotion is not None:
            self._step(lambda project: moved(project, emotion.name, row + by), f"Move {emotion.title}")

    def _rename(self, item: QListWidgetItem) -> None:
        old, new = item.data(NAME), item.text().strip()
        if new.lower() == old.lower() or not self._step(lambda p: renamed(p, old, new), f"Rename {old}"):
            self.show_emotions()
            return
        self.choose(new)

    def _step(self, change: Callable[[Project], Project], label: str) -> bool:
        document = self._context.document
        try:
            document.edit(change(document.project), label)
        except RisoriusError as error:
            self._context.host.show_message(str(error))
            return False
        return True

    def _show_possible(self, *_what: object) -> None:
        moves = any(self._context.document.shown.values())
        row, count = self.names.currentRow(), self.names.count()
        self.keep.setEnabled(moves)
        self.renew.setEnabled(moves and row >= 0)
        self.up.setEnabled(row > 0)
        self.down.setEnabled(0 <= row < count - 1)
        for button in (self.show_it, self.take_away):
            button.setEnabled(row >= 0)
