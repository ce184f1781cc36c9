"""What is drawn while the Muscles workspace is open: muscles, influence, and the skull while fibres are laid on it."""

from __future__ import annotations

from app.tools.tool import Tool
from app.view_state import ViewState
from ui.workspaces.workspace import Parts

ON_BONE = "fibre"
"""The tool that lays fibres on bone, which is then to be seen."""


class MusclesInSight:
    """Keeps the muscles drawn and the selected one's influence shown while their workspace is open."""

    def __init__(self, parts: Parts) -> None:
        self._view, self._toolbox = parts.context.view, parts.toolbox
        self._before: ViewState | None = None
        self._skull_before: bool | None = None
        self._toolbox.tool_changed.connect(self._take)

    def switch(self, on: bool) -> None:
        """Show the muscles, or what was shown before; what a person switched in between stays so."""
        if on:
            self._before = self._view.state
            self._view.change(muscles=True, influence=True)
            self._take(self._toolbox.tool)
        elif self._before is not None:
            before, self._before = self._before, None
            self._hide_bone()
            self._view.change(muscles=before.muscles, influence=before.influence)

    def _take(self, tool: Tool) -> None:
        """Show the skull with the tool that works on it."""
        if self._before is None:
            return
        if tool.id != ON_BONE:
            self._hide_bone()
        elif self._skull_before is None:
            self._skull_before = self._view.state.skull
            self._view.change(skull=True)

    def _hide_bone(self) -> None:
        before, self._skull_before = self._skull_before, None
        if before is not None:
            self._view.change(skull=before)
