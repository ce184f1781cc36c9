"""The skull stays in sight, through a clear skin, while its workspace is open."""

from __future__ import annotations

from typing import Any

from app.view_state import ViewState
from ui.workspaces.workspace import Parts

SHOWN: dict[str, Any] = {"skull": True, "muscles": False, "forces": False, "influence": False, "supports": False}
"""What is drawn while bone is worked on; muscles and colours on the skin would hide it."""


class SkullInSight:
    """Draws the skull and little else while its workspace is open, and then what was shown before."""

    def __init__(self, parts: Parts) -> None:
        self._view = parts.context.view
        self._before: ViewState | None = None

    def switch(self, on: bool) -> None:
        """Show the skull, or what was shown before; the selection stays."""
        state = self._view.state
        kept = {"muscle": state.muscle, "others": state.others}
        if on:
            self._before = state
            self._view.change(**SHOWN, **kept)
        elif self._before is not None:
            before, self._before = self._before, None
            self._view.change(**{name: getattr(before, name) for name in SHOWN}, **kept)
