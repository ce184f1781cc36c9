"""One thing that a person can do, and all that menus, toolbar, shortcuts and palette need to know of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from app.actions.context import Context
from app.preferences import Preferences
from facemodel.errors import RisoriusError

Kind = Literal["command", "toggle", "choice"]
"""A command acts, a toggle is on or off, a choice is one of its group."""


def always(_context: Context) -> bool:
    """For actions that are possible at any time."""
    return True


def never(_context: Context) -> bool:
    """For actions that are not on or off."""
    return False


@dataclass(frozen=True)
class Action:
    """Something to do.

    Attributes
    ----------
    id : unique and for ever the same, for example ``file.open``
    title : what it is called; three dots at its end if it asks before it acts
    run : does it
    menu : where it stands, outermost first; empty if only the palette offers it
    group : actions of one menu with different groups are parted by a line
    shortcut, also : keys in Qt's portable spelling, the first one shown
    hint : one sentence for tooltip and status line
    kind : see `Kind`
    enabled : whether it is possible now
    checked : whether it is on now
    caption : its title now, where that depends on the document
    toolbar : whether the toolbar has it
    """

    id: str
    title: str
    run: Callable[[Context], None]
    menu: tuple[str, ...] = ()
    group: int = 0
    shortcut: str = ""
    also: tuple[str, ...] = ()
    hint: str = ""
    kind: Kind = "command"
    enabled: Callable[[Context], bool] = always
    checked: Callable[[Context], bool] = never
    caption: Callable[[Context], str] | None = None
    toolbar: bool = False

    def title_now(self, context: Context) -> str:
        """The title to show now."""
        return self.caption(context) if self.caption else self.title


def perform(action: Action, context: Context) -> None:
    """Do it if it is possible now; an error that is meant for people is shown to them."""
    if not action.enabled(context):
        return
    try:
        action.run(context)
    except RisoriusError as error:
        context.host.show_error(str(error))


def shortcuts_of(action: Action, preferences: Preferences) -> tuple[str, ...]:
    """The keys of an action: the user's, or its own."""
    if action.id in preferences.shortcuts:
        return tuple(filter(None, [preferences.shortcuts[action.id]]))
    return tuple(filter(None, (action.shortcut, *action.also)))
