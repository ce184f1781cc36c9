"""How the window is arranged: its docks, where they stand, which groups are folded, and what is remembered of it."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, QSize, Qt
from PySide6.QtGui import QAction, QGuiApplication
from PySide6.QtWidgets import QMainWindow

from app.actions.context import Context
from ui.panels.console_panel import ConsolePanel
from ui.panels.expression_panel import ExpressionPanel
from ui.panels.face_information import FaceInformation
from ui.timeline.desk import TimelineDesk
from ui.window.dock import Dock
from ui.window.layout import Layout, layout_from, layout_text
from ui.workspaces.registry import WORKSPACES
from ui.workspaces.switching import WorkspacePanels

LEAST = QSize(1024, 600)
USUAL = QSize(1440, 900)
SHARE_OF_SCREEN = 0.94


class Arrangement:
    """Places the docks of a window around its middle, puts them back, and remembers where they were.

    Parameters
    ----------
    window : whose docks they are
    context : what they show, and where it is remembered how they stood
    panels, timeline : what goes into the docks

    Attributes
    ----------
    docks : by name
    """

    def __init__(self, window: QMainWindow, context: Context, panels: WorkspacePanels, timeline: TimelineDesk) -> None:
        self._window, self._context, self._panels, self._timeline = window, context, panels, timeline
        self._expression: ExpressionPanel = panels.panel("expression")
        self._expression.folds_changed.connect(self._note_folds)
        self._folded: frozenset[str] = frozenset()
        self.docks: dict[str, Dock] = {
            "timeline": timeline.dock,
            "workspace": Dock("workspace", "Expression", panels),
            "information": Dock("information", "Face information", FaceInformation(context.document)),
            "console": Dock("console", "Console", ConsolePanel(context.document, context.view)),
        }
        self._place()
        self._usual = window.saveState()

    @property
    def switches(self) -> list[QAction]:
        """What shows and hides each dock."""
        return [dock.toggleViewAction() for dock in self.docks.values()]

    def show(self, name: str) -> None:
        """Bring a dock to the front."""
        self.docks[name].show()
        self.docks[name].raise_()

    def open_console(self) -> None:
        """Bring the console to the front, ready to be typed into."""
        self.show("console")
        self.docks["console"].widget().setFocus()

    def reset(self) -> None:
        """Put all docks and groups where they were at the first start."""
        for dock in self.docks.values():
            dock.setFloating(False)
        self._timeline.dock.fold(True)
        self._window.restoreState(self._usual)
        self._fold(frozenset())

    def remember(self) -> None:
        """Keep in the settings how the window stands now."""
        docks, workspace = bytes(self._window.saveState().data()), self._context.view.state.workspace
        layout = Layout(docks, self._folded, workspace, not self._timeline.dock.is_folded)
        geometry = bytes(self._window.saveGeometry().toBase64().data()).decode()
        self._context.settings.change(geometry=geometry, layout=layout_text(layout))

    def restore(self) -> None:
        """Arrange the window as the settings have it."""
        preferences = self._context.settings.preferences
        geometry = QByteArray.fromBase64(preferences.geometry.encode())
        if geometry.isEmpty() or not self._window.restoreGeometry(geometry):
            room = QGuiApplication.primaryScreen().availableSize() * SHARE_OF_SCREEN
            self._window.resize(USUAL.boundedTo(room).expandedTo(LEAST))
        layout = layout_from(preferences.layout)
        self._timeline.dock.fold(not layout.timeline)
        if layout.docks:
            self._window.restoreState(QByteArray(layout.docks))
        self._fold(layout.folded)
        if any(kind.id == layout.workspace for kind in WORKSPACES):
            self._context.view.change(workspace=layout.workspace)
        self._panels.show_workspace(self._context.view.state.workspace)

    def _place(self) -> None:
        window, area = self._window, Qt.DockWidgetArea
        window.addDockWidget(area.RightDockWidgetArea, self.docks["workspace"])
        window.addDockWidget(area.LeftDockWidgetArea, self.docks["information"])
        self.docks["information"].hide()
        console = self.docks["console"]
        window.addDockWidget(area.BottomDockWidgetArea, self.docks["timeline"])
        window.addDockWidget(area.BottomDockWidgetArea, console)
        window.tabifyDockWidget(self.docks["timeline"], console)
        console.hide()
        console.toggleViewAction().triggered.connect(lambda on: self.open_console() if on else None)
        window.setCorner(Qt.Corner.BottomRightCorner, area.RightDockWidgetArea)

    def _fold(self, groups: frozenset[str]) -> None:
        self._folded = groups
        self._expression.fold(groups)

    def _note_folds(self, groups: frozenset[str]) -> None:
        self._folded = groups
