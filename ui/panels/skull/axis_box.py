"""The axis of the jaw in numbers, and its turn to be looked at without a change of the project."""

from __future__ import annotations

import numpy as np
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from app.actions.context import Context
from app.authoring.jaw import with_jaw_axis
from app.tools.tool import Bench
from app.view_state import ViewState
from facemodel.errors import RisoriusError
from facemodel.laying.places import middle_plane
from fem.types import FloatArray
from ui.panels.skull.triple_row import TripleRow
from ui.theme.metrics import GRID
from ui.widgets.coordinate_bar import SLOW, WIDE
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

PLACE = NumberScale(-WIDE, WIDE, 0.0, "mm")
OPEN = NumberScale(0.0, 30.0, 0.0, "°")
"""A jaw opens by some thirty degrees."""

SLIDE = NumberScale(0.0, 15.0, 0.0, "mm")
"""A condyle slides forward by a centimetre and a half at most."""

SIDE = NumberScale(-12.0, 12.0, 0.0, "mm")
"""Incisors go aside by a centimetre or so."""

LABEL = "Place the jaw’s axis"
TIP = "Where this end of the axis is in the head, millimetres: x to the subject's left, y up, z forward"


class AxisBox(QWidget):
    """Binds both ends of the axis and the turn that is tried to bars."""

    def __init__(self, context: Context, bench: Bench) -> None:
        super().__init__()
        self._context, self._bench = context, bench
        self._axis: FloatArray | None = None
        self.ends = (TripleRow("Right", PLACE, SLOW, TIP), TripleRow("Left", PLACE, SLOW, TIP))
        self.words = QLabel()
        self.words.setProperty("role", "muted")
        self.words.setWordWrap(True)
        self.open = NumberBar("Try to open", OPEN)
        self.open.setToolTip("Turn the jaw about its axis only to look at it; nothing of the project changes")
        self.slide = NumberBar("Try to slide", SLIDE)
        self.slide.setToolTip("Slide the condyles forward and down only to look at it; nothing of the project changes")
        self.side = NumberBar("Try to go aside", SIDE)
        self.side.setToolTip("Take the incisors to the left (+) or right only to look at it; nothing else changes")
        self.trial = {"jaw_open": self.open, "jaw_slide": self.slide, "jaw_side": self.side}
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        for widget in (*self.ends, self.words, *self.trial.values()):
            layout.addWidget(widget)
        self._connect()
        self._show_axis(None)
        self._show_trial(context.view.state)

    def _connect(self) -> None:
        view, document = self._context.view, self._context.document
        for end, row in enumerate(self.ends):
            row.previewed.connect(lambda axis, value, end=end: self._preview(end, axis, value))
            row.committed.connect(self._keep)
            row.cancelled.connect(self._let_go)
        for name, bar in self.trial.items():
            bar.previewed.connect(lambda value, name=name: view.change(**{name: value}))
            bar.cancelled.connect(lambda name=name, bar=bar: view.change(**{name: bar.value}))
        view.changed.connect(self._show_trial)
        document.project_changed.connect(lambda *_now: self._show_axis(self._axis))
        document.skull_changed.connect(lambda *_now: self._show_axis(self._axis))
        self._bench.sight.axis_changed.connect(self._show_axis)

    def _show_trial(self, state: ViewState, *_before: object) -> None:
        for name, bar in self.trial.items():
            if not bar.held:
                bar.set_value(getattr(state, name))

    @property
    def _own(self) -> FloatArray:
        return self._context.document.project.face.skull.jaw.axis

    def _show_axis(self, axis: FloatArray | None) -> None:
        """The numbers of an axis in the hand, or of the one that the project has."""
        right, left = self._own if axis is None else axis
        for row, end in zip(self.ends, (right, left), strict=True):
            row.show_values(tuple(float(number) for number in end))
        self.words.setText(told(right, left))

    def _preview(self, end: int, axis: int, value: float) -> None:
        """The axis goes along with the number, and its other end alike where both sides are."""
        start = self._own if self._axis is None else self._axis
        moved = start.copy()
        moved[end, axis] = value
        if self._bench.brush.state.mirror:
            across = middle_plane(self._context.document.project.face)[1]
            way = moved[end] - start[end]
            moved[1 - end] += way - 2 * (way @ across) * across
        self._axis = moved
        self._bench.sight.axis_changed.emit(moved)

    def _keep(self) -> None:
        axis, self._axis = self._axis, None
        if axis is not None:
            document = self._context.document
            try:
                document.edit(with_jaw_axis(document.project, *axis), LABEL)
            except RisoriusError as error:
                self._context.host.show_error(str(error))
        self._bench.sight.axis_changed.emit(None)

    def _let_go(self) -> None:
        self._axis = None
        self._bench.sight.axis_changed.emit(None)


def told(right: FloatArray, left: FloatArray) -> str:
    """The length of an axis and how it lies: tilted in the picture from the front, turned in the one from above."""
    x, y, z = left - right
    tilted, turned = np.round(np.degrees([np.arctan2(y, x), np.arctan2(z, x)]), 1) + 0.0
    return f"{np.linalg.norm(left - right):.1f} mm long, tilted {tilted:.1f}°, turned {turned:.1f}°."
