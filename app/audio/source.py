"""The sound of a clip, sample by sample as it is played: silence where there is none, a loop from its start again."""

from __future__ import annotations

import time
from threading import Lock

import numpy as np

from app.playback.clock import Now
from facemodel.animation.sound import Sound
from fem.types import Float32Array

MOST_CHANNELS = 2
"""Loudspeakers; of a recording with more channels all are heard from both."""


class Source:
    """Hands out samples in the order of time.  It may be asked in another thread than it is told to go elsewhere.

    Parameters
    ----------
    sound : what is heard
    begins : when it begins in the clip, seconds
    span : what is played of the clip, seconds
    loops : whether it begins anew at the end
    now : the real clock

    Attributes
    ----------
    handed : samples that were handed out since it was made
    """

    def __init__(
        self,
        sound: Sound,
        begins: float,
        span: tuple[float, float],
        loops: bool,
        now: Now = time.perf_counter,
    ) -> None:
        samples = sound.samples
        if samples.shape[1] > MOST_CHANNELS:
            samples = np.repeat(samples.mean(axis=1, keepdims=True, dtype=np.float32), MOST_CHANNELS, axis=1)
        self.rate, self._samples = sound.rate, samples
        self._first = round(begins * sound.rate)
        self._start, self._end = round(span[0] * sound.rate), max(round(span[1] * sound.rate), 1)
        self._loops = loops and self._end > self._start
        self._lock = Lock()
        self._at = self._start
        self.handed = 0
        self._now, self._asked, self._count = now, now(), 0

    @property
    def channels(self) -> int:
        """How many loudspeakers it is for."""
        return int(self._samples.shape[1])

    def seek(self, seconds: float) -> None:
        """Go on from a time of the clip."""
        with self._lock:
            self._at = round(seconds * self.rate)

    def heard(self, waiting: int) -> float:
        """The time of the clip that is heard now.

        Parameters
        ----------
        waiting : samples that were handed over and not heard yet when samples were asked for last
        """
        with self._lock:
            gone = min(round((self._now() - self._asked) * self.rate), self._count)
            return self._wrapped(self._at - waiting + gone) / self.rate

    def read(self, count: int) -> Float32Array:
        """The next samples (count, channels)."""
        found = np.zeros((count, self.channels), dtype=np.float32)
        with self._lock:
            done = 0
            while done < count:
                room = count - done
                if self._loops and self._at < self._end:
                    room = min(room, self._end - self._at)
                found[done : done + room] = self._piece(self._at, room)
                self._at += room
                done += room
                if self._loops and self._at >= self._end:
                    self._at = self._start
            self.handed += count
            self._asked, self._count = self._now(), count
        return found

    def _piece(self, at: int, count: int) -> Float32Array:
        """Samples from a place of the clip on; nothing is heard before the sound and behind it, and behind the end."""
        piece = np.zeros((count, self.channels), dtype=np.float32)
        begin = at - self._first
        stop = min(begin + count, len(self._samples), self._end - self._first)
        first = max(begin, 0)
        if stop > first:
            piece[first - begin : stop - begin] = self._samples[first:stop]
        return piece

    def _wrapped(self, at: int) -> int:
        if self._loops and at < self._start:
            return self._end - (self._start - at) % (self._end - self._start)
        return at
