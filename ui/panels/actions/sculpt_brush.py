"""The brush that sculpts: what it does to the skin, how large, strong and hard."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtWidgets import QCheckBox, QVBoxLayout, QWidget

from app.tools.brush_state import SMALLEST_RADIUS
from app.tools.sculpt_state import SculptState
from app.tools.toolbox import ToolBox
from facemodel.painting.brush import LARGEST_RADIUS
from facemodel.sculpting.brush import SCULPT_MODES, SCULPT_TITLES, SculptMode
from ui.panels.tissue.choices import Choices
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

RADIUS = NumberScale(SMALLEST_RADIUS, LARGEST_RADIUS, SculptState().radius, "mm", bend=2.5)
STRENGTH = NumberScale(0, 100, 100, "%", whole=True)
HARDNESS = NumberScale(0, 100, 0, "%", whole=True)

MODE_TIPS: Mapping[SculptMode, str] = {
    "pull": "Take hold of the skin and drag it along",
    "raise": "Raise the skin along its normal, up to a millimetre a stroke; hold Ctrl to lower it",
    "smooth": "Even out the whole field of the unit; any brush does while Shift is held",
    "pinch": "Gather the skin towards the brush; hold Ctrl to spread it",
    "erase": "Take off what is sculpted; what is solved stays",
}


class SculptBrushBox(QWidget):
    """Binds the brush that sculpts to fields, both ways; to choose what it does takes it in hand."""

    def __init__(self, toolbox: ToolBox) -> None:
        super().__init__()
        self._toolbox = toolbox
        brush = self._brush = toolbox.bench.sculpt
        self.modes = Choices("What the brush does to the skin")
        self.modes.offer(SCULPT_TITLES)
        for mode in SCULPT_MODES:
            self.modes.button(mode).setToolTip(f"{MODE_TIPS[mode]} (S takes the brush)")
        self.radius = NumberBar("Radius", RADIUS)
        self.strength = NumberBar("Strength", STRENGTH)
        self.hardness = NumberBar("Hardness", HARDNESS)
        self.mirror = QCheckBox("Mirror across the midline")
        self.mirror.setToolTip("Sculpt both sides of the face alike (X)")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GRID // 2)
        for widget in (self.modes, self.radius, self.strength, self.hardness, self.mirror):
            layout.addWidget(widget)
        self.modes.chosen.connect(self._take)
        self.radius.previewed.connect(lambda value: brush.change(radius=value))
        self.strength.previewed.connect(lambda value: brush.set_strength(value / 100))
        self.hardness.previewed.connect(lambda value: brush.change(hardness=value / 100))
        self.mirror.toggled.connect(lambda on: brush.change(mirror=on))
        brush.changed.connect(lambda _now, _before: self._show())
        toolbox.tool_changed.connect(lambda _tool: self._show())
        self._show()

    def _take(self, mode: str) -> None:
        self._brush.change(mode=mode)
        self._toolbox.take("sculpt")

    def _show(self) -> None:
        state = self._brush.state
        self.modes.press(state.mode if self._toolbox.tool.id == "sculpt" else "")
        self.radius.set_value(state.radius)
        self.strength.set_value(100 * state.strength)
        self.hardness.set_value(100 * state.hardness)
        self.mirror.blockSignals(True)
        self.mirror.setChecked(state.mirror)
        self.mirror.blockSignals(False)
