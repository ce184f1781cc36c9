"""The main window: menus, tools, the face in the middle, docks around it, a line at the bottom."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QCloseEvent, QKeyEvent, QResizeEvent
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
from ui.panels.expression_panel import ExpressionPanel
from ui.panels.muscle_text import muscle_label
from ui.panels.muscles.actions import MUSCLE_ACTIONS
from ui.panels.skull.deeds import skull_actions
from ui.portraits import Portraits
from ui.timeline.desk import TimelineDesk, desk_actions, timeline_view
from ui.viewport.tool_hands import ToolHands
from ui.widgets.command_palette import CommandPalette
from ui.window.action_binding import ActionBinding
from ui.window.arrangement import LEAST, Arrangement
from ui.window.delivery import UiThread
from ui.window.drawing_quality import DrawingQuality
from ui.window.file_drops import FileDrops
from ui.window.first_hints import FirstHints
from ui.window.held_hand import HeldHand, tool_in_hand
from ui.window.host import WindowHost
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

HELD = "Let go of the mouse first, or take it back with Esc."
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
        self.arrangement = Arrangement(self, self.context, self.panels, self.timeline)
        self.docks = self.arrangement.docks
        self._connect()
        self._refill_menus()
        self._retitle()
        self.status.show_hint(IDLE_HINT)
        self.arrangement.restore()
        self.viewport.canvas.setFocus()

    def show_workspace(self, workspace: Workspace) -> None:
        """Open a workspace and bring its panel to the front."""
        self.context.view.change(workspace=workspace)
        self.arrangement.show("workspace")

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
        self.arrangement.remember()
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

    def _connect(self) -> None:
        FileDrops(self, self.context, self.timeline.exchange.openers)
        document = self.context.document
        document.saved_changed.connect(self._retitle)
        document.project_changed.connect(self._retitle)
        self.context.view.changed.connect(self._follow_view)
        self.context.settings.failed.connect(self.status.notify)
        self.quality.changed.connect(self.status.notify)
        self.held.refused.connect(lambda: self.status.notify(HELD))
        self.held.freed.connect(lambda: self.status.withdraw(HELD))
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
        self.expression.muscles_hovered.connect(self.viewport.glow)
        self.viewport.muscle_hovered.connect(self._name_muscle)
        self.timeline.advised.connect(lambda text: self.status.show_hint(text) if text else self._advise())
        self.timeline.failed.connect(self.status.notify)

    def _actions(self, context: Context) -> tuple[Action, ...]:
        of_tools = (*tool_actions(self.toolbox), *brush_actions(self.toolbox))
        authoring = (*MUSCLE_ACTIONS, *UNIT_ACTIONS, *SCULPT_ACTIONS, *skull_actions(self.toolbox.bench))
        of_window = (*all_actions(context), *desk_actions(self.span, lambda: self.timeline), self._console_action())
        return in_order((*of_window, *authoring, *workspace_actions(WORKSPACES), *of_tools))

    def _console_action(self) -> Action:
        """For the palette and for keys of one's own; the menu has the dock's own switch."""
        hint = "Run Python of your own on the open project, each entry as one step"
        return Action("window.console", "Console", lambda _context: self.arrangement.open_console(), hint=hint)

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

    def _refill_menus(self) -> None:
        fill_menus(self.menuBar(), self.binding, self.arrangement.switches)

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
