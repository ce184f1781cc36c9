"""The owner of what the viewport shows."""

from __future__ import annotations

from collections.abc import Iterable
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

    def hide(self, keys: Iterable[str], on: bool = True) -> None:
        """Draw some muscles no longer, which also lets go of them, or draw them again."""
        asked = frozenset(keys)
        hidden = self._state.hidden | asked if on else self._state.hidden - asked
        kept = self._state.selected - asked if on else self._state.selected
        muscle = self._state.muscle if self._state.muscle in kept else min(kept, default="")
        self.change(hidden=hidden, muscle=muscle, others=kept - {muscle})

    def lock(self, keys: Iterable[str], on: bool = True) -> None:
        """Keep some muscles from being changed by hand, or no longer."""
        asked = frozenset(keys)
        self.change(locked=self._state.locked | asked if on else self._state.locked - asked)

    def look_from(self, view: ViewName) -> None:
        """Ask for a view; a turning head stops, so that the view can be seen."""
        self.change(view=view, turntable=False)
        self.camera_asked.emit(view)
