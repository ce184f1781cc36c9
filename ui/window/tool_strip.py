"""The thin toolbar at the left: what is reached for all the time."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QToolBar

from ui.theme.metrics import ICON
from ui.window.action_binding import ActionBinding

STRIP = (
    ("file.open", "file.save"),
    ("edit.undo", "edit.redo", "edit.reset"),
    ("view.front", "view.three-quarter", "view.left", "view.right", "view.turntable"),
    ("view.skull", "view.muscles", "view.forces", "view.supports", "view.wireframe", "view.influence"),
    ("file.screenshot",),
)
"""Ids of the actions, in groups."""


class ToolStrip(QToolBar):
    """Icons only; their tooltips name title, keys and what happens."""

    def __init__(self, binding: ActionBinding) -> None:
        super().__init__("Tools")
        self.setObjectName("tools")
        self.setOrientation(Qt.Orientation.Vertical)
        self.setMovable(False)
        self.setIconSize(QSize(ICON, ICON))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
        for place, group in enumerate(STRIP):
            if place:
                self.addSeparator()
            for key in group:
                self.addAction(binding.qt[key])
        for key in (key for group in STRIP for key in group):
            button = self.widgetForAction(binding.qt[key])
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            button.setAccessibleName(binding.qt[key].text())
