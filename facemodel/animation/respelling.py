"""An animation when the fields of its face come to have other names."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from facemodel.animation.clip import Animation
from facemodel.animation.event import Event
from facemodel.animation.track import Track


def respelled(animation: Animation, names_now: Callable[[str], tuple[str, ...]]) -> Animation:
    """An animation under other names of channels; the very same if none of its names is touched.

    Parameters
    ----------
    names_now : what becomes of a channel: other names, several if it was split, none if it is gone.  Where two
        become one, the first track stays
    """
    tracks: dict[str, Track] = {}
    for track in animation.tracks:
        for name in names_now(track.channel):
            tracks.setdefault(name, track if name == track.channel else replace(track, channel=name))
    events = tuple(event for each in animation.events if (event := _event(each, names_now)) is not None)
    unchanged = len(tracks) == len(animation.tracks) and len(events) == len(animation.events)
    if unchanged and all(map(_same, (*tracks.values(), *events), (*animation.tracks, *animation.events))):
        return animation
    return replace(animation, tracks=tuple(tracks.values()), events=events)


def _event(event: Event, names_now: Callable[[str], tuple[str, ...]]) -> Event | None:
    channels = tuple(dict.fromkeys(name for channel in event.channels for name in names_now(channel)))
    if channels == event.channels:
        return event
    return replace(event, channels=channels) if channels else None


def _same(one: object, other: object) -> bool:
    return one is other
