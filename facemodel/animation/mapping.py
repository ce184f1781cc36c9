"""From what a tracker calls things to what a face can do: an editable table with gains, caps and smoothing."""

from __future__ import annotations

import json
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from scipy.ndimage import gaussian_filter1d

from facemodel.actions import ActionUnit, resolve
from facemodel.animation.capture import Capture, CaptureKind
from facemodel.animation.channels import RIGID, channel_of
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track
from facemodel.errors import UnknownNameError
from fem.types import FloatArray
from resources import resource

MOTIONLESS = 1e-6
"""A channel that never gets farther from zero than this does not move."""

TREMBLING = 0.02
"""Seconds; landmarks tremble from frame to frame, and more would take the peak from a blink of a tenth of a second."""


@dataclass(frozen=True)
class MapRow:
    """One source feeds one target; several rows of a target are added.

    Attributes
    ----------
    source : channel of the capture
    target : an action unit by any name that `facemodel.actions.resolve` knows, or a rigid motion
    gain : what 1 of the source is of the target
    offset : what is taken off the source before
    cap : the farthest that the row brings its target from rest; none for the range of the channel
    centred : whether the median of the source is taken off before: for a head whose camera was not straight ahead
    """

    source: str
    target: str
    gain: float = 1.0
    offset: float = 0.0
    cap: float | None = None
    centred: bool = False


@dataclass(frozen=True)
class Mapping:
    """A table of rows.

    Attributes
    ----------
    name : for people
    rows : in any order
    smoothing : standard deviation of a Gaussian over time, seconds; 0 leaves every frame as it is
    """

    name: str
    rows: tuple[MapRow, ...]
    smoothing: float = 0.0


@dataclass(frozen=True, eq=False)
class Mapped:
    """What comes of a capture.

    Attributes
    ----------
    tracks : one for every channel that moves
    notes : one sentence each for what found no place
    """

    tracks: tuple[Track, ...]
    notes: tuple[str, ...] = ()


def default_mapping(kind: CaptureKind) -> Mapping:
    """The table that ships for captures of a kind; without rows where channels are those of the face already."""
    if kind == "plain":
        return Mapping("Weights as they are", ())
    if kind == "landmarks":
        return Mapping("Weights as they were found", (), TREMBLING)
    return _shipped(kind)


def export_mapping() -> Mapping:
    """The table by which action units become blend shapes of ARKit and turns of Live Link Face."""
    return _shipped("to arkit")


@cache
def _shipped(name: str) -> Mapping:
    raw = json.loads(resource("animation", "mappings.json").read_text("utf-8"))[name]
    return Mapping(raw["name"], tuple(MapRow(**row) for row in raw["rows"]), raw["smoothing"])


def mapped(capture: Capture, mapping: Mapping, units: Sequence[ActionUnit], start: float | None = None) -> Mapped:
    """The tracks of a capture on a face.

    Parameters
    ----------
    capture : what a tracker saw; without rows every channel is its own target
    mapping : how its channels become those of the face
    units : of the face
    start : when it begins in the clip, seconds; as it was noted if not given
    """
    rows = mapping.rows or tuple(MapRow(name, name) for name in capture.channels)
    sums: dict[str, FloatArray] = {}
    lost: list[str] = []
    column = {name: k for k, name in enumerate(capture.channels)}
    for row in rows:
        fields = fields_of(row.target, units)
        if not fields and row.source in column and np.abs(capture.values[:, column[row.source]]).max() > MOTIONLESS:
            lost.append(row.source)
        if fields and row.source in column:
            moved = _moved(capture.values[:, column[row.source]].astype(np.float64), row)
            for field in fields:
                sums[field] = sums.get(field, 0.0) + moved
    begin = capture.start if start is None else start
    tracks = [_track(name, values, mapping, capture.rate, begin, units) for name, values in sums.items()]
    return Mapped(tuple(track for track in tracks if track is not None), _notes(lost, sums, mapping))


def _notes(lost: Sequence[str], found: Collection[str], mapping: Mapping) -> tuple[str, ...]:
    if not found:
        return (f"The table “{mapping.name}” has no row for any of its channels; choose another table.",)
    if not lost:
        return ()
    return (f"This face has no action unit for {', '.join(dict.fromkeys(lost))}; what was captured of it is left out.",)


def fields_of(target: str, units: Sequence[ActionUnit]) -> tuple[str, ...]:
    """The channels that a name means on a face: of a unit its fields; none if it has nothing of that name."""
    if target in RIGID:
        return (target,)
    try:
        return resolve(target, units)
    except UnknownNameError:
        return ()


def _moved(values: FloatArray, row: MapRow) -> FloatArray:
    """What a row adds to its target (N,)."""
    off = row.offset + (float(np.median(values)) if row.centred else 0.0)
    found = row.gain * (values - off)
    return found if row.cap is None else np.clip(found, -row.cap, row.cap)


def _track(
    name: str, values: FloatArray, mapping: Mapping, rate: float, start: float, units: Sequence[ActionUnit]
) -> Track | None:
    channel = channel_of(name, units)
    smooth = gaussian_filter1d(values, mapping.smoothing * rate, mode="nearest") if mapping.smoothing > 0 else values
    kept = np.clip(smooth, channel.low, channel.high).astype(np.float32)
    return Track(name, captured=Samples(kept, rate, start)) if np.abs(kept).max(initial=0.0) > MOTIONLESS else None


def with_row(mapping: Mapping, place: int, row: MapRow) -> Mapping:
    """A table with another row at a place, or one more behind the last."""
    rows = list(mapping.rows)
    rows[place : place + 1] = [row]
    return replace(mapping, rows=tuple(rows))


def without_row(mapping: Mapping, place: int) -> Mapping:
    """A table without a row."""
    return replace(mapping, rows=tuple(row for k, row in enumerate(mapping.rows) if k != place))
