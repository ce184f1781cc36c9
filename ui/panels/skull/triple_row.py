"""Three numbers of one kind in a row, one for each axis."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from ui.theme.metrics import GRID
from ui.widgets.axis_bar import AxisBar
from ui.widgets.number_scale import NumberScale

NAME = 5 * GRID
"""Width of the name of a row."""


class TripleRow(QWidget):
    """A name and the bars x, y and z.

    Signals
    -------
    previewed(int, float) : an axis and its number while it is being changed
    committed() : the change is over and stays
    cancelled() : the change is over and is taken back
    """

    previewed = Signal(int, float)
    committed = Signal()
    cancelled = Signal()

    def __init__(self, title: str, scale: NumberScale, slow: float, tip: str) -> None:
        super().__init__()
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GRID // 2)
        name = QLabel(title)
        name.setProperty("role", "muted")
        name.setFixedWidth(NAME)
        layout.addWidget(name)
        self.bars = tuple(AxisBar(axis, scale, slow) for axis in "xyz")
        for axis, bar in enumerate(self.bars):
            bar.setToolTip(tip)
            bar.setAccessibleName(f"{title} {bar.label}")
            bar.previewed.connect(lambda value, axis=axis: self.previewed.emit(axis, value))
            bar.committed.connect(self.committed)
            bar.cancelled.connect(self.cancelled)
            layout.addWidget(bar, 1)

    @property
    def held(self) -> bool:
        """Whether a hand is changing one of them."""
        return any(bar.held for bar in self.bars)

    def show_values(self, values: tuple[float, ...]) -> None:
        """Show three numbers, except where the hand is."""
        for bar, value in zip(self.bars, values, strict=True):
            if not bar.held:
                bar.set_value(value)
