"""The animation of a project as records and arrays of its file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import MISSING, Field, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from facemodel.animation.clip import STILL, Animation, Audio, KeyExpression, Marker, NamedRange
from facemodel.animation.curve import SAME_TIME, SHAPES, Curve
from facemodel.animation.displacement import Displacement
from facemodel.animation.event import Event
from facemodel.animation.idle import Idle
from facemodel.animation.samples import Samples
from facemodel.animation.speech import Phoneme, Speech, Viseme, Word
from facemodel.animation.track import Track
from facemodel.io.animation_schema import LONGEST_TIME, AnimationRecord, SpeechRecord, TrackRecord
from facemodel.io.damage import DamageError
from facemodel.io.members import Members
from facemodel.sameness import same
from fem.types import FloatArray, IntArray

FOLDER = "animation"
KEYS = f"{FOLDER}/keys"

LARGEST_VALUE = 1e5
"""Of a key or a sample; weights, degrees and millimetres end long before."""

WEIGHTED, BROKEN = 4, 8
"""Bits of the code of a key above the index of its shape."""


def animation_json(animation: Animation) -> dict[str, Any] | None:
    """What `AnimationRecord` reads; none if nothing happens."""
    if animation is STILL or same(animation, STILL):
        return None
    return _changed(animation, tracks=[_track_json(track) for track in animation.tracks])


def _track_json(track: Track) -> dict[str, Any]:
    found = _changed(
        track, curve=None, captured=None, layers=[_changed(each, keys=len(each.keys)) for each in track.layers]
    )
    if len(track.curve):
        found["keys"] = len(track.curve)
    if track.curve.overshoot:
        found["overshoot"] = True
    if track.captured is not None:
        found["captured"] = {"rate": float(track.captured.rate), "start": float(track.captured.start)}
    return found


def _changed(value: Any, **instead: Any) -> dict[str, Any]:
    """The members of a dataclass that are not as they usually are; what is given is taken instead, unless none."""
    found: dict[str, Any] = {}
    for each in fields(value):
        member = instead.get(each.name, getattr(value, each.name))
        if each.name in instead and not member and member != 0:
            continue
        if each.name in instead or not same(member, _usual(each)):
            found[each.name] = _plain(member)
    return found


def _usual(member: Field[Any]) -> Any:
    if member.default_factory is not MISSING:
        return member.default_factory()
    return member.default


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {name: _plain(each) for name, each in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(each) for each in value]
    if isinstance(value, bool | str | int) or value is None:
        return value
    if isinstance(value, float | np.floating):
        return float(value)
    return _changed(value)


def animation_arrays(animation: Animation) -> dict[str, NDArray[Any]]:
    """The arrays by member name: the keys of all curves one behind the other, and captured values track by track."""
    curves = [curve for track in animation.tracks for curve in _curves(track)]
    arrays: dict[str, NDArray[Any]] = {}
    if sum(map(len, curves)):
        for name in ("times", "values", "handles"):
            arrays[f"{KEYS}/{name}"] = np.concatenate([getattr(curve, name) for curve in curves])
        codes = [curve.shapes + WEIGHTED * curve.weighted + BROKEN * curve.broken for curve in curves]
        arrays[f"{KEYS}/codes"] = np.concatenate(codes).astype(np.int8)
    for number, track in enumerate(animation.tracks):
        if track.captured is not None:
            arrays[f"{FOLDER}/captured/{number}"] = track.captured.values
    return arrays


def _curves(track: Track) -> Iterator[Curve]:
    yield track.curve
    for layer in track.layers:
        yield layer.keys


def without_animation(arrays: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """The other arrays of a file."""
    return {name: array for name, array in arrays.items() if not name.startswith(f"{FOLDER}/")}


def animation_of(record: AnimationRecord | None, arrays: Mapping[str, NDArray[Any]]) -> Animation:
    """The animation of a file.

    Raises
    ------
    DamageError
        If an array is missing, left over, of another shape or out of range, or keys are not in the order of time.
    """
    members = Members({name: array for name, array in arrays.items() if name.startswith(f"{FOLDER}/")})
    animation = STILL if record is None else _animation_of(record, members)
    members.finish()
    return animation


def _animation_of(record: AnimationRecord, members: Members) -> Animation:
    keys = _Keys(members, sum(track.keys + sum(layer.keys for layer in track.layers) for track in record.tracks))
    return Animation(
        tracks=tuple(_track_of(track, number, keys, members) for number, track in enumerate(record.tracks)),
        events=tuple(Event(**each.model_dump()) for each in record.events),
        speech=_speech_of(record.speech),
        idle=None if record.idle is None else Idle(**record.idle.model_dump()),
        expressions=tuple(
            sorted((KeyExpression(each.time, each.name) for each in record.expressions), key=lambda each: each.time)
        ),
        rate=record.rate,
        start=record.start,
        end=record.end,
        loop=record.loop,
        markers=tuple(sorted((Marker(each.time, each.name) for each in record.markers), key=lambda each: each.time)),
        ranges=tuple(NamedRange(each.name, each.start, each.end) for each in record.ranges),
        audio=None if record.audio is None else Audio(**record.audio.model_dump()),
    )


def _speech_of(record: SpeechRecord) -> Speech:
    return Speech(
        tuple(sorted((Phoneme(e.symbol, e.start, e.end) for e in record.phonemes), key=lambda each: each.start)),
        tuple(sorted((Word(e.text, e.start, e.end) for e in record.words), key=lambda each: each.start)),
        tuple(Viseme(e.name, e.symbols, dict(e.weights), e.dominance, e.closes) for e in record.visemes),
        record.strength,
        record.muted,
    )


def _track_of(record: TrackRecord, number: int, keys: _Keys, members: Members) -> Track:
    curve = keys.next(record.keys, record.overshoot)
    layers = tuple(
        Displacement(keys.next(layer.keys), layer.spacing, layer.weight, layer.muted, layer.name)
        for layer in record.layers
    )
    captured = None
    if record.captured is not None:
        name = f"{FOLDER}/captured/{number}"
        values = members.floats(name, (None,), -LARGEST_VALUE, LARGEST_VALUE).astype(np.float32)
        captured = Samples(values, record.captured.rate, record.captured.start)
    return Track(record.channel, curve, captured, layers, record.muted, record.solo, record.locked, record.group)


class _Keys:
    """The keys of all curves, handed out one curve after the other."""

    def __init__(self, members: Members, count: int) -> None:
        self._next = 0
        self._times: FloatArray = np.zeros(0)
        self._values, self._handles = np.zeros(0), np.zeros((0, 4))
        self._codes: IntArray = np.zeros(0, np.int64)
        if count:
            self._times = members.floats(f"{KEYS}/times", (count,), -LONGEST_TIME, LONGEST_TIME)
            self._values = members.floats(f"{KEYS}/values", (count,), -LARGEST_VALUE, LARGEST_VALUE)
            self._handles = members.floats(f"{KEYS}/handles", (count, 4), -LARGEST_VALUE, LARGEST_VALUE)
            self._codes = members.indices(f"{KEYS}/codes", (count,), 2 * BROKEN)

    def next(self, count: int, overshoot: bool = False) -> Curve:
        part = slice(self._next, self._next + count)
        self._next += count
        times, codes = self._times[part].copy(), self._codes[part]
        late = np.flatnonzero(np.diff(times) <= SAME_TIME)
        if len(late):
            raise DamageError(f"{KEYS}/times.npy", f"at {part.start + int(late[0]) + 1} does not go on in time")
        return Curve(
            times,
            self._values[part].copy(),
            (codes % len(SHAPES)).astype(np.int8),
            self._handles[part].copy(),
            (codes & WEIGHTED).astype(np.bool_),
            (codes & BROKEN).astype(np.bool_),
            overshoot,
        )
