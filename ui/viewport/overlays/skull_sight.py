"""The skull stays in sight, through a clear skin, while its workspace is open, and is looked after."""

from __future__ import annotations

from typing import Any

from app.view_state import ViewState
from ui.workspaces.workspace import Parts

SHOWN: dict[str, Any] = {"skull": True, "muscles": False, "forces": False, "influence": False, "supports": False}
"""What is drawn while bone is worked on; muscles and colours on the skin would hide it."""

TRIED: dict[str, Any] = {"jaw_open": 0.0, "jaw_slide": 0.0, "jaw_side": 0.0}
"""The jaw is where the sliders have it."""


class SkullInSight:
    """Draws the skull and little else while its workspace is open, and then what was shown before."""

    def __init__(self, parts: Parts) -> None:
        self._view, self._bench = parts.context.view, parts.bench
        self._before: ViewState | None = None

    def switch(self, on: bool) -> None:
        """Show the skull and find out about it, or show what was shown before; the selection stays."""
        state = self._view.state
        kept = {"muscle": state.muscle, "others": state.others}
        if on:
            self._before = state
            self._view.change(**SHOWN, **kept)
            self._bench.watch.attend(self._bench.deliver)
        elif self._before is not None:
            before, self._before = self._before, None
            self._view.change(**{name: getattr(before, name) for name in SHOWN}, **TRIED, **kept)
            self._bench.watch.leave()
