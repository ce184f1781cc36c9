"""Values of channels under the playhead: what is seen of them, and keys that give them others."""

from __future__ import annotations

from app.timeline.timeline import Timeline
from facemodel.animation.channels import RIGID, channel_of
from facemodel.animation.clip import Animation
from facemodel.animation.editing.expressions import keyed
from facemodel.errors import AnimationError


def refuse_locked(timeline: Timeline, channel: str) -> None:
    """Stop what would change a track that is locked.

    Raises
    ------
    AnimationError
        If it is.
    """
    track = timeline.animation.track(channel)
    if track is not None and track.locked:
        title = channel_of(channel, timeline.document.project.units).title
        raise AnimationError(f"The track of {title} is locked; open its padlock to change it.")


def value_of(timeline: Timeline, channel: str) -> float:
    """What a channel shows under the playhead."""
    if channel in RIGID:
        return timeline.playhead.pose.rigid.get(channel, 0.0)
    return timeline.document.shown.get(channel, 0.0)


def value_text(timeline: Timeline, channel: str) -> str:
    """What a channel shows under the playhead, with its unit."""
    return written_value(value_of(timeline, channel), channel)


def written_value(value: float, channel: str) -> str:
    """A value of a channel with its unit."""
    if channel not in RIGID:
        return f"{value:.2f}"
    unit = RIGID[channel].unit
    return f"{value:.1f}{unit}" if unit == "°" else f"{value:.1f} {unit}"


def with_value(timeline: Timeline, animation: Animation, channel: str, value: float) -> Animation:
    """An animation in which a channel has a key of a value under the playhead, as far as its range allows.

    Raises
    ------
    AnimationError
        If its track is locked.
    """
    state, units = timeline.state, timeline.document.project.units
    refuse_locked(timeline, channel)
    known = channel_of(channel, units)
    kept = min(max(value, known.low), known.high)
    return keyed(animation, timeline.playhead.time, {channel: kept}, units, state.spacing, state.shape)


def key_value(timeline: Timeline, channel: str, value: float) -> None:
    """Give a channel a key of a value under the playhead, in one step."""
    title = channel_of(channel, timeline.document.project.units).title
    timeline.edit(with_value(timeline, timeline.animation, channel, value), f"Key {title}")
