"""The named expressions: keep the sliders under a name, show, edit, rename, order, copy and delete them."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QListWidgetItem, QVBoxLayout, QWidget

from app.actions.context import Context
from app.authoring.emotions import free_name, moved, renamed, with_expression, without
from app.expression_clipboard import expressions_of, expressions_text, told, weights_text, with_pasted
from app.expression_text import parse_expression
from facemodel.actions import Emotion, Expression, expand
from facemodel.errors import RisoriusError
from ui.panels.actions.expression_rows import NAME, PLACED, PORTRAIT, RECIPE, SHOWN, ExpressionRows
from ui.panels.actions.tool_button import tool_button
from ui.panels.emotion_match import shown_strength
from ui.panels.telling import step
from ui.portraits import Portraits
from ui.theme.metrics import GRID
from ui.widgets.standing_line import StandingLine


class ExpressionList(QWidget):
    """Binds the named expressions of a document to a list, both ways."""

    def __init__(self, context: Context, portraits: Portraits) -> None:
        super().__init__()
        self._context, self._portraits = context, portraits
        self._full: dict[str, Expression] = {}
        self.names = ExpressionRows()
        self.keep = tool_button("plus", "Keep the sliders as a new expression", self.save)
        self.renew = tool_button("content-save-outline", "Make the expression what the sliders are now", self.update_it)
        self.show_it = tool_button("play-outline", "Show the expression (double click)", self.load)
        self.up = tool_button("arrow-up", "Further to the front (Alt+Up, or drag the row)", lambda: self._step_by(-1))
        self.down = tool_button("arrow-down", "Further to the back (Alt+Down)", lambda: self._step_by(1))
        self.copy_it = tool_button("content-copy", "Copy the expression as text (Ctrl+C)", self.copy)
        self.paste_it = tool_button("content-paste", "Paste expressions from text (Ctrl+V)", self.paste)
        self.take_away = tool_button("trash-can-outline", "Delete the expression", self.delete)
        self.text = StandingLine("Weights of the expression")
        self.text.setPlaceholderText("Weights, such as 12=0.8 1L=50%")
        self.text.setToolTip("What the expression is made of; Enter changes it")
        self._lay_out()
        self._connect()
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
        project = self._context.document.project
        self._full = {each.name: expand(each.weights, project.units) for each in project.emotions}
        self.names.blockSignals(True)
        self.names.clear()
        for emotion in project.emotions:
            item = QListWidgetItem(emotion.title, self.names)
            item.setData(NAME, emotion.name)
            item.setData(RECIPE, recipe(emotion))
            item.setData(PORTRAIT, self._portraits.picture(emotion.name))
            item.setData(PLACED, emotion.place is not None)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)
        self.names.setCurrentRow(min(place, self.names.count() - 1))
        if kept is not None:
            self.choose(kept.name)
        self.names.blockSignals(False)
        self._show_possible()

    def choose(self, name: str) -> None:
        """Choose an expression by its name."""
        item = self._item(name)
        if item is not None:
            self.names.setCurrentItem(item)

    def save(self) -> None:
        """Keep the sliders as a new expression, whose name can be typed at once."""
        document = self._context.document
        name = free_name(document.project)
        if step(self._context, lambda project: with_expression(project, name, document.shown), "Keep expression"):
            self.choose(name)
            self.names.editItem(self.names.currentItem())

    def update_it(self) -> None:
        """Make the chosen expression what the sliders are now."""
        emotion, document = self.chosen, self._context.document
        if emotion is not None:
            step(self._context, lambda p: with_expression(p, emotion.name, document.shown), f"Change {emotion.title}")

    def load(self) -> None:
        """Show the chosen expression."""
        if self.chosen is not None:
            self._context.document.apply_emotion(self.chosen.name)

    def copy(self) -> None:
        """Put the chosen expression into the clipboard, as text."""
        emotion = self.chosen
        if emotion is not None:
            text = expressions_text([emotion], self._context.document.project.units)
            self._context.host.set_clipboard(text)
            self._context.host.show_message(f"Copied {text}")

    def paste(self) -> None:
        """Take the expressions in the clipboard into the list."""
        document, host = self._context.document, self._context.host
        try:
            read = expressions_of(host.clipboard(), document.project.units)
            project, names = with_pasted(document.project, read)
            document.edit(project, "Paste expression" if len(names) == 1 else f"Paste {len(names)} expressions")
        except RisoriusError as error:
            host.show_message(str(error))
            return
        self.choose(names[-1])
        host.show_message(told(read, names))

    def delete(self) -> None:
        """Delete the chosen expression."""
        emotion = self.chosen
        if emotion is not None:
            step(self._context, lambda project: without(project, [emotion.name]), f"Delete {emotion.title}")

    def _item(self, name: str) -> QListWidgetItem | None:
        rows = (self.names.item(row) for row in range(self.names.count()))
        return next((item for item in rows if item.data(NAME) == name), None)

    def _step_by(self, by: int) -> None:
        emotion, row = self.chosen, self.names.currentRow()
        if emotion is not None and 0 <= row + by < self.names.count():
            step(self._context, lambda project: moved(project, emotion.name, row + by), f"Move {emotion.title}")

    def _put(self, name: object, place: object) -> None:
        """Put a row that was dragged in front of the one at a place."""
        names = list(self._full)
        at = names.index(str(name))
        to = int(place) - (int(place) > at)  # type: ignore[call-overload]
        if to != at:
            step(self._context, lambda project: moved(project, str(name), to), f"Move {str(name).capitalize()}")
        self.choose(str(name))

    def _rename(self, item: QListWidgetItem) -> None:
        old, new = item.data(NAME), item.text().strip()
        if new.lower() == old.lower() or not step(self._context, lambda p: renamed(p, old, new), f"Rename {old}"):
            self.show_emotions()
            return
        self.choose(new)

    def _retype(self, typed: str) -> None:
        """Make the chosen expression what was typed."""
        emotion = self.chosen
        if emotion is None:
            return
        label = f"Change {emotion.title}"
        if step(self._context, lambda p: with_expression(p, emotion.name, parse_expression(typed, p.units)), label):
            self.text.accept_typed(self._weights())
        else:
            self.text.refuse()

    def _show_portrait(self, name: str) -> None:
        item = self._item(name)
        if item is not None:
            self.names.blockSignals(True)
            item.setData(PORTRAIT, self._portraits.picture(name))
            self.names.blockSignals(False)
            self.names.viewport().update()

    def _show_possible(self, *_what: object) -> None:
        shown = self._context.document.shown
        row, count = self.names.currentRow(), self.names.count()
        self.keep.setEnabled(any(shown.values()))
        self.renew.setEnabled(any(shown.values()) and row >= 0)
        self.up.setEnabled(row > 0)
        self.down.setEnabled(0 <= row < count - 1)
        for part in (self.show_it, self.take_away, self.copy_it, self.text):
            part.setEnabled(row >= 0)
        self.text.stand(self._weights())
        self._mark_shown(shown)

    def _weights(self) -> str:
        """What the chosen expression is made of, as text."""
        emotion = self.chosen
        return weights_text(emotion, self._context.document.project.units) if emotion else ""

    def _mark_shown(self, shown: Expression) -> None:
        self.names.blockSignals(True)
        for row in range(self.names.count()):
            item = self.names.item(row)
            item.setData(SHOWN, shown_strength(shown, self._full.get(item.data(NAME), {})) > 0)
        self.names.blockSignals(False)
        self.names.viewport().update()

    def _connect(self) -> None:
        document, names = self._context.document, self.names
        for signal in (document.project_changed, document.emotions_changed, document.units_changed):
            signal.connect(self.show_emotions)
        document.expression_changed.connect(self._show_possible)
        self._portraits.taken.connect(self._show_portrait)
        names.itemDoubleClicked.connect(lambda _item: self.load())
        names.itemChanged.connect(self._rename)
        names.currentRowChanged.connect(self._show_possible)
        names.shown_now.connect(self.load)
        names.deleted.connect(self.delete)
        names.copied.connect(self.copy)
        names.pasted.connect(self.paste)
        names.stepped.connect(self._step_by)
        names.dropped.connect(self._put)
        self.text.entered.connect(self._retype)

    def _lay_out(self) -> None:
        line = QHBoxLayout()
        line.setSpacing(2)
        for button in (self.keep, self.renew, self.show_it, self.up, self.down, self.copy_it, self.paste_it):
            line.addWidget(button)
        line.addStretch(1)
        line.addWidget(self.take_away)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, GRID, GRID, GRID // 2)
        layout.setSpacing(GRID // 2)
        layout.addWidget(self.names, 1)
        layout.addLayout(line)
        layout.addWidget(self.text)


def recipe(emotion: Emotion) -> str:
    """What an expression is made of, at a glance: ``1 + 4 0.6 + 15``."""
    parts = (name if weight == 1 else f"{name} {weight:.2g}" for name, weight in emotion.weights.items() if weight)
    return " + ".join(parts) or "at rest"
