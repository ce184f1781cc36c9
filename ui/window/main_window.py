"""The main window: menus, tools, the face in the middle, docks around it, a line at the bottom."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, QEvent, QSize, Qt, Signal
from PySide6.QtGui import QCloseEvent, QGuiApplication, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QMainWindow

from app.actions.action import Action, perform
from app.actions.context import Context
from app.actions.files import may_leave
from app.actions.table import all_actions, in_order
from app.document import Document
from app.settings import UserSettings
from app.solving import Solving
from app.superposition_check import SuperpositionCheck
from app.tools.tool import Bench, Tool
from app.tools.toolbox import ToolBox
from app.view import View
from app.view_state import ViewState, Workspace
from facemodel.muscles import Muscle
from ui.panels.actions.sculpt_deeds import SCULPT_ACTIONS
from ui.panels.actions.unit_deeds import UNIT_ACTIONS
from ui.panels.console_panel import ConsolePanel
from ui.panels.expression_panel import ExpressionPanel
from ui.panels.face_information import FaceInformation
from ui.panels.muscle_text import muscle_label
from ui.panels.muscles.actions import MUSCLE_ACTIONS
from ui.panels.skull.deeds import skull_actions
from ui.portraits import Portraits
from ui.timeline.desk import TimelineDesk, desk_actions, timeline_view
from ui.viewport.tool_hands import ToolHands
from ui.widgets.command_palette import CommandPalette
from ui.window.action_binding import ActionBinding
from ui.window.delivery import UiThread
from ui.window.dock import Dock
from ui.window.drawing_quality import DrawingQuality
from ui.window.file_drops import FileDrops
from ui.window.first_hints import FirstHints
from ui.window.held_hand import HeldHand, tool_in_hand
from ui.window.host import WindowHost
from ui.window.layout import Layout, layout_from, layout_text
from ui.window.menus import fill_menus
from ui.window.palette_entries import palette_entries
from ui.window.preparation import Preparation
from ui.window.solve_progress import SolveProgress
from ui.window.status_line import StatusLine
from ui.window.tool_strip import ToolStrip
from ui.window.viewport_widget import Viewport
from ui.window.walking_keys import walks
from ui.workspaces.actions import brush_actions, tool_actions, workspace_actions
from ui.workspaces.registry import WORKSPACES, all_tools
from ui.workspaces.switching import WorkspacePanels
from ui.workspaces.tabs import WorkspaceTabs
from ui.workspaces.workspace import Parts, WorkspaceKind

LEAST = QSize(1024, 600)
USUAL = QSize(1440, 900)
SHARE_OF_SCREEN = 0.94

IDLE_HINT = "Drag a bar, or the face itself · right-drag turns the head · wheel zooms · Ctrl+Shift+P finds everything"


class MainWindow(QMainWindow):
    """Puts the parts together and shows them; what they do is theirs.

    Parameters
    ----------
    document, view, settings, solving : what is shown and changed; they outlive the window
    preparation : makes faces ready to be drawn; it ends with the window

    Signals
    -------
    closed() : the person has left; what is not saved by now is not wanted
    """

    closed = Signal()

    def __init__(
        self, document: Document, view: View, settings: UserSettings, solving: Solving, preparation: Preparation
    ) -> None:
        super().__init__()
        self.setMinimumSize(LEAST)
        self.setDockOptions(QMainWindow.DockOption.AllowTabbedDocks | QMainWindow.DockOption.AnimatedDocks)
        self._folded: frozenset[str] = frozenset()
        self.context = Context(document, view, settings, solving, WindowHost(self))
        bench = Bench(document, view, deliver=UiThread(self).deliver)
        self.toolbox = ToolBox(bench, all_tools())
        self.span = timeline_view(document)
        self.binding = ActionBinding(self, self.context, self._actions, self.span.signals)
        self.viewport = Viewport(document, view, preparation, self)
        self.setCentralWidget(self.viewport)
        self.quality = DrawingQuality(self.viewport.canvas, view, settings)
        self.check = SuperpositionCheck(document, view, UiThread(self).deliver)
        self.portraits = Portraits(document, self)
        parts = Parts(self.context, bench, self.toolbox, self.viewport, self.check, self.portraits, preparation)
        self.panels = WorkspacePanels(parts, WORKSPACES)
        self.expression: ExpressionPanel = self.panels.panel("expression")
        self.timeline = TimelineDesk(self.span, self.binding, self.viewport, self.context, self.portraits)
        self.docks = self._make_docks(document)
        self.hands = ToolHands(self.viewport.canvas, self.viewport.scene, self.toolbox)
        self.held = HeldHand(self, self.binding.qt, {self.viewport.canvas: tool_in_hand(self.hands, self.toolbox)})
        self.strip = ToolStrip(self.binding, self.toolbox)
        self.addToolBar(Qt.ToolBarArea.LeftToolBarArea, self.strip)
        self.status = StatusLine(self)
        self.setStatusBar(self.status)
        self.tabs = WorkspaceTabs(view, WORKSPACES)
        self.menuBar().setCornerWidget(self.tabs)
        self.palette_box = CommandPalette(self, lambda query: palette_entries(query, self.context, self.binding))
        self.progress = SolveProgress(self.context, self.status, self.viewport)
        self.hints = FirstHints(self.context, self.viewport)
        self._place_docks()
        self._usual = self.saveState()
        self._connect()
        self._refill_menus()
        self._retitle()
        self.status.show_hint(IDLE_HINT)
        self._restore()
        self.viewport.canvas.setFocus()

    def reset_layout(self) -> None:
        """Put all docks and groups where they were at the first start."""
        for dock in self.docks.values():
            dock.setFloating(False)
        self.timeline.dock.fold(True)
        self.restoreState(self._usual)
        self._fold(frozenset())

    def show_dock(self, name: str) -> None:
        """Bring a dock to the front."""
        self.docks[name].show()
        self.docks[name].raise_()

    def show_workspace(self, workspace: Workspace) -> None:
        """Open a workspace and bring its panel to the front."""
        self.context.view.change(workspace=workspace)
        self.show_dock("workspace")

    def event(self, event: QEvent) -> bool:
        """Keys meet the state as it is; those that walk within a panel are its own while it has the keyboard."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            self.binding.settle()
            if walks(event, self.focusWidget(), self.viewport.canvas):
                event.accept()
        return super().event(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        """End a drag, ask about an export and unsaved changes, remember the layout, stop what is being solved."""
        self.held.take_back()
        if not (self.context.host.may_stop_export() and may_leave(self.context)):
            event.ignore()
            return
        self.context.settings.change(
            geometry=bytes(self.saveGeometry().toBase64().data()).decode(),
            layout=layout_text(self._layout()),
        )
        self.context.solving.job.close()
        self.check.job.close()
        self.portraits.close()
        self.toolbox.bench.clear()
        for part in (self.timeline, self.viewport, self.held):
            part.close()
        event.accept()
        self.closed.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the palette in the middle."""
        super().resizeEvent(event)
        if self.palette_box.isVisible():
            self.palette_box.place()

    def _make_docks(self, document: Document) -> dict[str, Dock]:
        return {
            "timeline": self.timeline.dock,
            "workspace": Dock("workspace", "Expression", self.panels),
            "information": Dock("information", "Face information", FaceInformation(document)),
            "console": Dock("console", "Console", ConsolePanel(document, self.context.view)),
        }

    def _place_docks(self) -> None:
        self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self.docks["workspace"])
        self.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, self.docks["information"])
        self.docks["information"].hide()
        console = self.docks["console"]
        self.addDockWidget(Qt.DockWidgetArea.BottomDockWidgetArea, self.docks["timeline"])
        self.addDockWidget(Qt.DockWidgetArea.BottomDockWidgetArea, console)
        self.tabifyDockWidget(self.docks["timeline"], console)
        console.hide()
        console.toggleViewAction().triggered.connect(lambda on: self._open_console() if on else None)
        self.setCorner(Qt.Corner.BottomRightCorner, Qt.DockWidgetArea.RightDockWidgetArea)

    def _connect(self) -> None:
        FileDrops(self, self.context, self.timeline.exchange.openers)
        document = self.context.document
        document.saved_changed.connect(self._retitle)
        document.project_changed.connect(self._retitle)
        self.context.view.changed.connect(self._follow_view)
        self.context.settings.failed.connect(self.status.notify)
        self.quality.changed.connect(self.status.notify)
        self.binding.table_changed.connect(self._refill_menus)
        self.palette_box.chosen.connect(self._run)
        self.panels.opened.connect(self._name_panel)
        self.toolbox.tool_changed.connect(self._take_tool)
        self.toolbox.failed.connect(self.status.notify)
        bench = self.toolbox.bench
        for brush in (bench.brush, bench.sculpt):
            brush.changed.connect(lambda *_now: (self.binding.refresh(), self._advise()))
        document.expression_changed.connect(lambda _now: self._advise())
        bench.sight.pointed_changed.connect(self.viewport.name_muscle)
        self.expression.folds_changed.connect(self._note_folds)
        self.expression.muscles_hovered.connect(self.viewport.glow)
        self.viewport.muscle_hovered.connect(self._name_muscle)
        self.timeline.advised.connect(lambda text: self.status.show_hint(text) if text else self._advise())
        self.timeline.failed.connect(self.status.notify)

    def _layout(self) -> Layout:
        docks, workspace = bytes(self.saveState().data()), self.context.view.state.workspace
        return Layout(docks, self._folded, workspace, not self.timeline.dock.is_folded)

    def _restore(self) -> None:
        preferences = self.context.settings.preferences
        geometry = QByteArray.fromBase64(preferences.geometry.encode())
        if geometry.isEmpty() or not self.restoreGeometry(geometry):
            room = QGuiApplication.primaryScreen().availableSize() * SHARE_OF_SCREEN
            self.resize(USUAL.boundedTo(room).expandedTo(LEAST))
        layout = layout_from(preferences.layout)
        self.timeline.dock.fold(not layout.timeline)
        if layout.docks:
            self.restoreState(QByteArray(layout.docks))
        self._fold(layout.folded)
        if any(kind.id == layout.workspace for kind in WORKSPACES):
            self.context.view.change(workspace=layout.workspace)
        self.panels.show_workspace(self.context.view.state.workspace)

    def _actions(self, context: Context) -> tuple[Action, ...]:
        of_tools = (*tool_actions(self.toolbox), *brush_actions(self.toolbox))
        authoring = (*MUSCLE_ACTIONS, *UNIT_ACTIONS, *SCULPT_ACTIONS, *skull_actions(self.toolbox.bench))
        of_window = (*all_actions(context), *desk_actions(self.span, lambda: self.timeline), self._console_action())
        return in_order((*of_window, *authoring, *workspace_actions(WORKSPACES), *of_tools))

    def _console_action(self) -> Action:
        """For the palette and for keys of one's own; the menu has the dock's own switch."""
        hint = "Run Python of your own on the open project, each entry as one step"
        return Action("window.console", "Console", lambda _context: self._open_console(), hint=hint)

    def _open_console(self) -> None:
        self.show_dock("console")
        self.docks["console"].widget().setFocus()

    def _take_tool(self, tool: Tool) -> None:
        """Show what is in hand; over the face of the expression workspace the pointer names muscles."""
        posing = self.context.view.state.workspace == "expression"
        self.hands.activate(not posing or tool.id == "pull")
        self.viewport.face_pointer.awake = posing
        self.viewport.canvas.setCursor(Qt.CursorShape.ArrowCursor if posing else Qt.CursorShape.CrossCursor)
        self._advise()
        self.strip.offer_tools()
        self.binding.refresh()

    def _advise(self) -> None:
        """Say in the status line what the hand can do now."""
        posing = self.context.view.state.workspace == "expression"
        self.status.show_hint(IDLE_HINT if posing else self.toolbox.tool.advice)

    def _name_panel(self, kind: WorkspaceKind) -> None:
        self.docks["workspace"].retitle(kind.title)
        self._take_tool(self.toolbox.tool)

    def _fold(self, groups: frozenset[str]) -> None:
        self._folded = groups
        self.expression.fold(groups)

    def _note_folds(self, groups: frozenset[str]) -> None:
        self._folded = groups

    def _refill_menus(self) -> None:
        fill_menus(self.menuBar(), self.binding, [dock.toggleViewAction() for dock in self.docks.values()])

    def _retitle(self, _now: object = None) -> None:
        document = self.context.document
        self.setWindowTitle(f"{document.name}[*] — Risorius")
        self.setWindowModified(document.dirty)
        self.setWindowFilePath(str(document.path or ""))

    def _run(self, action: Action) -> None:
        perform(action, self.context)
        self.binding.refresh()

    def _follow_view(self, now: ViewState, before: ViewState) -> None:
        self._advise()
        of_unit = now.workspace == "actions"
        if now.influence and not before.influence and not now.muscle and now.workspace != "muscles" and not of_unit:
            self.show_workspace("muscles")
            self.status.notify("Choose the muscle whose influence is to be shown.")

    def _name_muscle(self, muscle: Muscle | None) -> None:
        if muscle is None:
            self._advise()
        else:
            self.status.show_hint(f"{muscle_label(muscle)} · a click selects it")
