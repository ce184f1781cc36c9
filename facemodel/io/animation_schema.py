"""The animation of a project document.

What is as it usually is may be missing, and is in all files that do not need it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import Annotated

from pydantic import Field, model_validator

from facemodel.animation.clip import FASTEST, SLOWEST
from facemodel.animation.displacement import SPACING
from facemodel.animation.event import BRISKEST
from facemodel.io.record_types import Inside, Name, Record, Weight

LONGEST_TIME = 86_400.0
"""Seconds; a day.  Beyond it the sixth digit of a second is no longer told apart from the next in every format."""

FASTEST_CAPTURE = 1000.0
"""Samples per second; no camera for faces is faster."""

MOST_TRACKS = 1000
"""Each may have a member of its own in the archive, which holds twice as many."""

MOST_KEYS = 10_000_000
MOST_ITEMS = 100_000
"""Events, phonemes or marks: a day of speech."""

Time = Annotated[float, Field(ge=-LONGEST_TIME, le=LONGEST_TIME)]
Amount = Annotated[float, Field(ge=-1e5, le=1e5)]
Label = Annotated[str, Field(max_length=100)]
Symbol = Annotated[str, Field(max_length=20)]
Count = Annotated[int, Field(ge=0, le=MOST_KEYS)]
Brisk = Annotated[float, Field(ge=1, le=BRISKEST)]
PerMinute = Annotated[float, Field(ge=0, le=120)]


class CapturedRecord(Record):
    """See `facemodel.animation.samples.Samples`; its values are ``animation/captured/<its track's place>``."""

    rate: Annotated[float, Field(gt=0, le=FASTEST_CAPTURE)]
    start: Time = 0.0


class LayerRecord(Record):
    """See `facemodel.animation.displacement.Displacement`; so many of the keys of all curves are its own."""

    keys: Count
    spacing: Annotated[float, Field(ge=1e-3, le=3600)] = SPACING
    weight: Annotated[float, Field(ge=-10, le=10)] = 1.0
    muted: bool = False
    name: Label = ""


class TrackRecord(Record):
    """See `facemodel.animation.track.Track`; so many of the keys of all curves are its own, its layers' behind them."""

    channel: Name
    keys: Count = 0
    overshoot: bool = False
    captured: CapturedRecord | None = None
    layers: Annotated[tuple[LayerRecord, ...], Field(max_length=100)] = ()
    muted: bool = False
    solo: bool = False
    locked: bool = False
    group: Label = ""


class EventRecord(Record):
    """See `facemodel.animation.event.Event`."""

    key: Name
    channels: Annotated[tuple[Name, ...], Field(min_length=1, max_length=20)]
    start: Time
    onset: Time = 0.0
    acceleration: Brisk = 1.0
    amplitude: Amount = 1.0
    peak: Time = 0.3
    deceleration: Brisk = 1.0
    offset: Time = 0.8
    group: Label = ""
    muted: bool = False

    @model_validator(mode="after")
    def _ordered(self) -> EventRecord:
        if not self.onset <= self.peak <= self.offset:
            raise ValueError("onset, peak and offset have to follow each other")
        unique(self.channels, "channel")
        return self


class PhonemeRecord(Record):
    """See `facemodel.animation.speech.Phoneme`."""

    symbol: Symbol
    start: Time
    end: Time

    @model_validator(mode="after")
    def _ordered(self) -> PhonemeRecord:
        ordered(self.start, self.end)
        return self


class WordRecord(Record):
    """See `facemodel.animation.speech.Word`."""

    text: Label
    start: Time
    end: Time


class VisemeRecord(Record):
    """See `facemodel.animation.speech.Viseme`."""

    name: Name
    symbols: Annotated[tuple[Symbol, ...], Field(max_length=200)] = ()
    weights: dict[Name, Weight] = Field(default_factory=dict)
    dominance: Inside = 0.5
    closes: bool = False


class SpeechRecord(Record):
    """See `facemodel.animation.speech.Speech`."""

    phonemes: Annotated[tuple[PhonemeRecord, ...], Field(max_length=MOST_ITEMS)] = ()
    words: Annotated[tuple[WordRecord, ...], Field(max_length=MOST_ITEMS)] = ()
    visemes: Annotated[tuple[VisemeRecord, ...], Field(max_length=500)] = ()
    strength: Annotated[float, Field(ge=0, le=10)] = 1.0
    muted: bool = False

    @model_validator(mode="after")
    def _once(self) -> SpeechRecord:
        unique((viseme.name for viseme in self.visemes), "viseme")
        return self


class IdleRecord(Record):
    """See `facemodel.animation.idle.Idle`."""

    seed: Annotated[int, Field(ge=0, lt=1 << 31)] = 1
    blinks: PerMinute = 15.0
    saccades: Annotated[float, Field(ge=0, le=10)] = 1.0
    breathing: Annotated[float, Field(ge=0, le=10)] = 1.0
    breaths: PerMinute = 14.0
    muted: bool = False


class MarkerRecord(Record):
    """See `facemodel.animation.clip.Marker`."""

    time: Time
    name: Label = ""


class RangeRecord(Record):
    """See `facemodel.animation.clip.NamedRange`."""

    name: Label
    start: Time
    end: Time

    @model_validator(mode="after")
    def _ordered(self) -> RangeRecord:
        ordered(self.start, self.end)
        return self


class KeyExpressionRecord(Record):
    """See `facemodel.animation.clip.KeyExpression`."""

    time: Time
    name: Label = ""


class AudioRecord(Record):
    """See `facemodel.animation.clip.Audio`."""

    path: Annotated[str, Field(min_length=1, max_length=4096)]
    start: Time = 0.0
    muted: bool = False


class AnimationRecord(Record):
    """See `facemodel.animation.clip.Animation`; its keys and samples are the members under ``animation``."""

    tracks: Annotated[tuple[TrackRecord, ...], Field(max_length=MOST_TRACKS)] = ()
    events: Annotated[tuple[EventRecord, ...], Field(max_length=MOST_ITEMS)] = ()
    speech: SpeechRecord = Field(default_factory=SpeechRecord)
    idle: IdleRecord | None = None
    expressions: Annotated[tuple[KeyExpressionRecord, ...], Field(max_length=MOST_ITEMS)] = ()
    rate: Annotated[float, Field(ge=SLOWEST, le=FASTEST)] = 30.0
    start: Time = 0.0
    end: Time = 5.0
    loop: bool = False
    markers: Annotated[tuple[MarkerRecord, ...], Field(max_length=MOST_ITEMS)] = ()
    ranges: Annotated[tuple[RangeRecord, ...], Field(max_length=MOST_ITEMS)] = ()
    audio: AudioRecord | None = None

    @model_validator(mode="after")
    def _sound(self) -> AnimationRecord:
        ordered(self.start, self.end)
        unique((track.channel for track in self.tracks), "track of")
        unique((event.key for event in self.events), "event")
        return self


def ordered(start: float, end: float) -> None:
    """Raise what pydantic makes a complaint of, if something ends before it begins."""
    if end <= start:
        raise ValueError("the end has to come after the start")


def unique(names: Iterable[str], what: str) -> None:
    """Raise what pydantic makes a complaint of, if a name is there twice."""
    for name, times in Counter(names).items():
        if times > 1:
            raise ValueError(f"the {what} “{name}” is there {times} times")
