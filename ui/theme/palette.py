"""The Qt palette of a theme, so that every stock widget is in key without a rule of its own."""

from __future__ import annotations

from PySide6.QtGui import QColor, QPalette

from ui.theme.colour import blend
from ui.theme.roles import Theme

Role = QPalette.ColorRole
Group = QPalette.ColorGroup


def qt_palette(theme: Theme) -> QPalette:
    """All colour groups of a theme."""
    palette = QPalette()
    for role, colour in _normal(theme).items():
        palette.setColor(role, QColor(colour))
    faint = blend(theme.panel, theme.muted, 0.55)
    for role in (Role.WindowText, Role.Text, Role.ButtonText, Role.HighlightedText, Role.PlaceholderText):
        palette.setColor(Group.Disabled, role, faint)
    palette.setColor(Group.Disabled, Role.Highlight, QColor(theme.raised))
    palette.setColor(Group.Disabled, Role.Base, QColor(theme.panel))
    return palette


def _normal(theme: Theme) -> dict[Role, str | QColor]:
    return {
        Role.Window: theme.panel,
        Role.WindowText: theme.text,
        Role.Base: theme.raised,
        Role.AlternateBase: theme.panel,
        Role.Text: theme.text,
        Role.PlaceholderText: theme.muted,
        Role.Button: theme.raised,
        Role.ButtonText: theme.text,
        Role.BrightText: theme.error,
        Role.ToolTipBase: theme.raised,
        Role.ToolTipText: theme.text,
        Role.Highlight: theme.accent,
        Role.HighlightedText: theme.on_accent,
        Role.Link: theme.accent,
        Role.LinkVisited: theme.accent,
        Role.Accent: theme.accent,
        Role.Light: blend(theme.raised, theme.text, 0.12),
        Role.Midlight: blend(theme.raised, theme.text, 0.06),
        Role.Mid: theme.line,
        Role.Dark: theme.line,
        Role.Shadow: theme.window,
    }
