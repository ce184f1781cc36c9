"""The panel of the Skull workspace: one group after the other, or the page on which another skull is fitted."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QScrollArea, QStackedWidget, QVBoxLayout, QWidget

from app.actions.context import Context
from app.tools.toolbox import ToolBox
from ui.panels.skull.axis_box import AxisBox
from ui.panels.skull.bone_box import BoneBox
from ui.panels.skull.depth_box import DepthBox
from ui.panels.skull.faults_box import FaultsBox
from ui.panels.skull.fit_page import FitPage
from ui.panels.skull.jaw_box import JawBox
from ui.panels.skull.place_box import PlaceBox
from ui.panels.skull.show_box import ShowBox
from ui.panels.tissue.solve_note import SolveNote
from ui.theme.metrics import GRID
from ui.widgets.collapsible import Collapsible

WIDTH = 45 * GRID
"""Three numbers with their units beside each other, and their name."""


class SkullPanel(QWidget):
    """Everything that placing bone and jaw needs beside the face.

    Parameters
    ----------
    context : document, view, solving and the window's services
    toolbox : the tools, with what lies before them

    Signals
    -------
    place_asked(object) : the places (k, 3) of the skin that are to be brought near
    """

    place_asked = Signal(object)

    def __init__(self, context: Context, toolbox: ToolBox) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setMinimumWidth(WIDTH)
        bench, self._toolbox = toolbox.bench, toolbox
        self.bone = BoneBox(context, bench)
        self.place = PlaceBox(context, bench)
        self.faults = FaultsBox(bench.watch)
        self.jaw = JawBox(context, toolbox)
        self.axis = AxisBox(context, bench)
        self.depth = DepthBox(bench.watch, context.view, bench.sight)
        self.show_box = ShowBox(context.view)
        self.fit = FitPage(context, bench)
        self.note = SolveNote(context.document, context.solving)
        self.pages = QStackedWidget()
        self.pages.addWidget(self._groups_in_a_column())
        self.pages.addWidget(self.fit)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, GRID)
        layout.setSpacing(GRID)
        layout.addWidget(self.pages, 1)
        self.note.setContentsMargins(GRID + 4, 0, GRID, 0)
        layout.addWidget(self.note)
        for box in (self.faults, self.depth):
            box.place_asked.connect(self.place_asked)
        self._fitting = bench.fitting
        self._fitting.changed.connect(self._turn_page)
        context.document.project_changed.connect(lambda _now: self._fitting.end())
        self._turn_page()

    def _turn_page(self) -> None:
        """The page of the fitting while there is one, with its tool in hand."""
        on = self._fitting.on
        if on == (self.pages.currentWidget() is self.fit):
            return
        self.pages.setCurrentWidget(self.fit if on else self.pages.widget(0))
        self._toolbox.take("skull-landmark" if on else "move-skull")

    def _groups_in_a_column(self) -> QWidget:
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
        return scroll

    def _groups(self) -> tuple[tuple[str, QWidget], ...]:
        return (
            ("Bone", self.bone),
            ("Place", self.place),
            ("Check", self.faults),
            ("Jaw", self.jaw),
            ("Jaw axis", self.axis),
            ("Depth", self.depth),
            ("Show", self.show_box),
        )
