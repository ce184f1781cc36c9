"""The owner of what the viewport shows."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from psygnal import Signal

from app.view_state import ViewName, ViewState


class View:
    """Holds one `ViewState` and tells when it becomes another."""

    changed = Signal(object, object)
    """(ViewState now, ViewState before)"""
    camera_asked = Signal(str)
    """(ViewName) look from there, even if the camera is said to be there already."""

    def __init__(self, state: ViewState | None = None) -> None:
        self._state = state or ViewState()

    @property
    def state(self) -> ViewState:
        """What is shown."""
        return self._state

    def change(self, **members: Any) -> None:
        """Change some members of the state; nothing is emitted if they are so already.

        A muscle that is selected without others is selected alone.
        """
        if "muscle" in members:
            members.setdefault("others", frozenset())
        before, self._state = self._state, replace(self._state, **members)
        if self._state != before:
            self.changed.emit(self._state, before)

    def toggle(self, member: str) -> None:
        """Turn a switch of the state over."""
        self.change(**{member: not getattr(self._state, member)})

    def select_also(self, muscle: str) -> None:
        """Take a muscle into the selection, or out of it if it is in it."""
        kept = self._state.selected - {muscle}
        if muscle in self._state.selected:
            last = min(kept, default="")
            self.change(muscle=last, others=kept - {last})
        else:
            self.change(muscle=muscle, others=kept)

    def look_from(self, view: ViewName) -> None:
        """Ask for a view; a turning head stops, so that the view can be seen."""
        self.change(view=view, turntable=False)
        self.camera_asked.emit(view)
