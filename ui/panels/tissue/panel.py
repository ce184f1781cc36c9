"""The panel of the tissue workspace: layers, brush, region, what is drawn."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QScrollArea, QVBoxLayout, QWidget

from app.actions.context import Context
from app.tools.tool import Bench
from ui.panels.tissue.brush_box import BrushBox
from ui.panels.tissue.layer_list import LayerList
from ui.panels.tissue.look_box import LookBox
from ui.panels.tissue.region_box import RegionBox
from ui.panels.tissue.solve_note import SolveNote
from ui.panels.tissue.texture_box import TextureBox
from ui.theme.metrics import GRID
from ui.widgets.collapsible import Collapsible


class TissuePanel(QWidget):
    """Everything that painting needs beside the face.

    Parameters
    ----------
    context : document, view, solving and the window's services
    bench : brush and regions
    """

    def __init__(self, context: Context, bench: Bench) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setMinimumWidth(36 * GRID)
        self.layers = LayerList(bench.brush, context.view)
        self.brush = BrushBox(bench.brush)
        self.region = RegionBox(bench, context.host.show_message)
        self.look = LookBox(context.document, context.view)
        self.texture = TextureBox(context, bench)
        self.note = SolveNote(context.document, context.solving)
        inside = QWidget()
        inside.setProperty("role", "panel")
        rows = QVBoxLayout(inside)
        rows.setContentsMargins(0, 0, 0, GRID)
        rows.setSpacing(0)
        for title, widget in self._groups():
            rows.addWidget(_group(title, widget))
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
        return (
            ("Layer", self.layers),
            ("Brush", self.brush),
            ("Region", self.region),
            ("Show", self.look),
            ("Picture", self.texture),
        )


def _group(title: str, widget: QWidget) -> Collapsible:
    group = Collapsible(title)
    group.rows.addWidget(widget)
    return group
