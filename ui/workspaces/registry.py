"""The workspaces that there are, in the order of their tabs.  A new one is one more entry here."""

from __future__ import annotations

from app.tools.select import SelectTool
from app.tools.tool import Tool
from ui.panels.expression_panel import ExpressionPanel
from ui.workspaces.workspace import Parts, WorkspaceKind


def _expression_panel(parts: Parts) -> ExpressionPanel:
    return ExpressionPanel(parts.context.document, parts.context.view)


WORKSPACES: tuple[WorkspaceKind, ...] = (WorkspaceKind("expression", _expression_panel, (SelectTool,)),)


def all_tools() -> tuple[type[Tool], ...]:
    """The tools of all workspaces, each once."""
    return tuple(dict.fromkeys(tool for kind in WORKSPACES for tool in kind.tools))
