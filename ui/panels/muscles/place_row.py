"""A place as numbers: its name, and x, y and z in millimetres."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from fem.types import FloatArray
from ui.theme.metrics import GRID
from ui.widgets.coordinate_bar import CoordinateBar

CAPTION = 10 * GRID


class PlaceRow(QWidget):
    """Shows one place and lets a hand change its coordinates.

    Signals
    -------
    previewed(object) : (3,) the place while it is being changed
    committed(), cancelled() : the change is over and stays, or is taken back
    """

    previewed = Signal(object)
    committed = Signal()
    cancelled = Signal()

    def __init__(self, caption: str, hint: str, button: QToolButton | None = None) -> None:
        super().__init__()
        self._place: FloatArray = np.zeros(3)
        self.bars = tuple(CoordinateBar(axis) for axis in "xyz")
        words = QLabel(caption)
        words.setProperty("role", "muted")
        words.setFixedWidth(CAPTION)
        words.setToolTip(hint)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addWidget(words)
        for number, bar in enumerate(self.bars):
            bar.setAccessibleName(f"{caption} {bar.label}")
            bar.setToolTip(f"{hint}<br>x to the subject’s left, y up, z forward, mm · double-click types")
            bar.previewed.connect(lambda value, number=number: self._tell(number, value))
            bar.committed.connect(self.committed)
            bar.cancelled.connect(self.cancelled)
            layout.addWidget(bar, 1)
        if button is not None:
            layout.addWidget(button)

    @property
    def held(self) -> bool:
        """Whether a hand is changing it."""
        return any(bar.held for bar in self.bars)

    def show_place(self, place: FloatArray) -> None:
        """Show where it is, unless a hand is changing it."""
        if not self.held:
            self._place = np.array(place, dtype=np.float64)
            for bar, value in zip(self.bars, self._place, strict=True):
                bar.set_value(float(value))

    def _tell(self, number: int, value: float) -> None:
        place = self._place.copy()
        place[number] = value
        self.previewed.emit(place)
