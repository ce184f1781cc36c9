"""Key expressions: a whole expression at a time, over keyed and captured curves alike."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.animation.captured import displaced
from facemodel.animation.channels import RIGID, channels_of
from facemodel.animation.clip import Animation, KeyExpression
from facemodel.animation.curve import SAME_TIME, Shape
from facemodel.animation.displacement import SPACING
from facemodel.animation.editing.bulk import deleted_keys, moved_keys
from facemodel.animation.editing.keys import with_key
from facemodel.animation.editing.layers import with_layer
from facemodel.animation.editing.selection import Selection, curve_of_row, kept_in_range, selected, with_row
from facemodel.animation.editing.tracks import track_for, with_tracks
from facemodel.animation.evaluation import Evaluator
from facemodel.animation.keyed import values_of
from facemodel.animation.track import Track


def keyed(
    animation: Animation,
    time: float,
    shown: Mapping[str, float],
    units: Sequence[ActionUnit] = (),
    spacing: float = SPACING,
    shape: Shape | None = None,
) -> Animation:
    """An animation that shows some values at a time, by a key in every channel named.

    A captured curve is taken there by its uppermost layer that is not muted, made if it has none.  What events, speech
    and idle life add at the time is taken off before, as far as that is possible.  Locked tracks are left alone.

    Parameters
    ----------
    shown : what is to be seen, by channel
    units : of the face
    spacing : seconds between the knots of a new layer
    shape : how curves go on from new keys
    """
    if not shown:
        return animation
    added = _added(animation, time, units)
    made: list[Track] = []
    for channel, value in shown.items():
        track = track_for(animation, channel)
        if not track.locked:
            own = value - added.get(channel, 0.0)
            made.append(_track_keyed(track, time, own, units, spacing, shape))
    return with_tracks(animation, made)


def _added(animation: Animation, time: float, units: Sequence[ActionUnit]) -> dict[str, float]:
    """What is shown at a time over and above the tracks, by channel."""
    evaluator = Evaluator(animation, units)
    at = np.array([float(time)])
    own = evaluator.own(at)[0]
    known = channels_of(evaluator.channels, units)
    low, high = np.array([[channel.low, channel.high] for channel in known]).reshape(-1, 2).T
    return dict(zip(evaluator.channels, (evaluator.at(at)[0] - np.clip(own, low, high)).tolist(), strict=True))


def _track_keyed(
    track: Track, time: float, value: float, units: Sequence[ActionUnit], spacing: float, shape: Shape | None
) -> Track:
    row = 0
    if track.captured is not None:
        if not any(not layer.muted for layer in track.layers):
            track = with_layer(track, spacing)
        row = max(number for number, layer in enumerate(track.layers, start=1) if not layer.muted)
        value -= _keys_at(track, time)
    curve = with_key(track.curve if row == 0 else track.layers[row - 1].keys, time, value, shape)
    return with_row(track, row, kept_in_range(curve, track, row, units))


def _keys_at(track: Track, time: float) -> float:
    """What the keys of a track add to its captured curve."""
    return float(values_of(track.curve, np.array([float(time)]))[0])


def with_expression(
    animation: Animation,
    time: float,
    shown: Mapping[str, float],
    name: str = "",
    units: Sequence[ActionUnit] = (),
    spacing: float = SPACING,
) -> Animation:
    """An animation with a key expression, in place of the one at that time if there is one.

    Every channel that it moves, and every one that another key expression moves, gets a key.  A channel that is new
    gets one at rest at all other key expressions, so that these stay what they were.

    Parameters
    ----------
    shown : the expression, by channel; a channel not named rests
    """
    others = [each for each in animation.expressions if abs(each.time - time) > SAME_TIME]
    known = {channel for each in others for channel in expression_channels(animation, each.time)}
    moving = {channel for channel, value in shown.items() if value != 0}
    here = set(expression_channels(animation, time))
    for each in others:
        fresh = {channel: _stands(animation, channel, each.time) for channel in sorted(moving - known - here)}
        animation = keyed(animation, each.time, fresh, units, spacing)
    wanted = {channel: shown.get(channel, 0.0) for channel in sorted(known | moving | here)}
    animation = keyed(animation, time, wanted, units, spacing)
    expressions = sorted((*others, KeyExpression(time, name)), key=lambda each: each.time)
    return replace(animation, expressions=tuple(expressions))


def _stands(animation: Animation, channel: str, time: float) -> float:
    """What a channel's track shows at a time; nothing without one."""
    track = animation.track(channel)
    if track is None:
        return 0.0
    captured = 0.0 if track.captured is None else float(displaced(track, np.array([float(time)]))[0])
    return captured + _keys_at(track, time)


def expression_keys(animation: Animation, time: float) -> Selection:
    """The keys of the key expression at a time."""
    return selected(animation, time, time)


def expression_channels(animation: Animation, time: float) -> tuple[str, ...]:
    """The channels that have a key at a time."""
    return tuple(dict.fromkeys(channel for channel, _ in expression_keys(animation, time)))


def expression_weights(animation: Animation, time: float) -> dict[str, float]:
    """What the keys of a key expression say, by field, for its thumbnail."""
    found: dict[str, float] = {}
    for (channel, row), places in expression_keys(animation, time).items():
        if channel not in RIGID:
            found[channel] = float(curve_of_row(animation, (channel, row)).values[places[0]])
    return found


def moved_expression(animation: Animation, time: float, to: float, units: Sequence[ActionUnit] = ()) -> Animation:
    """An animation in which a key expression is at another time, with all its keys; one that is there gives way."""
    moving = [each for each in animation.expressions if abs(each.time - time) <= SAME_TIME]
    if not moving:
        return animation
    animation, _ = moved_keys(animation, expression_keys(animation, time), to - time, units=units)
    stay = [e for e in animation.expressions if abs(e.time - time) > SAME_TIME and abs(e.time - to) > SAME_TIME]
    placed = sorted((*stay, replace(moving[0], time=to)), key=lambda each: each.time)
    return replace(animation, expressions=tuple(placed))


def renamed_expression(animation: Animation, time: float, name: str) -> Animation:
    """An animation in which a key expression has another name."""
    return replace(
        animation,
        expressions=tuple(
            replace(each, name=name) if abs(each.time - time) <= SAME_TIME else each for each in animation.expressions
        ),
    )


def without_expression(animation: Animation, time: float) -> Animation:
    """An animation without a key expression and its keys."""
    kept = tuple(each for each in animation.expressions if abs(each.time - time) > SAME_TIME)
    return replace(deleted_keys(animation, expression_keys(animation, time)), expressions=kept)
