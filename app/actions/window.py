"""The window itself, and help."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context


def _toggle_theme(context: Context) -> None:
    context.settings.change(theme="light" if context.settings.preferences.theme == "dark" else "dark")


WINDOW_ACTIONS = (
    Action(
        "window.theme",
        "Light theme",
        _toggle_theme,
        menu=("Window",),
        shortcut="Ctrl+Shift+L",
        hint="Dark letters on a light ground; off for the dark theme",
        kind="toggle",
        checked=lambda context: context.settings.preferences.theme == "light",
    ),
    Action(
        "window.full-screen",
        "Full screen",
        lambda context: context.host.toggle_full_screen(),
        menu=("Window",),
        shortcut="F11",
        hint="Fill the screen, or leave it again",
    ),
    Action(
        "window.reset-layout",
        "Reset layout",
        lambda context: context.host.reset_layout(),
        menu=("Window",),
        group=1,
        hint="Put all panels back where they were at the first start",
    ),
    Action(
        "help.shortcuts",
        "Keyboard shortcuts",
        lambda context: context.host.show_shortcuts(),
        menu=("Help",),
        shortcut="F1",
        hint="Show the keys for everything",
    ),
    Action(
        "help.about",
        "About Risorius",
        lambda context: context.host.show_about(),
        menu=("Help",),
        group=1,
        hint="Show version and licences",
    ),
)
