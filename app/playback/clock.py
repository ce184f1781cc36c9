"""Real time as time of a clip: it never slows, whatever drawing takes."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable

Now = Callable[[], float]
"""Seconds on a clock that never goes back."""

RATE_OVER = 1.0
"""Seconds over which the achieved rate is measured."""

SHARED = 0.05
"""Share of what a sound says about the time that is taken over with each of its reports, so that its coarse reports
(one for each buffer, 20 ms or so) are no stutter; what is off by more than `LOST` is taken over at once."""

LOST = 0.1
"""Seconds."""


class Clock:
    """Where in a clip one is, after it was started at some place.

    Parameters
    ----------
    now : the real clock
    """

    def __init__(self, now: Now = time.perf_counter) -> None:
        self._now = now
        self._begun = now()
        self._from, self._start, self._end, self._loops = 0.0, 0.0, 0.0, False

    def start(self, at: float, start: float, end: float, loops: bool) -> None:
        """Begin at a time; play to an end, and from a start again if it loops."""
        self._begun, self._from = self._now(), at
        self._start, self._end, self._loops = start, end, loops

    @property
    def passed(self) -> float:
        """Seconds played, as if the clip went on for ever."""
        return self._from + self._now() - self._begun

    @property
    def over(self) -> bool:
        """Whether the end was reached for good."""
        return not self._loops and self.passed >= self._end

    @property
    def time(self) -> float:
        """Where it is now, seconds of the clip."""
        passed, length = self.passed, self._end - self._start
        if self._loops and length > 0 and passed > self._end:
            return self._start + (passed - self._start) % length
        return min(passed, self._end)

    def hear(self, heard: float) -> None:
        """Take over what a sound that plays along says about the time of the clip: drawings follow what is heard."""
        off = heard - self.time
        self._from += off if abs(off) > LOST else SHARED * off


class AchievedRate:
    """How many frames were really shown per second.

    Parameters
    ----------
    now : the real clock
    """

    def __init__(self, now: Now = time.perf_counter) -> None:
        self._now = now
        self._shown: deque[float] = deque()
        self.dropped = 0

    def begin(self) -> None:
        """Forget what was."""
        self._shown.clear()
        self.dropped = 0

    def frame(self, skipped: int) -> None:
        """Note that a frame is shown, and how many before it were not."""
        moment = self._now()
        self._shown.append(moment)
        self.dropped += max(skipped, 0)
        while moment - self._shown[0] > RATE_OVER:
            self._shown.popleft()

    @property
    def rate(self) -> float | None:
        """Frames per second over the last second; none before two were shown."""
        if len(self._shown) < 2 or self._shown[-1] <= self._shown[0]:
            return None
        return (len(self._shown) - 1) / (self._shown[-1] - self._shown[0])
