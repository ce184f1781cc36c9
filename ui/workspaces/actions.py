"""Actions that switch the workspace and take a tool in hand, for menus, keys and palette."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from app.actions.action import Action
from app.actions.context import Context
from app.tools.brush_state import HandBrush
from app.tools.sculpt_state import HandSculpt
from app.tools.tool import Tool
from app.tools.toolbox import ToolBox
from ui.viewport.tool_hands import PAINTING
from ui.workspaces.workspace import WorkspaceKind

SHIFTED: Mapping[str, tuple[str, ...]] = {"Shift+]": ("Shift+}",), "Shift+[": ("Shift+{",)}
"""What some keyboards say where they are asked for a bracket with Shift."""


def workspace_actions(kinds: tuple[WorkspaceKind, ...]) -> tuple[Action, ...]:
    """One action for each workspace, and one for the next."""
    if len(kinds) < 2:
        return ()
    return (*map(_open, kinds), _next(kinds))


def tool_actions(toolbox: ToolBox) -> tuple[Action, ...]:
    """One action for each tool, possible where the workspace offers it."""
    return tuple(_take(tool, toolbox) for tool in toolbox.tools)


def brush_actions(toolbox: ToolBox) -> tuple[Action, ...]:
    """Size, strength and mirror of the brush, possible while a tool works with one."""
    entries: tuple[tuple[str, str, str, str, Callable[[HandBrush | HandSculpt], None]], ...] = (
        ("larger", "Larger brush", "]", "Make the brush larger", lambda hand: hand.resize(1)),
        ("smaller", "Smaller brush", "[", "Make the brush smaller", lambda hand: hand.resize(-1)),
        ("stronger", "Stronger brush", "Shift+]", "Make the brush stronger", lambda hand: hand.strengthen(1)),
        ("weaker", "Weaker brush", "Shift+[", "Make the brush weaker", lambda hand: hand.strengthen(-1)),
    )
    made = (
        Action(
            f"brush.{key}",
            title,
            lambda _context, act=act: act(toolbox.tool.brush),  # type: ignore[misc]
            menu=("Edit", "Brush"),
            group=4,
            shortcut=keys,
            also=SHIFTED.get(keys, ()),
            hint=hint,
            enabled=lambda _context: toolbox.tool.id in PAINTING,
        )
        for key, title, keys, hint, act in entries
    )
    return (*made, _mirror(toolbox))


def _mirror(toolbox: ToolBox) -> Action:
    return Action(
        "brush.mirror",
        "Mirror",
        lambda _context: toolbox.tool.brush.change(mirror=not toolbox.tool.brush.state.mirror),
        menu=("Edit", "Brush"),
        group=5,
        shortcut="X",
        hint="Paint or sculpt both sides of the face alike",
        kind="toggle",
        enabled=lambda context: context.view.state.workspace in ("skull", "tissue") or toolbox.tool.id == "sculpt",
        checked=lambda _context: toolbox.tool.brush.state.mirror,
    )


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
