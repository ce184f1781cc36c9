"""An animation: all tracks with their events, speech and marks.  A frozen value."""

from __future__ import annotations

from dataclasses import dataclass, field

from facemodel.animation.event import Event
from facemodel.animation.idle import Idle
from facemodel.animation.speech import Speech
from facemodel.animation.track import Track

SLOWEST, FASTEST = 12.0, 120.0
"""Frames per second."""


@dataclass(frozen=True)
class Marker:
    """A named moment, seconds."""

    time: float
    name: str = ""


@dataclass(frozen=True)
class NamedRange:
    """A named stretch of time, seconds."""

    name: str
    start: float
    end: float


@dataclass(frozen=True)
class KeyExpression:
    """A moment at which every animated channel has a key: a whole expression, with its name.

    What it looks like is in the keys, so that curves and key expressions cannot disagree.
    """

    time: float
    name: str = ""


@dataclass(frozen=True)
class Audio:
    """A sound that plays along.

    Attributes
    ----------
    path : of a WAV file, with forward slashes; relative to the project's file where that is possible
    start : when it begins, seconds of the clip
    muted : whether it is silent
    """

    path: str
    start: float = 0.0
    muted: bool = False


@dataclass(frozen=True, eq=False)
class Animation:
    """All that happens over time.

    Attributes
    ----------
    tracks : at most one for every channel, in the order in which they are listed
    events : in any order
    speech, idle : what speaks, and what lives by itself
    expressions : in the order of time
    rate : frames per second, `SLOWEST` to `FASTEST`
    start, end : what is played and exported, seconds
    loop : whether it begins anew at its end
    markers, ranges : in the order of time
    audio : the sound, if there is one
    """

    tracks: tuple[Track, ...] = ()
    events: tuple[Event, ...] = ()
    speech: Speech = field(default_factory=Speech)
    idle: Idle | None = None
    expressions: tuple[KeyExpression, ...] = ()
    rate: float = 30.0
    start: float = 0.0
    end: float = 5.0
    loop: bool = False
    markers: tuple[Marker, ...] = ()
    ranges: tuple[NamedRange, ...] = ()
    audio: Audio | None = None

    @property
    def duration(self) -> float:
        """Seconds of what is played."""
        return self.end - self.start

    @property
    def moves(self) -> bool:
        """Whether anything is animated."""
        return bool(self.tracks or self.events or self.speech.phonemes or self.idle)

    def track(self, channel: str) -> Track | None:
        """The track of a channel, if it has one."""
        return next((track for track in self.tracks if track.channel == channel), None)


STILL = Animation()
"""Nothing happens; what a project has until somebody gives it time."""
