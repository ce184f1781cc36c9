"""The one table of everything that can be done."""

from __future__ import annotations

from collections.abc import Iterable

from app.actions.action import Action
from app.actions.content import content_actions
from app.actions.context import Context
from app.actions.edit import EDIT_ACTIONS
from app.actions.examples import EXAMPLE_ACTIONS
from app.actions.files import FILE_ACTIONS, OPEN, bare_actions, new_actions, recent_actions
from app.actions.looking import LOOKING_ACTIONS
from app.actions.quality import QUALITY_ACTIONS
from app.actions.solving import SOLVING_ACTIONS, face_actions
from app.actions.window import WINDOW_ACTIONS

MENUS = ("File", "Edit", "View", "Face", "Animation", "Solve", "Window", "Help")
"""The menu bar, from left to right."""

LATE = (("File", "Import"), ("File", "Export"), "file.screenshot", "file.run-script", "file.quit")
"""Submenus and actions that end a menu, in this order, whichever table they come from."""


def all_actions(context: Context) -> tuple[Action, ...]:
    """Everything that can be done, in the order of the menus; other after any of `table_signals`."""
    return (
        *new_actions(),
        *bare_actions(),
        OPEN,
        *recent_actions(context),
        *EXAMPLE_ACTIONS,
        *FILE_ACTIONS,
        *EDIT_ACTIONS,
        *LOOKING_ACTIONS,
        *QUALITY_ACTIONS,
        *face_actions(),
        *SOLVING_ACTIONS,
        *WINDOW_ACTIONS,
        *content_actions(context.document.project),
    )


def in_order(actions: Iterable[Action]) -> tuple[Action, ...]:
    """Actions of several tables in one; what ends a menu stays at its end."""
    return tuple(sorted(actions, key=_lateness))


def _lateness(action: Action) -> int:
    """Where an action stands among those that end a menu, from 1 on; 0 of all others."""
    return next((place for place, late in enumerate(LATE, 1) if late in (action.id, action.menu[:2])), 0)
