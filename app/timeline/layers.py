"""Layers over captured curves: added, removed and baked, each in one step."""

from __future__ import annotations

from collections.abc import Iterable

from app.timeline.timeline import Timeline
from facemodel.animation.editing.dense import each_track
from facemodel.animation.editing.layers import baked_layers, with_layer, without_layer


def add_layer(timeline: Timeline, channel: str) -> None:
    """One more layer over the captured curve of a channel; the next keys go there."""
    animation = timeline.animation
    track = animation.track(channel)
    if track is None or track.captured is None:
        return
    made = each_track(animation, [channel], lambda each: with_layer(each, timeline.state.spacing))
    timeline.edit(made, "Add layer")
    timeline.change(lines=frozenset((f"layer {channel} {len(track.layers) + 1}",)))


def remove_layer(timeline: Timeline, channel: str, layer: int) -> None:
    """Remove a layer; the captured curve under it is what it was."""
    timeline.edit(without_layer(timeline.animation, channel, layer), "Remove layer")
    timeline.change(lines=frozenset((f"track {channel}",)))


def bake_layers(timeline: Timeline, channels: Iterable[str]) -> None:
    """Make all layers of some channels part of their captured curves."""
    wanted = tuple(channels)
    timeline.edit(each_track(timeline.animation, wanted, baked_layers), "Bake layers")
    timeline.change(lines=frozenset(f"track {channel}" for channel in wanted))


def layered_channels(timeline: Timeline) -> tuple[str, ...]:
    """Channels that have layers."""
    return tuple(track.channel for track in timeline.animation.tracks if track.layers)
