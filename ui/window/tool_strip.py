"""The thin toolbar at the left: what is reached for all the time."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QToolBar, QToolButton

from app.tools.toolbox import ToolBox
from ui.theme.icons import icon
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

EXTENSION = "qt_toolbar_ext_button"
"""What Qt calls the button that opens what finds no room."""


class ToolStrip(QToolBar):
    """Icons only; their tooltips name title, keys and what happens."""

    def __init__(self, binding: ActionBinding, toolbox: ToolBox) -> None:
        super().__init__("Tools")
        self.setObjectName("tools")
        self.setOrientation(Qt.Orientation.Vertical)
        self.setMovable(False)
        self.setIconSize(QSize(ICON, ICON))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
        self._binding, self._toolbox = binding, toolbox
        tools = tuple(f"tool.{tool.id}" for tool in toolbox.tools)
        for place, group in enumerate((tools, *STRIP)):
            if place:
                self.addSeparator()
            for key in group:
                self.addAction(binding.qt[key])
        for key in (key for group in (tools, *STRIP) for key in group):
            button = self.widgetForAction(binding.qt[key])
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            button.setAccessibleName(binding.qt[key].text())
        self._offer_rest()
        self.offer_tools()

    def _offer_rest(self) -> None:
        """Let it be seen where the rest is when the window is too low for all; the style's own mark is not."""
        self.rest = self.findChild(QToolButton, EXTENSION)
        self.rest.setIcon(icon("dots-horizontal"))
        self.rest.setIconSize(QSize(ICON, ICON))
        self.rest.setToolTip("More")
        self.rest.setAccessibleName("More")

    def offer_tools(self) -> None:
        """Show the tools of the workspace, and those of no other."""
        offered = self._toolbox.offered(self._toolbox.bench.view.state.workspace)
        for tool in self._toolbox.tools:
            self._binding.qt[f"tool.{tool.id}"].setVisible(tool in offered)
