"""Do what may be refused; what is wrong with it is told, and nothing else happens."""

from __future__ import annotations

from collections.abc import Callable

from app.actions.context import Context
from facemodel.errors import RisoriusError
from facemodel.project import Project


def told(context: Context, act: Callable[[], object]) -> bool:
    """Do something, and tell what is wrong with it; whether it was done."""
    try:
        act()
    except RisoriusError as error:
        context.host.show_message(str(error))
        return False
    return True


def step(context: Context, change: Callable[[Project], Project], label: str) -> bool:
    """Change the project in one step, and tell what is wrong with it; whether it was changed."""
    document = context.document
    return told(context, lambda: document.edit(change(document.project), label))
