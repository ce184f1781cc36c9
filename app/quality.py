"""How finely the face is drawn: three levels, and the automatic choice among them by how long frames take."""

from __future__ import annotations

from collections import deque
from statistics import median
from typing import Literal

from facemodel.errors import FaceError, UnknownNameError

Level = Literal["fast", "balanced", "full"]

Quality = Literal["automatic", "fast", "balanced", "full"]
"""What a person may ask for."""

LEVELS: tuple[Level, ...] = ("fast", "balanced", "full")
"""The coarsest and quickest first."""

QUALITY_TITLES: dict[Quality, str] = {
    "automatic": "Automatic",
    "full": "Full",
    "balanced": "Balanced",
    "fast": "Fast",
}

FLUID = 24.0
"""Frames a second from which motion is seen as motion: the rate of film."""
SLOWEST, QUICKEST = 1.0, 1000.0
"""Frames a second that can be asked for at least."""

FRAMES = 6
"""Frames in a row that are judged by the middle one of their times: a single slow one is no reason."""
COMFORT = 0.5
"""Share of the time per frame that the better level may take, as measured, before it is chosen again: what is only
just quick enough would go to and fro."""
PART = 0.3
"""Share of the time per frame that drawing must take to be blamed: a coarser picture does not help slow posing."""
TRIES = 2
"""Times that a level is found too slow before it is not tried again."""
PATIENCE = 400.0
"""Milliseconds that the picture of a resting face may take; the hand would be kept waiting by a longer one."""


def coarser(level: Level) -> Level:
    """The next level down; the coarsest stays."""
    return LEVELS[max(LEVELS.index(level) - 1, 0)]


def finer(level: Level) -> Level:
    """The next level up; the finest stays."""
    return LEVELS[min(LEVELS.index(level) + 1, len(LEVELS) - 1)]


def finest(*levels: Level) -> Level:
    """The finest of some levels."""
    return max(levels, key=LEVELS.index)


def checked_quality(quality: str, rate: float) -> tuple[Quality, float]:
    """A quality and the frames a second that it is to keep at least.

    Raises
    ------
    UnknownNameError
        If there is no such quality.
    FaceError
        If no motion can be drawn at that rate.
    """
    known = next((each for each in QUALITY_TITLES if each == quality), None)
    if known is None:
        raise UnknownNameError(f"There is no drawing quality “{quality}”; choose one of {', '.join(QUALITY_TITLES)}.")
    if not SLOWEST <= rate <= QUICKEST:
        raise FaceError(f"{rate:g} frames a second cannot be kept; ask for {SLOWEST:g} to {QUICKEST:g}.")
    return known, float(rate)


class Pacing:
    """Finds the finest level at which the face moves fluidly on the machine at hand.

    It steps down while the face moves and up while it rests, never by a guess: a resting face is drawn as finely as
    can be, and what that took tells whether the better level is quick enough.

    Parameters
    ----------
    ceiling : the finest level that the driver is trusted with
    start : the level to begin with
    rate : frames a second that are wanted at least

    Attributes
    ----------
    moving : the level while the face moves
    resting : the level once it rests
    """

    def __init__(self, ceiling: Level, start: Level, rate: float = FLUID) -> None:
        self.moving, self.resting = start, ceiling
        self._limit = 1000.0 / rate
        self._times: deque[tuple[float, float]] = deque(maxlen=FRAMES)
        self._posing = 0.0
        self._slow: dict[Level, int] = dict.fromkeys(LEVELS, 0)
        self._dear = 0

    @property
    def took(self) -> float:
        """Milliseconds that a frame of the present motion takes; 0 without one."""
        return median(whole for whole, _ in self._times) if self._times else 0.0

    def moved(self, whole: float, drawing: float) -> bool:
        """Note a frame of a motion; whether the level steps down for it.

        Parameters
        ----------
        whole, drawing : milliseconds that posing and drawing took, and drawing alone
        """
        self._times.append((whole, drawing))
        self._posing = median(whole - drawing for whole, drawing in self._times)
        blamed = median(drawing for _, drawing in self._times) > PART * self._limit
        if len(self._times) < FRAMES or self.took <= self._limit or not blamed or self.moving == LEVELS[0]:
            return False
        self._slow[self.moving] += 1
        self.moving = coarser(self.moving)
        return True

    def rested(self, drawing: float) -> bool:
        """Note the picture of a resting face, drawn in ``drawing`` milliseconds; whether a level changes for it."""
        better = finer(self.moving)
        if LEVELS.index(better) <= LEVELS.index(self.resting) and better != self.moving:
            quick = drawing + self._posing <= COMFORT * self._limit
            if quick and self._slow[better] < TRIES:
                self.moving = better
                return True
        return self._too_dear(drawing)

    def begin_anew(self) -> None:
        """Forget the frames so far: they were drawn at another level."""
        self._times.clear()

    def _too_dear(self, drawing: float) -> bool:
        """Be content with less at rest if that keeps the hand waiting; a first time may be the driver's preparation."""
        self._dear = self._dear + 1 if drawing > PATIENCE else 0
        if self._dear < TRIES or self.resting == self.moving:
            return False
        self._dear, self.resting = 0, coarser(self.resting)
        return True
