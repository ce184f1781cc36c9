"""The tabs of the workspaces, at the right end of the menu bar."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QTabBar, QWidget

from app.view import View
from app.view_state import ViewState
from ui.workspaces.workspace import WorkspaceKind


class WorkspaceTabs(QTabBar):
    """Binds the workspace of a view to tabs, both ways.

    Parameters
    ----------
    view : whose workspace it is
    kinds : of workspaces
    """

    def __init__(self, view: View, kinds: tuple[WorkspaceKind, ...], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("workspaces")
        self.setDrawBase(False)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setExpanding(False)
        self.setUsesScrollButtons(False)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAccessibleName("Workspaces")
        self._view = view
        self._ids = [kind.id for kind in kinds]
        for kind in kinds:
            self.setTabToolTip(self.addTab(kind.title), f"{kind.title} workspace (Tab: the next one)")
        self._mark(view.state.workspace)
        self.currentChanged.connect(lambda place: view.change(workspace=self._ids[place]))
        view.changed.connect(self._follow)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """The wheel never changes the workspace by accident."""
        event.ignore()

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if now.workspace != before.workspace:
            self._mark(now.workspace)

    def _mark(self, workspace: str) -> None:
        self.setCurrentIndex(self._ids.index(workspace))
