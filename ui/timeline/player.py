"""Keeps a playhead going while it plays: as often as the viewport can draw, and never ahead of it."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QObject, Qt, QTimer

from app.playback.playhead import Playhead

LOOKS = 4
"""How often within a frame the clock is looked at, so that a frame is at most a quarter of its length late."""

PATIENCE = 0.25
"""Seconds after which it goes on although nothing was drawn: the window may be hidden."""


class Player(QObject):
    """Ticks a playhead.

    Parameters
    ----------
    playhead : what plays
    rate : frames per second of the clip, now
    drawn : how many frames the viewport has drawn so far
    sounds : brings the playhead to where a sound that plays along is; whether pictures may go on
    """

    def __init__(
        self,
        playhead: Playhead,
        rate: Callable[[], float],
        drawn: Callable[[], int],
        sounds: Callable[[], bool],
    ) -> None:
        super().__init__()
        self._sounds = sounds
        self._playhead, self._rate, self._drawn = playhead, rate, drawn
        self._waits_for, self._since = -1, 0.0
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        playhead.playing_changed.connect(self._follow)

    def _follow(self, playing: bool) -> None:
        if playing:
            self._waits_for = -1
            self._timer.start(max(round(1000.0 / self._rate() / LOOKS), 1))
        else:
            self._timer.stop()

    def _tick(self) -> None:
        """Show the next frame once the last one was drawn."""
        now = time.perf_counter()
        if not self._sounds():
            return
        if self._drawn() <= self._waits_for and now - self._since < PATIENCE:
            return
        before = self._playhead.time
        if self._playhead.tick() and self._playhead.time != before:
            self._waits_for, self._since = self._drawn(), now
