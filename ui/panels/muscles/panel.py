"""The panel of the Muscles workspace."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QSize, Qt, Signal
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QMenu, QScrollArea, QSplitter, QToolButton, QVBoxLayout, QWidget

from app.actions.action import Action, perform
from app.actions.context import Context, state_signals
from app.tools.toolbox import ToolBox
from ui.panels.muscles.actions import MUSCLE_ACTIONS
from ui.panels.muscles.properties import MuscleProperties
from ui.panels.muscles.snap_box import SnapBox
from ui.panels.muscles.tree import MuscleTree
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ICON, ROW

WIDTH = 43 * GRID
HEIGHTS = 380, 420
FEWEST_ROWS = 5
"""Of the tree, however low the window is."""
"""Pixels for tree and numbers at first, of a window of the usual size."""

GLYPHS = {
    "muscle.duplicate": "content-duplicate",
    "muscle.mirror": "flip-horizontal",
    "muscle.link": "link-variant",
    "muscle.copy": "content-copy",
    "muscle.paste": "content-paste",
    "muscle.delete": "trash-can-outline",
}
KEYS = {"muscle.copy": "Ctrl+C", "muscle.paste": "Ctrl+V", "muscle.duplicate": "Ctrl+D", "muscle.all": "Ctrl+A"}
"""Keys that mean the muscles while the keyboard is in the tree."""


class MusclesPanel(QWidget):
    """The tree of muscles over the numbers of those that are selected.

    Signals
    -------
    muscles_hovered(object) : frozenset of the keys of the muscles under the pointer
    compared() : the models of the selected muscle are to be compared side by side
    """

    muscles_hovered = Signal(object)
    compared = Signal()

    def __init__(self, context: Context, toolbox: ToolBox) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setMinimumWidth(WIDTH)
        self._context = context
        self._toolbox = toolbox
        self.search = QLineEdit()
        self.search.setPlaceholderText("Search muscles")
        self.search.setAccessibleName("Search muscles")
        self.search.setClearButtonEnabled(True)
        self.search.addAction(icon("magnify"), QLineEdit.ActionPosition.LeadingPosition)
        self.tree = MuscleTree(context.document, context.view)
        self.properties = MuscleProperties(context)
        self.snap = SnapBox(toolbox)
        self.new = _button("plus", "New muscle: draw a fibre or a ring on the face, or let the jaw push the skin")
        self.new.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.new.setMenu(self._new_menu())
        self.buttons = {action.id: self._deed(action) for action in MUSCLE_ACTIONS if action.id in GLYPHS}
        self._lay_out()
        self._connect()
        self.refresh()

    def refresh(self, *_what: object) -> None:
        """Show what is possible now."""
        for action in MUSCLE_ACTIONS:
            button = self.buttons.get(action.id)
            if button is not None:
                button.setEnabled(action.enabled(self._context))
                button.setChecked(action.kind == "toggle" and action.checked(self._context))

    def _connect(self) -> None:
        self.search.textChanged.connect(self.tree.filter)
        self.tree.hovered.connect(self.muscles_hovered)
        self.tree.deleted.connect(lambda: self._perform("muscle.delete"))
        self.tree.renamed.connect(self.properties.focus_title)
        self.properties.compared.connect(lambda: self._perform("muscle.compare"))
        self.tree.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.tree.customContextMenuRequested.connect(self._ask)
        for action_id, keys in KEYS.items():
            key = QAction(self.tree)
            key.setShortcut(QKeySequence(keys))
            key.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
            key.triggered.connect(lambda _checked=False, action_id=action_id: self._perform(action_id))
            self.tree.addAction(key)
        self._toolbox.tool_changed.connect(self.refresh)
        for signal in state_signals(self._context):
            signal.connect(self.refresh)

    def _new_menu(self) -> QMenu:
        menu = QMenu(self)
        menu.addAction(icon("vector-curve"), "Fibre from bone to skin", lambda: self._toolbox.take("fibre"))
        menu.addAction(icon("ellipse-outline"), "Ring on the skin", lambda: self._toolbox.take("ring"))
        menu.addAction(icon("sine-wave"), "Fold along the skin", lambda: self._toolbox.take("fold"))
        menu.addAction(icon("arrow-down"), "Force of the jaw", lambda: self._perform("muscle.jaw"))
        menu.addSeparator()
        menu.addAction(icon("head-sync-outline"), "From another head…", lambda: self._perform("muscle.fit"))
        return menu

    def _perform(self, action_id: str) -> None:
        perform(next(action for action in MUSCLE_ACTIONS if action.id == action_id), self._context)

    def _ask(self, place: QPoint) -> None:
        """The menu of the tree."""
        menu = QMenu(self.tree)
        menu.addAction(icon("pencil-outline"), "Rename", self.properties.focus_title)
        group = 0
        for action in MUSCLE_ACTIONS:
            if action.group != group:
                menu.addSeparator()
                group = action.group
            entry = menu.addAction(action.title)
            entry.setEnabled(action.enabled(self._context))
            if action.kind == "toggle":
                entry.setCheckable(True)
                entry.setChecked(action.checked(self._context))
            entry.triggered.connect(lambda _checked=False, action_id=action.id: self._perform(action_id))
        menu.exec(self.tree.viewport().mapToGlobal(place))
        menu.deleteLater()

    def _deed(self, action: Action) -> QToolButton:
        button = _button(GLYPHS[action.id], f"{action.title}: {action.hint}")
        button.setCheckable(action.kind == "toggle")
        button.clicked.connect(lambda: self._perform(action.id))
        return button

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setContentsMargins(GRID, GRID, GRID, 0)
        head.setSpacing(GRID // 2)
        head.addWidget(self.search, 1)
        head.addWidget(self.new)
        line = QHBoxLayout()
        line.setContentsMargins(GRID, GRID // 2, GRID, 0)
        line.setSpacing(2)
        for action_id, button in self.buttons.items():
            if action_id == "muscle.delete":
                line.addStretch(1)
            line.addWidget(button)
        rule = QWidget()
        rule.setProperty("role", "line")
        upper = QWidget()
        above = QVBoxLayout(upper)
        above.setContentsMargins(0, 0, 0, 0)
        above.setSpacing(GRID)
        above.addLayout(head)
        above.addWidget(self.snap)
        self.tree.setMinimumHeight(FEWEST_ROWS * ROW)
        above.addWidget(self.tree, 1)
        above.addLayout(line)
        below = QScrollArea()
        below.setWidgetResizable(True)
        below.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        below.setWidget(self.properties)
        parts = QSplitter(Qt.Orientation.Vertical)
        parts.setChildrenCollapsible(False)
        parts.addWidget(upper)
        parts.addWidget(below)
        parts.setStretchFactor(0, 1)
        parts.setSizes(list(HEIGHTS))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(parts)


def _button(glyph: str, text: str) -> QToolButton:
    button = QToolButton()
    button.setIcon(icon(glyph))
    button.setIconSize(QSize(ICON, ICON))
    button.setToolTip(text)
    button.setAccessibleName(text.partition(":")[0])
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button
