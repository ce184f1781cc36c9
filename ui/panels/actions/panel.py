"""The panel of the Actions workspace."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLineEdit,
    QScrollArea,
    QSplitter,
    QTabWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.actions.action import Action, perform
from app.actions.context import Context, state_signals
from app.solo import SCULPT
from app.superposition_check import SuperpositionCheck
from app.tools.tool import Tool
from app.tools.toolbox import ToolBox
from facemodel.actions import ActionUnit
from ui.panels.actions.blend_box import BlendBox
from ui.panels.actions.expression_list import ExpressionList
from ui.panels.actions.sculpt_brush import SculptBrushBox
from ui.panels.actions.sculpt_deeds import SCULPT_ACTIONS
from ui.panels.actions.sculpt_layer import SculptLayerBox
from ui.panels.actions.superposition_box import SuperpositionBox
from ui.panels.actions.tool_button import tool_button
from ui.panels.actions.unit_deeds import UNIT_ACTIONS, place
from ui.panels.actions.unit_editor import UnitEditor
from ui.panels.actions.unit_list import UnitList
from ui.portraits import Portraits
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW
from ui.widgets.collapsible import Collapsible

WIDTH = 43 * GRID
HEIGHTS = 330, 420
FEWEST_ROWS = 5
"""Of the list, however low the window is."""
"""Pixels for list and numbers at first, of a window of the usual size."""

UNITS, EXPRESSIONS = 0, 1
"""Places of the tabs."""

HEADING = 4 * GRID
"""Room for the heading over what is brought into view."""

GLYPHS = {
    "unit.duplicate": "content-duplicate",
    "unit.split": "arrow-split-vertical",
    "unit.mirror": "flip-horizontal",
    "unit.merge": "merge",
    "unit.solo": "account-eye-outline",
    "unit.fill": "table-arrow-down",
    "unit.delete": "trash-can-outline",
}


class ActionsPanel(QWidget):
    """Action units with what they are made of, and the expressions made of them.

    Signals
    -------
    muscles_hovered(object) : frozenset of the keys of the muscles under the pointer
    """

    muscles_hovered = Signal(object)

    def __init__(self, context: Context, toolbox: ToolBox, check: SuperpositionCheck, portraits: Portraits) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setMinimumWidth(WIDTH)
        self._context, self._toolbox = context, toolbox
        self._actions = {action.id: action for action in (*UNIT_ACTIONS, *SCULPT_ACTIONS)}
        self.search = QLineEdit()
        self.search.setPlaceholderText("Search action units")
        self.search.setAccessibleName("Search action units")
        self.search.setClearButtonEnabled(True)
        self.search.addAction(icon("magnify"), QLineEdit.ActionPosition.LeadingPosition)
        self.units = UnitList(context.document, context.view)
        self.brush = SculptBrushBox(toolbox)
        self.layer = SculptLayerBox(context)
        self.editor = UnitEditor(context, (self.brush, self.layer))
        self.expressions = ExpressionList(context, portraits)
        self.blend = BlendBox(context, portraits)
        self.check = SuperpositionBox(context, check)
        self.new = self._deed(self._actions["unit.new"], "plus")
        self.buttons = {key: self._deed(self._actions[key], glyph) for key, glyph in GLYPHS.items()}
        self.tabs = QTabWidget()
        self._lay_out()
        self._connect()
        self.refresh()

    def refresh(self, *_what: object) -> None:
        """Show what is possible now."""
        for key, button in self.buttons.items():
            action = self._actions[key]
            button.setEnabled(action.enabled(self._context))
            button.setChecked(action.kind == "toggle" and action.checked(self._context))

    def _connect(self) -> None:
        self.search.textChanged.connect(self.units.filter)
        self.units.hovered.connect(self._point_at)
        self.editor.hovered.connect(self.muscles_hovered)
        self.units.deleted.connect(lambda: perform(self._actions["unit.delete"], self._context))
        self.units.renamed.connect(self.editor.head.focus_name)
        self.units.stepped.connect(self._step)
        self.units.dropped.connect(lambda number, where: place(self._context, number, *where))
        rows = self.expressions.names
        rows.carried.connect(self.blend.carry)
        rows.carried_off.connect(self.blend.let_fall)
        rows.currentItemChanged.connect(self._pick)
        self.blend.chosen.connect(self.expressions.choose)
        self.tabs.currentChanged.connect(self._turn_to)
        self._toolbox.tool_changed.connect(self._follow_tool)
        for signal in state_signals(self._context):
            signal.connect(self.refresh)

    def _pick(self, *_rows: object) -> None:
        emotion = self.expressions.chosen
        self.blend.pick(emotion.name if emotion is not None else "")

    def _turn_to(self, tab: int) -> None:
        """Work on expressions is done without the brush that sculpts one unit."""
        mixing = tab == EXPRESSIONS
        self._context.view.change(mixing=mixing)
        if mixing and self._toolbox.tool.id == SCULPT:
            self._toolbox.take("select")

    def _follow_tool(self, tool: Tool) -> None:
        """Show what the brush works on."""
        if tool.id == SCULPT:
            self.tabs.setCurrentIndex(UNITS)
            top = self.brush.mapTo(self.editor, QPoint(0, 0)).y()
            self._area.verticalScrollBar().setValue(top - HEADING)

    def _step(self, by: int) -> None:
        """List the unit in hand further up or down."""
        perform(self._actions["unit.up" if by < 0 else "unit.down"], self._context)

    def _point_at(self, unit: ActionUnit | None) -> None:
        """Name the muscles of the unit under the pointer."""
        muscles = self._context.document.project.muscles
        keys = frozenset(muscle.key for muscle in muscles if unit is not None and muscle.name in unit.muscles)
        self.muscles_hovered.emit(keys)

    def _deed(self, action: Action, glyph: str) -> QToolButton:
        button = tool_button(glyph, f"{action.title}: {action.hint}", lambda: perform(action, self._context))
        button.setCheckable(action.kind == "toggle")
        return button

    def _lay_out(self) -> None:
        parts = QSplitter(Qt.Orientation.Vertical)
        parts.setChildrenCollapsible(False)
        parts.addWidget(self._upper())
        self._area = _scrolled(self.editor)
        parts.addWidget(self._area)
        parts.setStretchFactor(0, 1)
        parts.setSizes(list(HEIGHTS))
        expressions = QWidget()
        below = QVBoxLayout(expressions)
        below.setContentsMargins(0, 0, 0, 0)
        below.setSpacing(0)
        below.addWidget(self.expressions, 1)
        for title, part in (("Blend", self.blend), ("Superposition", self.check)):
            group = Collapsible(title)
            group.rows.setContentsMargins(0, 0, 0, 0)
            group.rows.addWidget(part)
            below.addWidget(group)
        self.tabs.setDocumentMode(True)
        self.tabs.tabBar().setObjectName("parts")
        self.tabs.tabBar().setDrawBase(False)
        self.tabs.addTab(parts, "Action units")
        self.tabs.addTab(expressions, "Expressions")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.tabs)

    def _upper(self) -> QWidget:
        head = QHBoxLayout()
        head.setContentsMargins(GRID, GRID, GRID, 0)
        head.setSpacing(GRID // 2)
        head.addWidget(self.search, 1)
        head.addWidget(self.new)
        line = QHBoxLayout()
        line.setContentsMargins(GRID, 0, GRID, 0)
        line.setSpacing(2)
        for key, button in self.buttons.items():
            if key == "unit.delete":
                line.addStretch(1)
            line.addWidget(button)
        upper = QWidget()
        layout = QVBoxLayout(upper)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GRID // 2)
        layout.addLayout(head)
        self.units.setMinimumHeight(FEWEST_ROWS * ROW)
        layout.addWidget(self.units, 1)
        layout.addLayout(line)
        return upper


def _scrolled(widget: QWidget) -> QScrollArea:
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setWidget(widget)
    return area
