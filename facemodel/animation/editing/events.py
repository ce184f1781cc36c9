"""Events: placed, moved, stretched, changed and removed, alone or as the group that they were placed in."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from dataclasses import replace

from facemodel.animation.clip import Animation
from facemodel.animation.event import BRISKEST, SHORTEST, Event


def free_key(animation: Animation, wanted: str, also: Collection[str] = ()) -> str:
    """A key that no event has, made of the one that is wanted."""
    taken = {event.key for event in animation.events} | set(also)
    number = 1
    while f"{wanted} {number}" in taken:
        number += 1
    return f"{wanted} {number}"


def free_group(animation: Animation, wanted: str) -> str:
    """The name of a group that no event is in, made of the one that is wanted."""
    taken = {event.group for event in animation.events}
    if wanted not in taken:
        return wanted
    number = 2
    while f"{wanted} {number}" in taken:
        number += 1
    return f"{wanted} {number}"


def sound(event: Event) -> Event:
    """The event with its latencies in order and its acceleration and deceleration possible."""
    peak = max(event.peak, event.onset)
    return replace(
        event,
        peak=peak,
        offset=max(event.offset, peak),
        acceleration=min(max(event.acceleration, 1.0), BRISKEST),
        deceleration=min(max(event.deceleration, 1.0), BRISKEST),
    )


def with_events(animation: Animation, events: Iterable[Event]) -> Animation:
    """An animation with events in place of those of their keys, or behind all others."""
    standing = {event.key: event for event in animation.events}
    standing |= {event.key: sound(event) for event in events}
    return replace(animation, events=tuple(standing.values()))


def with_event(
    animation: Animation, channels: tuple[str, ...], start: float, amplitude: float = 1.0
) -> tuple[Animation, str]:
    """An animation with a new event as long as a quick expression lasts, and its key."""
    key = free_key(animation, "event")
    return with_events(animation, (Event(key, channels, start, amplitude=amplitude),)), key


def without_events(animation: Animation, keys: Collection[str]) -> Animation:
    """An animation without some events."""
    gone = set(keys)
    return replace(animation, events=tuple(event for event in animation.events if event.key not in gone))


def group_of(animation: Animation, key: str) -> tuple[str, ...]:
    """Keys of the events that were placed together with one; its own alone if it has no group."""
    group = next((event.group for event in animation.events if event.key == key), "")
    return tuple(event.key for event in animation.events if event.key == key or (group and event.group == group))


def changed_events(animation: Animation, keys: Collection[str], change: Callable[[Event], Event]) -> Animation:
    """An animation with some events changed."""
    wanted = set(keys)
    return replace(
        animation,
        events=tuple(sound(change(event)) if event.key in wanted else event for event in animation.events),
    )


def moved_events(animation: Animation, keys: Collection[str], seconds: float) -> Animation:
    """An animation with some events later by seconds."""
    return changed_events(animation, keys, lambda event: replace(event, start=event.start + seconds))


def stretched_events(animation: Animation, keys: Collection[str], about: float, factor: float) -> Animation:
    """An animation in which some events take longer by a factor, and stand farther from a time by it."""
    kept = max(factor, SHORTEST)
    return changed_events(
        animation,
        keys,
        lambda event: replace(
            event,
            start=about + kept * (event.start - about),
            onset=kept * event.onset,
            peak=kept * event.peak,
            offset=kept * event.offset,
        ),
    )


def with_rise(event: Event, full: float) -> Event:
    """The event that has risen at a time of the clip: what dragging the end of its rise does."""
    reach = max(event.peak - event.onset, SHORTEST)
    return sound(replace(event, acceleration=reach / max(full - event.begins, reach / BRISKEST)))


def with_fall(event: Event, begins: float) -> Event:
    """The event that begins to fall at a time of the clip: what dragging the start of its fall does."""
    reach = max(event.offset - event.peak, SHORTEST)
    return sound(replace(event, deceleration=reach / max(event.ends - begins, reach / BRISKEST)))
