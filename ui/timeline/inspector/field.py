"""A field that reads a number off the animation and writes it back: a drag of it is one step, Esc takes it back."""

from __future__ import annotations

from dataclasses import dataclass

from app.timeline.readings import Read, Write
from app.timeline.timeline import LiveChange, Timeline
from facemodel.animation.timecode import TimeStyle, written
from facemodel.errors import RisoriusError
from ui.timeline.time_field import time_from
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale


class FieldBar(NumberBar):
    """One number of what is chosen.

    Parameters
    ----------
    timeline : what is read and changed
    label : for people; it is also what the step is called
    scale : range and unit
    read, write : what it says, and what another number does
    """

    def __init__(self, timeline: Timeline, label: str, scale: NumberScale, read: Read, write: Write) -> None:
        super().__init__(label, scale)
        self._timeline = timeline
        self._read_from, self._write_to = read, write
        self._live: LiveChange | None = None
        self.previewed.connect(self._propose)
        self.committed.connect(self._keep)
        self.cancelled.connect(self._take_back)
        self.refresh()

    def refresh(self) -> None:
        """Say what is so now; without anything to say it is off."""
        reading = self._read_from(self._timeline.animation, self._timeline.chosen)
        self.setEnabled(reading is not None)
        if reading is not None and not self.held:
            self.set_value(reading.value, reading.mixed)

    def _propose(self, value: float) -> None:
        if self._live is None:
            self._live = LiveChange(self._timeline, self.label)
        try:
            self._live.show(*self._write_to(self._live.base, self._live.chosen, value))
        except RisoriusError:
            self._take_back()

    def _keep(self) -> None:
        self._live = None
        self.refresh()

    def _take_back(self) -> None:
        live, self._live = self._live, None
        if live is not None:
            live.cancel()


@dataclass(frozen=True)
class TimeNumbers(NumberScale):
    """Seconds, written as times are.

    Attributes
    ----------
    rate : frames per second
    style : how times are written
    """

    rate: float = 30.0
    style: TimeStyle = "timecode"

    def text(self, value: float) -> str:
        """The time as it is written everywhere else."""
        return written(value, self.rate, self.style)

    def rounded(self, value: float, finer: int = 0) -> float:
        """On a frame, or with Shift where it is."""
        return self.clamped(value if finer else round(value * self.rate) / self.rate)


class TimeBar(FieldBar):
    """A moment, typed as frames, seconds or timecode."""

    def __init__(self, timeline: Timeline, label: str, read: Read, write: Write) -> None:
        animation, state = timeline.animation, timeline.state
        most = max(animation.end, 1.0) * 2.0
        super().__init__(
            timeline, label, TimeNumbers(0.0, most, 0.0, rate=timeline.rate, style=state.style), read, write
        )

    def _read(self, text: str) -> float:
        return time_from(text, self._timeline)

    def _written(self) -> str:
        return self.scale.text(self._value)
