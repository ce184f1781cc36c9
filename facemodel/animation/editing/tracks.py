"""Tracks: added, removed, ordered, grouped, muted, soloed and locked."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace

from facemodel.animation.clip import Animation
from facemodel.animation.track import Track


def track_for(animation: Animation, channel: str) -> Track:
    """The track of a channel, an empty one if it has none yet."""
    return animation.track(channel) or Track(channel)


def with_track(animation: Animation, track: Track) -> Animation:
    """An animation with a track in place of the one of its channel, or behind all others."""
    return with_tracks(animation, (track,))


def with_tracks(animation: Animation, tracks: Iterable[Track]) -> Animation:
    """An animation with tracks in place of those of their channels; new ones behind all others."""
    standing = {track.channel: track for track in animation.tracks}
    standing |= {track.channel: track for track in tracks}
    return replace(animation, tracks=tuple(standing.values()))


def without_tracks(animation: Animation, channels: Collection[str]) -> Animation:
    """An animation without the tracks of some channels; locked ones stay."""
    gone = set(channels)
    return replace(
        animation, tracks=tuple(track for track in animation.tracks if track.locked or track.channel not in gone)
    )


def moved_track(animation: Animation, channel: str, place: int) -> Animation:
    """An animation in which a track stands at another place of the list, counted from 0."""
    others = [track for track in animation.tracks if track.channel != channel]
    moving = [track for track in animation.tracks if track.channel == channel]
    spot = min(max(place, 0), len(others))
    return replace(animation, tracks=(*others[:spot], *moving, *others[spot:]))


def flagged(
    animation: Animation,
    channels: Collection[str],
    *,
    muted: bool | None = None,
    solo: bool | None = None,
    locked: bool | None = None,
    group: str | None = None,
) -> Animation:
    """An animation in which some tracks are muted, soloed, locked or in a group, or no longer are."""
    given = {"muted": muted, "solo": solo, "locked": locked, "group": group}
    changed = {name: value for name, value in given.items() if value is not None}
    wanted = set(channels)
    return replace(
        animation,
        tracks=tuple(
            replace(track, **changed)  # type: ignore[arg-type]
            if track.channel in wanted and any(getattr(track, name) != value for name, value in changed.items())
            else track
            for track in animation.tracks
        ),
    )
