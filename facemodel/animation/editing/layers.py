"""Displacement layers over captured curves: added, given other knots, weighed, muted, removed and baked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from facemodel.animation.captured import displaced
from facemodel.animation.clip import Animation
from facemodel.animation.displacement import SPACING, Displacement
from facemodel.animation.editing.tracks import with_track
from facemodel.animation.track import Track

CLOSEST, WIDEST = 0.01, 60.0
"""Seconds between knots: a frame of the fastest clip, and a minute."""


def with_layer(track: Track, spacing: float = SPACING, name: str = "") -> Track:
    """A track with one more layer over all others, without keys yet."""
    return replace(track, layers=(*track.layers, Displacement(spacing=spaced(spacing), name=name)))


def spaced(seconds: float) -> float:
    """A distance between knots that is possible."""
    return min(max(float(seconds), CLOSEST), WIDEST)


def with_layer_changed(
    animation: Animation,
    channel: str,
    layer: int,
    *,
    spacing: float | None = None,
    weight: float | None = None,
    muted: bool | None = None,
    name: str | None = None,
) -> Animation:
    """An animation in which a layer (1 is the lowest) has other knots, another weight or name, or is muted."""
    track = animation.track(channel)
    if track is None or track.locked or not 1 <= layer <= len(track.layers):
        return animation
    given = {"spacing": None if spacing is None else spaced(spacing), "weight": weight, "muted": muted, "name": name}
    changed = replace(track.layers[layer - 1], **{key: each for key, each in given.items() if each is not None})  # type: ignore[arg-type]
    layers = (*track.layers[: layer - 1], changed, *track.layers[layer:])
    return with_track(animation, replace(track, layers=layers))


def without_layer(animation: Animation, channel: str, layer: int) -> Animation:
    """An animation without a layer (1 is the lowest) of a channel."""
    track = animation.track(channel)
    if track is None or track.locked or not 1 <= layer <= len(track.layers):
        return animation
    return with_track(animation, replace(track, layers=(*track.layers[: layer - 1], *track.layers[layer:])))


def baked_layers(track: Track) -> Track:
    """A track whose captured curve is what its layers made of it; they are gone, muted ones without a trace."""
    if track.captured is None or not track.layers:
        return track
    values = displaced(track, track.captured.times).astype(np.float32)
    return replace(track, captured=replace(track.captured, values=values), layers=())
