"""Hide and lock muscles: what is drawn, and what no hand changes; no part of the project, so nothing to undo."""

from __future__ import annotations

from collections.abc import Iterable

from app.actions.action import Action
from app.actions.context import Context
from facemodel.muscles import Muscle
from ui.panels.muscles.selection import chosen, titles

MENU = ("Edit", "Muscle")


def hide(context: Context) -> None:
    """Draw the selected muscles no longer; whatever they do to the face stays."""
    muscles = chosen(context.document.project, context.view.state)
    context.view.hide(_keys(muscles))
    context.host.show_message(f"Hidden {titles(muscles)}. Alt+H shows all muscles again.")


def hide_others(context: Context) -> None:
    """Draw the selected muscles alone."""
    own = _keys(chosen(context.document.project, context.view.state))
    context.view.hide(_keys(context.document.project.muscles) - own)


def show_all(context: Context) -> None:
    """Draw all muscles again."""
    context.view.hide(context.view.state.hidden, on=False)


def lock(context: Context) -> None:
    """Keep the selected muscles from being changed by hand, or no longer."""
    muscles = chosen(context.document.project, context.view.state)
    on = not _locked(context)
    context.view.lock(_keys(muscles), on)
    if on:
        context.host.show_message(f"Locked {titles(muscles)}: no hand moves, changes or deletes what is locked.")


def unlock_all(context: Context) -> None:
    """Let all muscles be changed again."""
    context.view.lock(context.view.state.locked, on=False)


def _keys(muscles: Iterable[Muscle]) -> frozenset[str]:
    return frozenset(muscle.key for muscle in muscles)


def _any(context: Context) -> bool:
    return bool(chosen(context.document.project, context.view.state))


def _locked(context: Context) -> bool:
    muscles = chosen(context.document.project, context.view.state)
    return bool(muscles) and _keys(muscles) <= context.view.state.locked


SIGHT_ACTIONS = (
    Action("muscle.hide", "Hide", hide, MENU, 2, "H", hint="Draw the selected muscles no longer", enabled=_any),
    Action(
        "muscle.hide-others",
        "Hide all others",
        hide_others,
        MENU,
        2,
        "Shift+H",
        hint="Draw the selected muscles alone",
        enabled=_any,
    ),
    Action(
        "muscle.show-all",
        "Show all muscles",
        show_all,
        MENU,
        2,
        "Alt+H",
        hint="Draw all muscles that are hidden",
        enabled=lambda context: bool(context.view.state.hidden),
    ),
    Action(
        "muscle.lock",
        "Lock",
        lock,
        MENU,
        2,
        hint="Keep the selected muscles from being moved, changed or deleted by hand",
        kind="toggle",
        enabled=_any,
        checked=_locked,
    ),
    Action(
        "muscle.unlock-all",
        "Unlock all muscles",
        unlock_all,
        MENU,
        2,
        hint="Let all muscles be changed again",
        enabled=lambda context: bool(context.view.state.locked),
    ),
)
"""For the tree's menu, the menu bar and the palette."""
