"""Which frames are exported."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QWidget

from facemodel.animation.clip import FASTEST, SLOWEST, Animation
from ui.panels.export.form import Form, choice, choose
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

PLAYED, OWN = "played", "own"
ROOM = 10.0
"""Seconds behind the last thing of a clip up to which a range may go."""


class FramesBox(QWidget):
    """The range and the rate.

    Signals
    -------
    changed() : something else is chosen
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.range = choice("Range", {})
        self.first = NumberBar("From", NumberScale(0.0, 1.0, 0.0, "s"))
        self.last = NumberBar("To", NumberScale(0.0, 1.0, 1.0, "s"))
        self.rate = NumberBar("Frames a second", NumberScale(SLOWEST, FASTEST, 30.0))
        self._spans: dict[str, tuple[float, float]] = {}
        self._rate_of = 0.0
        form = Form()
        form.head("Frames")
        form.row("Range", self.range)
        form.row("", self.first, self.last)
        form.row("Rate", self.rate)
        self.setLayout(form)
        self.range.activated.connect(self._take_range)
        for bar in (self.first, self.last):
            bar.previewed.connect(self._note_own)
        self.rate.previewed.connect(lambda _value: self.changed.emit())

    @property
    def span(self) -> tuple[float, float]:
        """From when to when, seconds."""
        return self.first.value, self.last.value

    def follow(self, animation: Animation) -> None:
        """Offer the ranges of an animation; what was chosen stays chosen if it is still there."""
        chosen = self.range.currentData() or PLAYED
        self._spans = {PLAYED: (animation.start, animation.end)}
        self._spans |= {f"range {each.name}": (each.start, each.end) for each in animation.ranges}
        with QSignalBlocker(self.range):
            self.range.clear()
            self.range.addItem("What is played", PLAYED)
            for each in animation.ranges:
                self.range.addItem(each.name, f"range {each.name}")
            self.range.addItem("Own range", OWN)
            choose(self.range, chosen)
        low = min(start for start, _ in self._spans.values())
        high = max(end for _, end in self._spans.values())
        for bar, value in ((self.first, animation.start), (self.last, animation.end)):
            bar.scale = NumberScale(min(low, 0.0), high + ROOM, value, "s")
        if animation.rate != self._rate_of:
            self._rate_of = animation.rate
            self.rate.scale = NumberScale(SLOWEST, FASTEST, animation.rate)
            self.rate.set_value(animation.rate)
        self._take_range()

    def _take_range(self, _index: int = 0) -> None:
        span = self._spans.get(self.range.currentData())
        if span is not None:
            self.first.set_value(span[0])
            self.last.set_value(span[1])
        self.changed.emit()

    def _note_own(self, _value: float) -> None:
        choose(self.range, OWN)
        self.changed.emit()
