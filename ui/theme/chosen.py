"""What is chosen in a list: its ground, and writing upon it that recedes and can still be read."""

from __future__ import annotations

from PySide6.QtGui import QColor

from ui.theme.colour import blend
from ui.theme.roles import Theme

CHOSEN = 0.32
"""How much of the accent the ground of a chosen row has."""

NEARER = 0.5
"""How much nearer to full writing the receding kind is on a chosen row, whose tint takes contrast from it."""


def chosen_ground(theme: Theme) -> QColor:
    """The ground of a chosen row."""
    return blend(theme.window, theme.accent, CHOSEN)


def quiet_ink(theme: Theme, chosen: object = False) -> QColor:
    """Writing that recedes, on a plain ground or on that of a chosen row."""
    return blend(theme.muted, theme.text, NEARER) if chosen else QColor(theme.muted)
