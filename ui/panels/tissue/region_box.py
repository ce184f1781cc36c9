"""The region in hand: what is selected and locked, and what can be done to it as a whole."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from app.tools.brush_state import BrushState
from app.tools.fill import fill
from app.tools.tool import Bench
from facemodel.errors import RisoriusError
from facemodel.face import Face
from facemodel.painting.brush import MODES
from facemodel.painting.regions import grown, shrunk
from fem.types import BoolArray
from ui.panels.tissue.choices import Buttons
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

TOLERANCE = NumberScale(0, 100, 100 * BrushState().tolerance, "%", whole=True)


class RegionBox(QWidget):
    """Selects, locks, fills and evens out regions of the skin.

    Parameters
    ----------
    bench : brush and regions
    complain : told a sentence when something cannot be done
    """

    def __init__(self, bench: Bench, complain: Callable[[str], None]) -> None:
        super().__init__()
        self._bench, self._complain = bench, complain
        self.words = QLabel()
        self.words.setProperty("role", "muted")
        self.words.setWordWrap(True)
        self.selecting = Buttons(
            (
                ("All", "Select the whole face", self._select_all),
                ("Invert", "Select what is not selected", self._invert),
                ("None", "Select nothing", lambda: self._select(None)),
                ("Grow", "Take in the neighbours of the selection", lambda: self._reshape(grown)),
                ("Shrink", "Leave out the border of the selection", lambda: self._reshape(shrunk)),
                ("Lock", "Keep the selection from being painted", self._lock),
            ),
            3,
        )
        self.filling = Buttons(
            (
                ("Fill", "Do to the selection, or to the whole face, what the brush does", self._fill),
                ("Smooth", "Even out the selection, or the whole face", self._smooth),
                ("Unlock all", "Let everything be painted again", lambda: bench.regions.lock(self._face, None)),
            ),
            3,
        )
        self.tolerance = NumberBar("Fill tolerance", TOLERANCE)
        self.tolerance.setToolTip("Share of the layer's range within which the fill tool goes on")
        self.tolerance.previewed.connect(lambda value: bench.brush.change(tolerance=value / 100))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        for widget in (self.words, self.selecting, self.filling, self.tolerance):
            layout.addWidget(widget)
        bench.regions.changed.connect(self._show)
        bench.document.project_changed.connect(self._show)
        bench.brush.changed.connect(self._show)
        self._show()

    @property
    def _face(self) -> Face:
        return self._bench.document.project.face

    def _show(self, *_now: object) -> None:
        selected, locked = self._bench.regions.selected(self._face), self._bench.regions.locked(self._face)
        said = "Draw around a region with the lasso (Shift+B)." if selected is None else _count(selected, "selected")
        self.words.setText(said if locked is None else f"{said} {_count(locked, 'locked')}")
        for name in ("Invert", "None", "Grow", "Shrink", "Lock"):
            self.selecting.by_name[name].setEnabled(selected is not None)
        self.filling.by_name["Unlock all"].setEnabled(locked is not None)
        kinds = MODES[self._bench.brush.state.paint_layer.kind]
        self.filling.by_name["Smooth"].setEnabled("smooth" in kinds)
        self.filling.by_name["Fill"].setEnabled(self._bench.brush.state.mode != "comb")
        self.tolerance.set_value(100 * self._bench.brush.state.tolerance)

    def _select(self, vertices: BoolArray | None) -> None:
        self._bench.regions.select(self._face, vertices)

    def _select_all(self) -> None:
        self._select(_solved(self._face))

    def _invert(self) -> None:
        selected = self._bench.regions.selected(self._face)
        if selected is not None:
            self._select(_solved(self._face) & ~selected)

    def _reshape(self, reshaped: Callable[..., BoolArray]) -> None:
        selected = self._bench.regions.selected(self._face)
        if selected is not None:
            self._select(reshaped(self._face.skin, selected))

    def _lock(self) -> None:
        """What is selected is locked with what is so already, and no longer selected."""
        selected, locked = self._bench.regions.selected(self._face), self._bench.regions.locked(self._face)
        if selected is not None:
            self._bench.regions.lock(self._face, selected if locked is None else selected | locked)
            self._select(None)

    def _fill(self) -> None:
        self._do(self._bench.brush.state)

    def _smooth(self) -> None:
        state = self._bench.brush.state
        self._do(replace(state, modes={**state.modes, state.layer: "smooth"}))

    def _do(self, state: BrushState) -> None:
        selected = self._bench.regions.selected(self._face)
        try:
            fill(self._bench, _solved(self._face) if selected is None else selected, state)
        except RisoriusError as error:
            self._complain(str(error))


def _solved(face: Face) -> BoolArray:
    """The vertices (N,) of the part of the skin that moves."""
    found = np.zeros(len(face.skin.positions), dtype=np.bool_)
    found[face.skin.triangles[face.solved]] = True
    return found


def _count(region: BoolArray, word: str) -> str:
    number = int(region.sum())
    return f"{number} {'vertex' if number == 1 else 'vertices'} {word}."
