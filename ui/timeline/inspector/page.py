"""A page of the inspector: a heading, fields and buttons one below the other."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QToolButton, QVBoxLayout, QWidget

from app.timeline.timeline import Timeline
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW
from ui.timeline.inspector.field import FieldBar
from ui.widgets.plain_label import PlainLabel


class Page(QWidget):
    """Fields about one kind of thing.

    Parameters
    ----------
    timeline : what they are about
    title : above them

    Attributes
    ----------
    over : whether it has done what it was opened for
    """

    over = False

    def __init__(self, timeline: Timeline, title: str) -> None:
        super().__init__()
        self.timeline = timeline
        self.fields: list[FieldBar] = []
        self._rows = QVBoxLayout(self)
        self._rows.setContentsMargins(GRID, GRID, GRID, GRID)
        self._rows.setSpacing(2)
        self.heading = PlainLabel(title.upper())
        self.heading.setProperty("role", "heading")
        self._rows.addWidget(self.heading)
        self._rows.addSpacing(4)
        self._rows.addStretch(1)

    def refresh(self) -> None:
        """Say what is so now."""
        for field in self.fields:
            field.refresh()

    def close_page(self) -> None:
        """The page is put away."""

    def add(self, *widgets: QWidget) -> None:
        """Put widgets below those that there are, side by side."""
        row = QHBoxLayout()
        row.setSpacing(2)
        for widget in widgets:
            row.addWidget(widget)
            if isinstance(widget, FieldBar):
                self.fields.append(widget)
        self._rows.insertLayout(self._rows.count() - 1, row)

    def gap(self) -> None:
        """Some air."""
        self._rows.insertSpacing(self._rows.count() - 1, GRID)

    def caption(self, text: str) -> QLabel:
        """A quiet line of text."""
        label = PlainLabel(text)
        label.setProperty("role", "muted")
        label.setWordWrap(True)
        self._rows.insertWidget(self._rows.count() - 1, label)
        return label


def choice_button(glyph: str, text: str, act: Callable[[], None], checked: bool | None = None) -> QToolButton:
    """A small button with a glyph; one that can be on where it is said whether it is."""
    button = QToolButton()
    button.setIcon(icon(glyph))
    button.setToolTip(text)
    button.setAccessibleName(text)
    button.setProperty("role", "choice")
    button.setFixedHeight(ROW)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.setSizePolicy(button.sizePolicy().Policy.Expanding, button.sizePolicy().Policy.Fixed)
    if checked is not None:
        button.setCheckable(True)
        button.setChecked(checked)
    button.clicked.connect(lambda *_on: act())
    return button


def push_button(text: str, act: Callable[[], None], tip: str = "") -> QPushButton:
    """A button with words."""
    button = QPushButton(text)
    button.setToolTip(tip)
    button.setAutoDefault(False)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.clicked.connect(lambda *_on: act())
    return button
