"""The brush: what it does to the layer in hand, with which value, how large, strong and hard."""

from __future__ import annotations

from PySide6.QtWidgets import QCheckBox, QVBoxLayout, QWidget

from app.tools.brush_state import SMALLEST_RADIUS, BrushState, HandBrush, usual_value
from facemodel.painting.brush import LARGEST_RADIUS, MODES, Mode
from facemodel.painting.layers import SUPPORT_TITLES, PaintLayer
from ui.panels.tissue.choices import Choices
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

MODE_TITLES: dict[Mode, str] = {
    "set": "Set",
    "add": "Add",
    "scale": "Scale",
    "smooth": "Smooth",
    "comb": "Comb",
    "erase": "Erase",
}

MODE_TIPS: dict[Mode, str] = {
    "set": "Bring what is painted to the value",
    "add": "Add the value; hold Ctrl to take it away",
    "scale": "Multiply by the factor; hold Ctrl to divide",
    "smooth": "Even out; any brush does while Shift is held",
    "comb": "Lay the grain along the stroke",
    "erase": "Bring back what nobody has painted; hold Ctrl while setting",
}

LARGEST_FACTOR = 4.0
SUPPORT_WORDS = {"Free": "Free", "Held in place": "Held", "Held in place and slope": "Clamped"}

RADIUS = NumberScale(SMALLEST_RADIUS, LARGEST_RADIUS, BrushState().radius, "mm", bend=2.5)
STRENGTH = NumberScale(0, 100, 100 * BrushState().strength, "%", whole=True)
HARDNESS = NumberScale(0, 100, 100 * BrushState().hardness, "%", whole=True)


class BrushBox(QWidget):
    """Binds the brush in the hand to fields, both ways."""

    def __init__(self, brush: HandBrush) -> None:
        super().__init__()
        self._brush = brush
        self.modes = Choices("What the brush does")
        self.kinds = Choices("Support that is painted")
        self.value = NumberBar("Value", NumberScale(0, 1, 0))
        self.radius = NumberBar("Radius", RADIUS)
        self.strength = NumberBar("Strength", STRENGTH)
        self.hardness = NumberBar("Hardness", HARDNESS)
        self.mirror = QCheckBox("Mirror across the midline")
        self.mirror.setToolTip("Paint both sides of the face alike (X)")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        for widget in (self.modes, self.kinds, self.value, self.radius, self.strength, self.hardness, self.mirror):
            layout.addWidget(widget)
        self._connect()
        self._show(brush.state)

    def _connect(self) -> None:
        brush = self._brush
        self.modes.chosen.connect(brush.set_mode)
        self.kinds.chosen.connect(lambda key: brush.set_value(float(key)))
        self.value.previewed.connect(brush.set_value)
        self.radius.previewed.connect(lambda value: brush.change(radius=value))
        self.strength.previewed.connect(lambda value: brush.change(strength=value / 100))
        self.hardness.previewed.connect(lambda value: brush.change(hardness=value / 100))
        self.mirror.toggled.connect(lambda on: brush.change(mirror=on))
        brush.changed.connect(lambda now, _before: self._show(now))

    def _show(self, state: BrushState) -> None:
        layer, choice = state.paint_layer, state.paint_layer.kind == "choice"
        self.modes.offer({mode: MODE_TITLES[mode] for mode in MODES[layer.kind]})
        for mode in MODES[layer.kind]:
            self.modes.button(mode).setToolTip(MODE_TIPS[mode])
        self.modes.press(state.mode)
        self.modes.setVisible(not choice)
        self.kinds.setVisible(choice)
        if choice:
            self.kinds.offer({str(int(kind)): _word(title) for kind, title in SUPPORT_TITLES.items()})
            for kind, title in SUPPORT_TITLES.items():
                self.kinds.button(str(int(kind))).setToolTip(title)
            self.kinds.press(str(int(state.value)))
        self._show_value(layer, state)
        self.radius.set_value(state.radius)
        self.strength.set_value(100 * state.strength)
        self.hardness.set_value(100 * state.hardness)
        self.strength.setEnabled(not choice)
        self.hardness.setEnabled(not choice)
        self.mirror.blockSignals(True)
        self.mirror.setChecked(state.mirror)
        self.mirror.blockSignals(False)

    def _show_value(self, layer: PaintLayer, state: BrushState) -> None:
        self.value.setVisible(layer.kind != "choice" and state.mode in ("set", "add", "scale"))
        scale = value_scale(layer, state.mode)
        if scale != self.value.scale and not self.value.held:
            self.value.scale = scale
            self.value.label = "Factor" if state.mode == "scale" else "Angle" if layer.kind == "angle" else "Value"
        self.value.set_value(state.value)
        self.value.update()


def value_scale(layer: PaintLayer, mode: Mode) -> NumberScale:
    """The range of what is painted on a layer in a mode."""
    usual = usual_value(layer, mode)
    if mode == "scale":
        return NumberScale(0, LARGEST_FACTOR, usual, "×")
    if layer.kind == "angle":
        return NumberScale(-90, 90, usual, layer.unit)
    # What is usual lies near the soft end of the range: it gets more room.
    return NumberScale(layer.low, layer.high, usual, layer.unit, bend=2.0)


def _word(title: str) -> str:
    return SUPPORT_WORDS.get(title, title.split()[0])
