"""When a face that was recorded as landmarks was at rest: a time to be typed, dragged, or taken from the playhead."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QWidget

from ui.theme.metrics import GRID
from ui.timeline.inspector.page import push_button
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale


class RestRow(QWidget):
    """Asks for the moment of rest.

    Signals
    -------
    looked(float) : seconds of the recording that are considered, while the hand goes through them
    chosen(float) : seconds of the recording that are settled on
    at_playhead() : what is seen now is asked for

    Parameters
    ----------
    duration : seconds of the recording
    rest : the moment that was found
    """

    looked = Signal(float)
    chosen = Signal(float)
    at_playhead = Signal()

    def __init__(self, duration: float, rest: float) -> None:
        super().__init__()
        self.bar = NumberBar("Face at rest at", NumberScale(0.0, duration, rest, "s"))
        self.bar.set_value(rest)
        self.bar.setToolTip("The moment of the recording that is compared with the face at rest")
        self.here = push_button("At the playhead", self.at_playhead.emit, "The face as it is seen now was at rest")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(GRID)
        row.addWidget(self.bar, 1)
        row.addWidget(self.here)
        self.bar.previewed.connect(self.looked)
        self.bar.committed.connect(lambda: self.chosen.emit(self.bar.value))

    def choose(self, seconds: float) -> None:
        """Settle on a moment, or on the end that lies nearest to it."""
        scale = self.bar.scale
        self.bar.set_value(min(max(seconds, scale.least), scale.most))
        self.chosen.emit(self.bar.value)
