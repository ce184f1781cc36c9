"""What an animation shows at a time: all channels at once, or a whole clip.

The order of composition is that of `facemodel.animation`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.animation.captured import CapturedCurves
from facemodel.animation.channels import RIGID, channels, channels_of
from facemodel.animation.clip import Animation
from facemodel.animation.coarticulation import mouth_of
from facemodel.animation.event import Bumps
from facemodel.animation.idle import life_of
from facemodel.animation.keyed import KeyedCurves
from facemodel.animation.track import Track
from fem.types import BoolArray, FloatArray, IntArray

AT_ONCE = 4096
"""Times evaluated together; with 100 channels an array of them takes 3 MB, which a processor's cache still holds."""


@dataclass(frozen=True, eq=False)
class Pose:
    """What a face does at one moment.

    Attributes
    ----------
    weights : of displacement fields, by name; zero is named too, for a field that is animated rests
    rigid : degrees and millimetres of head and eyes, by channel
    """

    weights: dict[str, float]
    rigid: dict[str, float]


class Evaluator:
    """An animation made ready to be shown at any time.

    Making one costs little for what was in one before: curves, layers, speech and idle life stay prepared.

    Attributes
    ----------
    channels : (C,) that move, in the order of the face's fields, then those of no field of it, head and eyes last

    Parameters
    ----------
    animation : what happens
    units : of the face; without them speech does not know its fields
    """

    def __init__(self, animation: Animation, units: Sequence[ActionUnit] = ()) -> None:
        events = [event for event in animation.events if not event.muted]
        mouth, life = mouth_of(animation.speech, units), life_of(animation.idle, animation.end)
        keyed = [track for track in animation.tracks if len(track.curve)]
        captured = [track for track in animation.tracks if track.captured is not None]
        moved = [track.channel for track in (*keyed, *captured)]
        moved += [channel for event in events for channel in event.channels]
        self.channels = _in_order((*moved, *mouth.channels, *life.channels), animation.tracks, units)
        row = {name: k for k, name in enumerate(self.channels)}
        self._keyed, self._keyed_rows = _part(keyed, row)
        self._captured, self._captured_rows = _part(captured, row)
        self._curves = KeyedCurves([track.curve for track in self._keyed])
        self._dense = CapturedCurves(self._captured)
        pairs = [(e, row[name]) for e, event in enumerate(events) for name in event.channels if name in row]
        self._bumps = Bumps(events)
        self._event_of, self._event_rows = np.array(pairs, dtype=np.int64).reshape(-1, 2).T
        self._mouth, self._mouth_at = mouth, _places(mouth.channels, row)
        self._life, self._life_at = life, _places(life.channels, row)
        known = channels_of(self.channels, units)
        self._low, self._high = np.array([[c.low, c.high] for c in known]).reshape(-1, 2).T
        self._weighs: BoolArray = np.array([not channel.rigid for channel in known], dtype=np.bool_)
        self._opens: BoolArray = np.array([name in mouth.opening for name in self.channels], dtype=np.bool_)

    def at(self, times: FloatArray) -> FloatArray:
        """Values (T, C) at times (T,)."""
        found = np.empty((len(times), len(self.channels)))
        for begin in range(0, len(times), AT_ONCE):
            part = slice(begin, begin + AT_ONCE)
            found[part] = self._at(times[part])
        return found

    def pose(self, time: float) -> Pose:
        """What the face does at a time."""
        values = dict(zip(self.channels, self.at(np.array([float(time)]))[0].tolist(), strict=True))
        return Pose(
            {name: value for name, value in values.items() if name not in RIGID},
            {name: value for name, value in values.items() if name in RIGID},
        )

    def own(self, times: FloatArray) -> FloatArray:
        """Values (T, C) of the tracks alone, before anything is added or clamped."""
        found = np.zeros((len(times), len(self.channels)))
        found[:, self._keyed_rows] += self._curves.at(times)
        found[:, self._captured_rows] += self._dense.at(times)
        return found

    def _at(self, times: FloatArray) -> FloatArray:
        base = self.own(times)
        events, largest = np.zeros_like(base), np.zeros_like(base)
        bumps = self._bumps.at(times)[:, self._event_of]
        np.add.at(events.T, self._event_rows, bumps.T)
        np.maximum.at(largest.T, self._event_rows, bumps.T)
        spoken, closed = self._mouth.at(times)
        speech, life = np.zeros_like(base), np.zeros_like(base)
        speech[:, self._mouth_at[1]] = spoken[:, self._mouth_at[0]]
        life[:, self._life_at[1]] = self._life.at(times)[:, self._life_at[0]]
        total = base + events + speech + life
        full = np.maximum.reduce([np.ones_like(base), base, largest, speech, life])
        total = np.where(self._weighs, np.minimum(total, full), total)
        total -= np.where(self._opens, closed[:, None], 0.0) * total
        return np.clip(total, self._low, self._high)


def _in_order(names: Sequence[str], tracks: Sequence[Track], units: Sequence[ActionUnit]) -> tuple[str, ...]:
    """The channels to show, each once: those that are soloed if any is, without those that are muted."""
    solo = {track.channel for track in tracks if track.solo}
    muted = {track.channel for track in tracks if track.muted}
    shown = {name for name in names if (not solo or name in solo) and name not in muted}
    face = [channel.name for channel in channels(units)]
    fields = [name for name in face if name not in RIGID]
    others = sorted(shown.difference(face))
    return tuple(name for name in (*fields, *others, *RIGID) if name in shown)


def _part(tracks: Sequence[Track], row: dict[str, int]) -> tuple[list[Track], IntArray]:
    """The tracks whose channels are shown, and the rows of these."""
    found = [track for track in tracks if track.channel in row]
    return found, np.array([row[track.channel] for track in found], dtype=np.int64)


def _places(names: Sequence[str], row: dict[str, int]) -> tuple[IntArray, IntArray]:
    """Which of some channels are shown, and in which rows."""
    found = [(k, row[name]) for k, name in enumerate(names) if name in row]
    own, rows = np.array(found, dtype=np.int64).reshape(-1, 2).T
    return own, rows


@dataclass(frozen=True, eq=False)
class Sampled:
    """A clip frame by frame, for export.

    Attributes
    ----------
    rate : frames per second
    times : (T,) seconds
    channels : (C,) that move
    values : (T, C)
    """

    rate: float
    times: FloatArray
    channels: tuple[str, ...]
    values: FloatArray

    def pose(self, frame: int) -> Pose:
        """What the face does in a frame."""
        values = dict(zip(self.channels, self.values[frame].tolist(), strict=True))
        return Pose(
            {name: value for name, value in values.items() if name not in RIGID},
            {name: value for name, value in values.items() if name in RIGID},
        )


def frame_times(start: float, end: float, rate: float) -> FloatArray:
    """Times of all frames from a start to an end, both counted, where the end falls on one."""
    count = int(np.floor((end - start) * rate + FRAME_TOLERANCE)) + 1
    return np.asarray(start + np.arange(max(count, 1)) / rate)


FRAME_TOLERANCE = 1e-6
"""Of a frame: an end of so many frames, computed in seconds and back, is still on its frame."""


def sampled(
    animation: Animation,
    units: Sequence[ActionUnit] = (),
    rate: float | None = None,
    span: tuple[float, float] | None = None,
) -> Sampled:
    """A clip frame by frame.

    Parameters
    ----------
    animation, units : as for `Evaluator`
    rate : frames per second; the animation's own if not given
    span : from when to when, seconds; what is played if not given
    """
    evaluator = Evaluator(animation, units)
    own = rate or animation.rate
    times = frame_times(*(span or (animation.start, animation.end)), own)
    return Sampled(own, times, evaluator.channels, evaluator.at(times))
