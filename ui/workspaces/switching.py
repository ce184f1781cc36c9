"""Switching between workspaces: the panel at the right and what is drawn over the face; camera and pose stay."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QSizePolicy, QStackedWidget, QWidget

from app.view_state import ViewState, Workspace
from ui.workspaces.workspace import Drawing, Parts, WorkspaceKind


class WorkspacePanels(QStackedWidget):
    """The panel of the open workspace; panels and drawings are made when their workspace is first opened.

    Signals
    -------
    opened(object) : the WorkspaceKind that is open now

    Parameters
    ----------
    parts : what they work on
    kinds : of workspaces
    """

    opened = Signal(object)

    def __init__(self, parts: Parts, kinds: tuple[WorkspaceKind, ...]) -> None:
        super().__init__()
        self._parts = parts
        self._kinds = {kind.id: kind for kind in kinds}
        self._panels: dict[Workspace, QWidget] = {}
        self._drawings: dict[Workspace, tuple[Drawing, ...]] = {}
        self._open: WorkspaceKind | None = None
        parts.context.view.changed.connect(self._follow)
        parts.context.document.project_changed.connect(self._prepare)

    @property
    def open(self) -> WorkspaceKind | None:
        """The workspace that is open."""
        return self._open

    def panel(self, workspace: Workspace) -> QWidget:
        """The panel of a workspace."""
        if workspace not in self._panels:
            made = self._panels[workspace] = self._kinds[workspace].panel(self._parts)
            self.addWidget(made)
        return self._panels[workspace]

    def show_workspace(self, workspace: Workspace) -> None:
        """Show the panel of a workspace and draw what belongs to it; what belongs to the one before goes."""
        if self._open is not None:
            for drawing in self._drawings_of(self._open):
                drawing.switch(False)
        self._open = self._kinds[workspace]
        first = workspace not in self._panels
        panel = self.panel(workspace)
        if first and self._open.tools:
            self._parts.toolbox.take(self._open.tools[0].id)
        self._prepare()
        for other in self._panels.values():
            # A hidden page must not keep the dock wide for the one that is shown.
            asked = QSizePolicy.Policy.Preferred if other is panel else QSizePolicy.Policy.Ignored
            other.setSizePolicy(asked, asked)
        self.setCurrentWidget(panel)
        for drawing in self._drawings_of(self._open):
            drawing.switch(True)
        self._parts.viewport.canvas.ask_frame()
        self.opened.emit(self._open)

    def _prepare(self, *_now: object) -> None:
        if self._open is not None and self._open.prepare is not None:
            self._open.prepare(self._parts)

    def _drawings_of(self, kind: WorkspaceKind) -> tuple[Drawing, ...]:
        if kind.id not in self._drawings:
            self._drawings[kind.id] = tuple(make(self._parts) for make in kind.drawings)
        return self._drawings[kind.id]

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if now.workspace != before.workspace:
            self.show_workspace(now.workspace)
