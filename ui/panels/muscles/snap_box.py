"""Where what a hand drags comes to lie: on vertices, anywhere on the surface, or where it is let go."""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox, QHBoxLayout, QWidget

from app.tools.muscle_hand import MuscleHand
from app.tools.toolbox import ToolBox
from facemodel.laying.places import Snap
from ui.theme.metrics import GRID
from ui.widgets.narrow_choice import narrow_choice

BONE: dict[Snap, str] = {"surface": "Origins on the bone", "vertex": "Origins on vertices", "free": "Origins free"}
SKIN: dict[Snap, str] = {
    "vertex": "Ends on vertices",
    "surface": "Ends along the skin",
    "free": "Ends free",
}


class SnapBox(QWidget):
    """Two choices, shown while a tool that lays muscles is in hand; all such tools do alike."""

    def __init__(self, toolbox: ToolBox) -> None:
        super().__init__()
        self._toolbox = toolbox
        self._hands = [tool for tool in toolbox.tools if isinstance(tool, MuscleHand)]
        self.bone = _choice(BONE, "Origins", "What origins of fibres snap to while they are dragged")
        self.skin = _choice(SKIN, "Attachments", "What attachments of fibres snap to while they are dragged")
        self.bone.activated.connect(lambda _row: self._take())
        self.skin.activated.connect(lambda _row: self._take())
        line = QHBoxLayout(self)
        line.setContentsMargins(GRID, 0, GRID, 0)
        line.setSpacing(GRID // 2)
        line.addWidget(self.bone, 1)
        line.addWidget(self.skin, 1)
        toolbox.tool_changed.connect(self._follow)
        self._follow(toolbox.tool)

    def _take(self) -> None:
        for hand in self._hands:
            hand.bone_snap, hand.skin_snap = self.bone.currentData(), self.skin.currentData()

    def _follow(self, tool: object) -> None:
        self.setVisible(isinstance(tool, MuscleHand))


def _choice(titles: dict[Snap, str], name: str, hint: str) -> QComboBox:
    box = narrow_choice(name, hint)
    for snap, title in titles.items():
        box.addItem(title, snap)
    return box
