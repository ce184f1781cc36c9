"""Put a theme on the application, and ask which one is on."""

from __future__ import annotations

from typing import cast

from PySide6.QtGui import QFont, QFontDatabase
from PySide6.QtWidgets import QApplication

from ui.theme.metrics import TYPE
from ui.theme.palette import qt_palette
from ui.theme.roles import DARK, THEMES, Theme
from ui.theme.style import stylesheet

PROPERTY = "risoriusTheme"
"""Dynamic property of the application that holds the name of its theme."""


def apply_theme(app: QApplication, theme: Theme) -> None:
    """Dress the whole application; every window repaints at once, unless it is dressed so already."""
    sheet = stylesheet(theme)
    if app.styleSheet() == sheet:
        return
    app.setProperty(PROPERTY, theme.name)
    if app.style().name().lower() != "fusion":
        app.setStyle("Fusion")
    app.setFont(interface_font())
    app.setPalette(qt_palette(theme))
    app.setStyleSheet(sheet)


def current_theme() -> Theme:
    """The theme that is on; dark before any was put on."""
    app = QApplication.instance()
    return THEMES.get(cast(str, app.property(PROPERTY)), DARK) if app is not None else DARK


def interface_font(pixels: int = TYPE) -> QFont:
    """The system's typeface with figures of equal width, so that numbers do not dance while they change."""
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.GeneralFont)
    font.setPixelSize(pixels)
    font.setFeature(QFont.Tag("tnum"), 1)
    return font
