"""Keys that were copied: pasted at another time, on other channels or on the other side of the face."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.animation.channels import RIGID, mirrored
from facemodel.animation.clip import Animation
from facemodel.animation.curve import Curve, curve_of
from facemodel.animation.editing.bulk import deleted_keys
from facemodel.animation.editing.keys import taken, with_values
from facemodel.animation.editing.selection import (
    Row,
    Selection,
    curve_of_row,
    kept_in_range,
    span,
    with_row,
)
from facemodel.animation.editing.tracks import track_for, with_track

Copied = Mapping[Row, Curve]
"""Keys by row, at times after the first of them."""


def copied_keys(animation: Animation, selection: Selection) -> Copied:
    """Some keys for the clipboard."""
    begin, _ = span(animation, selection)
    found = {row: taken(curve_of_row(animation, row), places) for row, places in selection.items() if places}
    return {row: replace(curve, times=curve.times - begin) for row, curve in found.items()}


def pasted_keys(
    animation: Animation,
    copied: Copied,
    time: float,
    onto: Sequence[Row] = (),
    units: Sequence[ActionUnit] = (),
) -> tuple[Animation, Selection]:
    """An animation with keys from the clipboard, the first of them at a time; keys that they land on give way.

    Parameters
    ----------
    onto : where keys that were copied from one row go instead; several of them get the same
    units : of the face, for the range of its channels

    Returns
    -------
    animation : with tracks for channels that had none; locked ones and layers that are not there get nothing
    selection : the pasted keys
    """
    sources = dict(copied)
    if onto and len(copied) == 1:
        (single,) = copied.values()
        sources = dict.fromkeys(onto, single)
    now: dict[Row, tuple[int, ...]] = {}
    for (channel, row), keys in sources.items():
        track = track_for(animation, channel)
        if track.locked or row > len(track.layers):
            continue
        fresh = replace(keys, times=keys.times + time)
        curve = curve_of_row(replace(animation, tracks=(track,)), (channel, row))
        made = kept_in_range(over(curve, fresh), track, row, units)
        animation = with_track(animation, with_row(track, row, made))
        now[channel, row] = tuple(np.searchsorted(made.times, fresh.times - _HALF).tolist())
    return animation, now


_HALF = 5e-7
"""Half of `SAME_TIME`, within which a pasted key is the one that was put."""


def over(curve: Curve, fresh: Curve) -> Curve:
    """A curve with all keys of another one laid over its own."""
    return curve_of((*curve.keys, *fresh.keys), curve.overshoot or fresh.overshoot)


def on_other_side(copied: Copied) -> Copied:
    """What was copied as it looks in a mirror: on the channels of the other side, turns the other way round."""
    found: dict[Row, Curve] = {}
    for (channel, row), keys in copied.items():
        flips = channel in RIGID and RIGID[channel].flips
        found[mirrored(channel), row] = _negated(keys) if flips else keys
    return found


def _negated(keys: Curve) -> Curve:
    return replace(
        with_values(keys, np.arange(len(keys)), -keys.values), handles=keys.handles * np.array([1.0, -1.0, 1.0, -1.0])
    )


def mirrored_keys(
    animation: Animation, selection: Selection, units: Sequence[ActionUnit] = ()
) -> tuple[Animation, Selection]:
    """Keys put on the other side of the face; where keys of both sides are chosen, they change places."""
    begin, _ = span(animation, selection)
    other = on_other_side(copied_keys(animation, selection))
    return pasted_keys(deleted_keys(animation, selection), other, begin, units=units)
