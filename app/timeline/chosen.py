"""What is chosen on the timeline, and how the choice lives through edits."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from facemodel.animation.clip import Animation
from facemodel.animation.curve import SAME_TIME
from facemodel.animation.editing.expressions import expression_keys
from facemodel.animation.editing.selection import Row, Selection, curve_of_row, rows, span, unlocked


@dataclass(frozen=True)
class Chosen:
    """Things on the timeline that are chosen together.

    Attributes
    ----------
    keys : places of keys by row
    events : keys of events
    sounds : places of phonemes
    expressions : times of key expressions, seconds; their keys are in `keys`
    markers : times of markers, seconds
    ranges : names of named ranges
    """

    keys: Selection = field(default_factory=dict)
    events: frozenset[str] = frozenset()
    sounds: frozenset[int] = frozenset()
    expressions: frozenset[float] = frozenset()
    markers: frozenset[float] = frozenset()
    ranges: frozenset[str] = frozenset()

    def __bool__(self) -> bool:
        return bool(self.keys or self.events or self.sounds or self.expressions or self.markers or self.ranges)

    @property
    def key_count(self) -> int:
        """How many keys are chosen."""
        return sum(map(len, self.keys.values()))

    def has_key(self, row: Row, place: int) -> bool:
        """Whether a key is chosen."""
        return place in self.keys.get(row, ())

    def joined(self, other: Chosen) -> Chosen:
        """Both together."""
        return Chosen(
            merged(self.keys, other.keys),
            self.events | other.events,
            self.sounds | other.sounds,
            self.expressions | other.expressions,
            self.markers | other.markers,
            self.ranges | other.ranges,
        )

    def without(self, other: Chosen) -> Chosen:
        """What is chosen here and not in the other."""
        return Chosen(
            reduced(self.keys, other.keys),
            self.events - other.events,
            self.sounds - other.sounds,
            self.expressions - other.expressions,
            self.markers - other.markers,
            self.ranges - other.ranges,
        )

    def toggled(self, other: Chosen) -> Chosen:
        """The other taken out if all of it is chosen, else taken in."""
        return self.without(other) if self.holds(other) else self.joined(other)

    def holds(self, other: Chosen) -> bool:
        """Whether all of the other is chosen here too."""
        return not other.without(self)


NOTHING = Chosen()


def merged(one: Selection, other: Selection) -> Selection:
    """Keys of both selections."""
    found = {row: sorted({*one.get(row, ()), *other.get(row, ())}) for row in (*one, *other)}
    return {row: tuple(places) for row, places in found.items() if places}


def reduced(one: Selection, other: Selection) -> Selection:
    """Keys of one selection that are not in the other."""
    found = {row: tuple(place for place in places if place not in other.get(row, ())) for row, places in one.items()}
    return {row: places for row, places in found.items() if places}


def changeable(chosen: Chosen, animation: Animation) -> Chosen:
    """What of a choice can be changed: no keys of locked tracks, and no key expression all of whose keys are such."""
    if not any(track.locked for track in animation.tracks):
        return chosen
    keys = {row: chosen.keys[row] for row in unlocked(animation, chosen.keys)}
    expressions = frozenset(time for time in chosen.expressions if not _held(animation, time))
    return replace(chosen, keys=keys, expressions=expressions)


def _held(animation: Animation, time: float) -> bool:
    """Whether a key expression has keys and all of them are locked."""
    keys = expression_keys(animation, time)
    return bool(keys) and not unlocked(animation, keys)


def all_of(animation: Animation, among: Iterable[Row] | None = None) -> Selection:
    """All keys of some rows, or of all."""
    found = {row: tuple(range(len(curve_of_row(animation, row)))) for row in among or rows(animation)}
    return {row: places for row, places in found.items() if places}


def times_of(animation: Animation, chosen: Chosen) -> tuple[float, float] | None:
    """From when to when what is chosen reaches, seconds; none if nothing is."""
    ends: list[tuple[float, float]] = []
    if any(chosen.keys.values()):
        ends.append(span(animation, chosen.keys))
    ends += [(event.begins, event.ends) for event in animation.events if event.key in chosen.events]
    sounds = animation.speech.phonemes
    ends += [(sounds[place].start, sounds[place].end) for place in chosen.sounds if place < len(sounds)]
    ends += [(time, time) for time in (*chosen.expressions, *chosen.markers)]
    ends += [(each.start, each.end) for each in animation.ranges if each.name in chosen.ranges]
    return (min(start for start, _ in ends), max(end for _, end in ends)) if ends else None


def carried(chosen: Chosen, before: Animation, after: Animation) -> Chosen:
    """The choice after an animation became another one: what is still there.

    Keys stay chosen by their place where a row has as many as before, else by their time.
    """
    if not chosen or before is after:
        return chosen
    return replace(
        chosen,
        keys=_keys_carried(chosen.keys, before, after),
        events=chosen.events & {event.key for event in after.events},
        sounds=frozenset(place for place in chosen.sounds if place < len(after.speech.phonemes)),
        expressions=_times_carried(chosen.expressions, [each.time for each in after.expressions]),
        markers=_times_carried(chosen.markers, [each.time for each in after.markers]),
        ranges=chosen.ranges & {each.name for each in after.ranges},
    )


def _keys_carried(keys: Selection, before: Animation, after: Animation) -> Selection:
    found: dict[Row, tuple[int, ...]] = {}
    for row, places in keys.items():
        old, new = curve_of_row(before, row), curve_of_row(after, row)
        if old is new or len(old) == len(new):
            found[row] = places
        elif len(new):
            there = (new.near(float(old.times[place])) for place in places if place < len(old))
            found[row] = tuple(sorted({place for place in there if place is not None}))
    return {row: places for row, places in found.items() if places}


def _times_carried(times: Collection[float], known: Iterable[float]) -> frozenset[float]:
    there = list(known)
    return frozenset(time for time in times if any(abs(time - each) <= SAME_TIME for each in there))


def keys_between(
    animation: Animation, start: float, end: float, bounds: Mapping[Row, tuple[float, float] | None]
) -> Selection:
    """Keys in a stretch of time, in some rows, and there only those of values within bounds where there are any."""
    found: dict[Row, tuple[int, ...]] = {}
    for row, band in bounds.items():
        curve = curve_of_row(animation, row)
        inside = (curve.times >= start) & (curve.times <= end)
        if band is not None:
            inside &= (curve.values >= band[0]) & (curve.values <= band[1])
        if inside.any():
            found[row] = tuple(np.flatnonzero(inside).tolist())
    return found
