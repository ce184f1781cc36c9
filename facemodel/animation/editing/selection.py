"""Which keys are meant: rows of the timeline and places in them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.animation.channels import channel_of
from facemodel.animation.clip import Animation
from facemodel.animation.curve import EMPTY, SAME_TIME, Curve
from facemodel.animation.track import Track
from fem.types import IntArray

Row = tuple[str, int]
"""A channel and 0 for the keys of its track, 1 for those of the first layer over its captured curve, and so on."""

Selection = Mapping[Row, tuple[int, ...]]
"""Places of keys by row, in increasing order."""


def rows(animation: Animation) -> tuple[Row, ...]:
    """All rows that can have keys, in the order of the tracks."""
    return tuple((track.channel, row) for track in animation.tracks for row in range(len(track.layers) + 1))


def curve_of_row(animation: Animation, row: Row) -> Curve:
    """The keys of a row; none if there is no such row."""
    track = animation.track(row[0])
    if track is None or row[1] > len(track.layers):
        return EMPTY
    return track.curve if row[1] == 0 else track.layers[row[1] - 1].keys


def unlocked(animation: Animation, among: Iterable[Row]) -> tuple[Row, ...]:
    """Those of some rows whose keys can be changed: all but the rows of locked tracks."""
    locked = {track.channel for track in animation.tracks if track.locked}
    return tuple(row for row in among if row[0] not in locked)


def with_row(track: Track, row: int, curve: Curve) -> Track:
    """A track with other keys in one of its rows."""
    if row == 0:
        return replace(track, curve=curve)
    layers = list(track.layers)
    layers[row - 1] = replace(layers[row - 1], keys=curve)
    return replace(track, layers=tuple(layers))


def selected(animation: Animation, start: float, end: float, among: Iterable[Row] | None = None) -> Selection:
    """The keys from one time to another, both counted, in some rows or all."""
    found: dict[Row, tuple[int, ...]] = {}
    for row in rows(animation) if among is None else among:
        times = curve_of_row(animation, row).times
        places = np.flatnonzero((times >= start - SAME_TIME) & (times <= end + SAME_TIME))
        if len(places):
            found[row] = tuple(places.tolist())
    return found


def span(animation: Animation, selection: Selection) -> tuple[float, float]:
    """Time of the first and of the last of some keys; 0 and 0 of none."""
    times = [curve_of_row(animation, row).times[list(places)] for row, places in selection.items() if places]
    if not times:
        return 0.0, 0.0
    return float(min(each.min() for each in times)), float(max(each.max() for each in times))


Change = Callable[[Curve, IntArray, Row], tuple[Curve, IntArray]]
"""Makes another curve of one and the places of the chosen keys, and says where they are now."""


def with_keys_changed(
    animation: Animation, selection: Selection, change: Change, units: Sequence[ActionUnit] = ()
) -> tuple[Animation, Selection]:
    """An animation with some keys changed row by row, kept in the range of their channel, and where they are now."""
    tracks = list(animation.tracks)
    now: dict[Row, tuple[int, ...]] = {}
    for number, track in enumerate(animation.tracks):
        for row in range(len(track.layers) + 1):
            places = selection.get((track.channel, row), ())
            if track.locked:
                now |= {(track.channel, row): places} if places else {}
            elif places:
                curve = curve_of_row(animation, (track.channel, row))
                made, stand = change(curve, np.array(places, dtype=np.int64), (track.channel, row))
                tracks[number] = with_row(tracks[number], row, kept_in_range(made, track, row, units))
                now |= {(track.channel, row): tuple(stand.tolist())} if len(stand) else {}
    return replace(animation, tracks=tuple(tracks)), now


def kept_in_range(curve: Curve, track: Track, row: int, units: Sequence[ActionUnit]) -> Curve:
    """A curve whose keys are possible for its channel."""
    low, high = reach_of(track, row, units)
    if not len(curve) or (curve.values.min() >= low and curve.values.max() <= high):
        return curve
    return replace(curve, values=np.clip(curve.values, low, high))


def reach_of(track: Track, row: int, units: Sequence[ActionUnit] = ()) -> tuple[float, float]:
    """The lowest and the highest value that a key of a row may have: those that are summed with others go farther."""
    channel = channel_of(track.channel, units)
    if track.captured is None or (row and not len(track.curve)):
        return channel.low, channel.high
    span = channel.high - channel.low
    return channel.low - span, channel.high + span
