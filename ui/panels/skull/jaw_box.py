"""Which bone is jaw: selected by brush, lasso and connected part, grown and shrunk, and made the jaw in one step."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton, QVBoxLayout, QWidget

from app.actions.context import Context
from app.tools.tool import Bench, Tool
from app.tools.toolbox import ToolBox
from facemodel.face import Skull
from facemodel.mesh import Mesh
from facemodel.painting.regions import grown, shrunk
from facemodel.skull.jaw_region import whole_skull
from fem.types import BoolArray
from ui.panels.skull.bone_box import counted
from ui.panels.skull.deeds import MAKE_HINT, PROPOSE_HINT, make_jaw, propose_jaw, select_jaw
from ui.panels.tissue.brush_box import RADIUS
from ui.panels.tissue.choices import Buttons, Choices
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar

TOOLS = {"bone-brush": "Paint", "bone-lasso": "Lasso", "bone-part": "Part"}


class JawBox(QWidget):
    """Binds the selected bone to words and buttons."""

    def __init__(self, context: Context, toolbox: ToolBox) -> None:
        super().__init__()
        self._context, self._toolbox = context, toolbox
        self._bench: Bench = toolbox.bench
        self.tools = Choices("How bone is selected")
        self.tools.offer(TOOLS)
        self.tools.chosen.connect(toolbox.take)
        self.words = QLabel()
        self.words.setProperty("role", "muted")
        self.words.setWordWrap(True)
        self.radius = NumberBar("Radius", RADIUS)
        self.radius.previewed.connect(lambda value: self._bench.brush.change(radius=value))
        self.mirror = _box("Both sides alike", "Take the other side of the face, too (X)")
        self.mirror.toggled.connect(lambda on: self._bench.brush.change(mirror=on))
        self.through = _box("Through the bone", "Take what is hidden behind other bone, too")
        self.through.toggled.connect(lambda on: self._bench.bones.change(through=on))
        self.lower = _box("Only what lies lower", "Take of a connected part only what lies no higher than the click")
        self.lower.toggled.connect(lambda on: self._bench.bones.change(lower=on))
        self.buttons = Buttons(self._entries(), 3)
        self.make = QPushButton("Make it the jaw")
        self.make.setToolTip(MAKE_HINT)
        self.make.clicked.connect(lambda: make_jaw(context, self._bench))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        for widget in (self.tools, self.words, self.radius, self.mirror, self.through, self.lower, self.buttons):
            layout.addWidget(widget)
        layout.addWidget(self.make)
        self._connect()
        self._show()

    def _entries(self) -> tuple[tuple[str, str, Callable[[], None]], ...]:
        return (
            ("Propose", PROPOSE_HINT, lambda: propose_jaw(self._context, self._bench)),
            ("Jaw", "Select the bone that is jaw now", lambda: select_jaw(self._context, self._bench)),
            ("None", "Select nothing", lambda: self._select(None)),
            ("Grow", "Take in the neighbours of the selection", lambda: self._reshape(grown)),
            ("Shrink", "Leave out the border of the selection", lambda: self._reshape(shrunk)),
            ("Invert", "Select what is not selected", lambda: self._reshape(lambda _mesh, region: ~region)),
        )

    def _connect(self) -> None:
        document = self._context.document
        for signal in (self._bench.bones.changed, document.skull_changed, document.project_changed):
            signal.connect(self._show)
        self._bench.brush.changed.connect(self._show)
        self._toolbox.tool_changed.connect(self._show)

    @property
    def _skull(self) -> Skull:
        return self._context.document.project.face.skull

    def _show(self, *_now: object) -> None:
        selected, whole, tool = self._bench.bones.selected(self._skull), whole_skull(self._skull), self._toolbox.tool
        self.words.setText(_told(selected, whole.jaw))
        self.radius.set_value(self._bench.brush.state.radius)
        hand = self._bench.bones.hand
        for box, on in ((self.mirror, self._bench.brush.state.mirror), (self.through, hand.through)):
            _check(box, on)
        _check(self.lower, hand.lower)
        self._offer(tool)
        for name in ("None", "Grow", "Shrink", "Invert"):
            self.buttons.by_name[name].setEnabled(selected is not None)
        self.buttons.by_name["Jaw"].setEnabled(bool(whole.jaw.any()))
        self.make.setEnabled(selected is not None and not np.array_equal(selected, whole.jaw))

    def _offer(self, tool: Tool) -> None:
        """Press the tool in hand, and show what belongs to it."""
        if tool.id in TOOLS:
            self.tools.press(tool.id)
        else:
            self.tools.release()
        self.radius.setVisible(tool.id == "bone-brush")
        self.through.setVisible(tool.id == "bone-lasso")
        self.lower.setVisible(tool.id == "bone-part")

    def _select(self, vertices: BoolArray | None) -> None:
        self._bench.bones.select(self._skull, vertices)

    def _reshape(self, reshaped: Callable[[Mesh, BoolArray], BoolArray]) -> None:
        selected = self._bench.bones.selected(self._skull)
        if selected is not None:
            self._select(reshaped(whole_skull(self._skull).mesh, selected))


def _told(selected: BoolArray | None, jaw: BoolArray) -> str:
    if selected is None:
        return "Select the bone of the jaw by a tool, or have it proposed."
    count, of = int(selected.sum()), len(selected)
    if np.array_equal(selected, jaw):
        return f"The jaw is selected, {counted(count)} of {counted(of)} vertices."
    return f"{counted(count)} of {counted(of)} vertices selected."


def _box(title: str, tip: str) -> QCheckBox:
    box = QCheckBox(title)
    box.setToolTip(tip)
    return box


def _check(box: QCheckBox, on: bool) -> None:
    box.blockSignals(True)
    box.setChecked(on)
    box.blockSignals(False)
