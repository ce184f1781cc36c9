"""The panel of the skull workspace: one group after the other, each a box of its own."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QScrollArea, QVBoxLayout, QWidget

from app.actions.context import Context
from app.tools.toolbox import ToolBox
from ui.panels.skull.show_box import ShowBox
from ui.panels.tissue.solve_note import SolveNote
from ui.theme.metrics import GRID
from ui.widgets.collapsible import Collapsible


class SkullPanel(QWidget):
    """Everything that placing bone and jaw needs beside the face.

    Parameters
    ----------
    context : document, view, solving and the window's services
    toolbox : the tools, with what lies before them
    """

    def __init__(self, context: Context, toolbox: ToolBox) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setMinimumWidth(36 * GRID)
        self.show_box = ShowBox(context.view)
        self.note = SolveNote(context.document, context.solving)
        inside = QWidget()
        inside.setProperty("role", "panel")
        rows = QVBoxLayout(inside)
        rows.setContentsMargins(0, 0, 0, GRID)
        rows.setSpacing(0)
        for title, widget in self._groups():
            group = Collapsible(title)
            group.rows.addWidget(widget)
            rows.addWidget(group)
        rows.addStretch(1)
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(inside)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, GRID)
        layout.setSpacing(GRID)
        layout.addWidget(scroll, 1)
        self.note.setContentsMargins(GRID + 4, 0, GRID, 0)
        layout.addWidget(self.note)

    def _groups(self) -> tuple[tuple[str, QWidget], ...]:
        return (("Show", self.show_box),)
