"""Actions that switch the workspace and take a tool in hand, for menus, keys and palette."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.tools.tool import Tool
from app.tools.toolbox import ToolBox
from ui.workspaces.workspace import WorkspaceKind


def workspace_actions(kinds: tuple[WorkspaceKind, ...]) -> tuple[Action, ...]:
    """One action for each workspace, and one for the next."""
    if len(kinds) < 2:
        return ()
    return (*map(_open, kinds), _next(kinds))


def tool_actions(toolbox: ToolBox) -> tuple[Action, ...]:
    """One action for each tool, possible where the workspace offers it."""
    return tuple(_take(tool, toolbox) for tool in toolbox.tools)


def _open(kind: WorkspaceKind) -> Action:
    return Action(
        f"workspace.{kind.id}",
        kind.title,
        lambda context: context.view.change(workspace=kind.id),
        menu=("View", "Workspace"),
        group=-1,
        hint=f"Open the workspace “{kind.title}”; camera and expression stay",
        kind="choice",
        checked=lambda context: context.view.state.workspace == kind.id,
    )


def _next(kinds: tuple[WorkspaceKind, ...]) -> Action:
    ids = [kind.id for kind in kinds]

    def go(context: Context) -> None:
        place = ids.index(context.view.state.workspace)
        context.view.change(workspace=ids[(place + 1) % len(ids)])

    return Action(
        "workspace.next",
        "Next workspace",
        go,
        menu=("View", "Workspace"),
        group=1,
        shortcut="Tab",
        also=("Ctrl+Tab",),
        hint="Go to the next workspace; in a panel Tab goes to the next field, and Ctrl+Tab to the next workspace",
    )


def _take(tool: Tool, toolbox: ToolBox) -> Action:
    return Action(
        f"tool.{tool.id}",
        tool.title,
        lambda _context: toolbox.take(tool.id),
        menu=("Edit", "Tool"),
        group=4,
        shortcut=tool.shortcut,
        hint=tool.hint,
        kind="choice",
        enabled=lambda context: tool in toolbox.offered(context.view.state.workspace),
        checked=lambda _context: toolbox.tool is tool,
    )
