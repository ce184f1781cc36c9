"""One table of actions, from which menus, toolbar, shortcuts, palette and scripts derive."""

from app.actions.action import Action, Kind, perform, shortcuts_of
from app.actions.context import Answer, Context, FileQuestion, Host, state_signals, table_signals
from app.actions.files import may_leave, open_path
from app.actions.table import MENUS, all_actions

__all__ = [
    "MENUS",
    "Action",
    "Answer",
    "Context",
    "FileQuestion",
    "Host",
    "Kind",
    "all_actions",
    "may_leave",
    "open_path",
    "perform",
    "shortcuts_of",
    "state_signals",
    "table_signals",
]
