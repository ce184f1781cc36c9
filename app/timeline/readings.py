"""What the fields of the timeline say about what is chosen, and what other numbers in them do.  Pure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.timeline.chosen import Chosen, times_of
from app.timeline.moving import Edited, moved
from facemodel.actions import ActionUnit
from facemodel.animation.channels import RIGID, Channel, channel_of
from facemodel.animation.clip import Animation
from facemodel.animation.editing.bulk import valued_keys
from facemodel.animation.editing.events import changed_events, sound, stretched_events, with_events
from facemodel.animation.editing.keys import with_handles
from facemodel.animation.editing.selection import curve_of_row, with_row
from facemodel.animation.editing.tracks import with_track
from facemodel.animation.event import Event


@dataclass(frozen=True)
class Reading:
    """A number, which stands for several different ones where it is mixed."""

    value: float
    mixed: bool = False


Read = Callable[[Animation, Chosen], Reading | None]
"""What a field says; none where it has nothing to say."""

Write = Callable[[Animation, Chosen, float], Edited]
"""What another number in a field makes of an animation."""


def start_of(animation: Animation, chosen: Chosen) -> Reading | None:
    """When the first of all chosen things is."""
    reach = times_of(animation, chosen)
    return None if reach is None else Reading(reach[0])


def with_start(units: Sequence[ActionUnit]) -> Write:
    """All chosen things moved so that the first is at a time."""

    def write(animation: Animation, chosen: Chosen, time: float) -> Edited:
        reach = times_of(animation, chosen)
        return (animation, chosen) if reach is None else moved(animation, chosen, time - reach[0], 0.0, units)

    return write


def value_of_keys(animation: Animation, chosen: Chosen) -> Reading | None:
    """The value of the chosen keys."""
    values = [curve_of_row(animation, row).values[list(places)] for row, places in chosen.keys.items() if places]
    if not values:
        return None
    every = np.concatenate(values)
    return Reading(float(every[0]), bool(np.ptp(every) > 1e-9))


def with_value_of_keys(units: Sequence[ActionUnit]) -> Write:
    """All chosen keys at one value."""

    def write(animation: Animation, chosen: Chosen, value: float) -> Edited:
        made, keys = valued_keys(animation, chosen.keys, value, units)
        return made, replace(chosen, keys=keys)

    return write


def channel_of_keys(chosen: Chosen, units: Sequence[ActionUnit]) -> Channel | None:
    """The range and unit that all chosen keys share; none if they have different ones."""
    found = {(each.low, each.high, each.unit): each for each in (channel_of(row[0], units) for row in chosen.keys)}
    if len(found) > 1 and not any(each.rigid for each in found.values()):
        return max(found.values(), key=lambda each: each.high)
    return next(iter(found.values())) if len(found) == 1 else None


def handle_of_key(number: int) -> Read:
    """One of the four numbers of the handles of a single key: seconds and value behind, seconds and value ahead."""

    def read(animation: Animation, chosen: Chosen) -> Reading | None:
        if chosen.key_count != 1:
            return None
        ((row, (place,)),) = chosen.keys.items()
        return Reading(
            abs(float(curve_of_row(animation, row).handles[place, number]))
            if number % 2 == 0
            else float(curve_of_row(animation, row).handles[place, number])
        )

    return read


def with_handle_of_key(number: int) -> Write:
    """A single key with another number of its handles."""

    def write(animation: Animation, chosen: Chosen, value: float) -> Edited:
        if chosen.key_count != 1:
            return animation, chosen
        ((row, (place,)),) = chosen.keys.items()
        track, curve = animation.track(row[0]), curve_of_row(animation, row)
        if track is None or track.locked:
            return animation, chosen
        four = curve.handles[place].tolist()
        four[number] = -value if number == 0 else value
        given = {"arrives": (four[0], four[1])} if number < 2 else {"leaves": (four[2], four[3])}
        return with_track(animation, with_row(track, row[1], with_handles(curve, place, **given))), chosen

    return write


def of_event(read: Callable[[Event], float]) -> Read:
    """What a field says about the chosen events."""

    def found(animation: Animation, chosen: Chosen) -> Reading | None:
        values = [read(event) for event in animation.events if event.key in chosen.events]
        if not values:
            return None
        return Reading(values[0], max(values) - min(values) > 1e-9)

    return found


def with_event(write: Callable[[Event, float], Event]) -> Write:
    """The chosen events with another number."""

    def made(animation: Animation, chosen: Chosen, value: float) -> Edited:
        return changed_events(animation, chosen.events, lambda event: write(event, value)), chosen

    return made


def length_of_events(animation: Animation, chosen: Chosen) -> Reading | None:
    """How long all chosen events take together."""
    reach = times_of(animation, Chosen(events=chosen.events))
    return None if reach is None else Reading(reach[1] - reach[0])


def with_length_of_events(animation: Animation, chosen: Chosen, seconds: float) -> Edited:
    """All chosen events stretched to a length."""
    reach = times_of(animation, Chosen(events=chosen.events))
    if reach is None or reach[1] <= reach[0]:
        return animation, chosen
    return stretched_events(animation, chosen.events, reach[0], seconds / (reach[1] - reach[0])), chosen


def strength_of_events(animation: Animation, chosen: Chosen) -> Reading | None:
    """The largest weight among the chosen events; degrees or millimetres where they turn nothing but the head."""
    events = [event for event in animation.events if event.key in chosen.events]
    weights = [abs(event.amplitude) for event in events if not RIGID.keys() & set(event.channels)]
    sizes = weights or [abs(event.amplitude) for event in events]
    return Reading(max(sizes)) if sizes else None


def with_strength_of_events(animation: Animation, chosen: Chosen, strength: float) -> Edited:
    """All chosen events stronger or weaker together, so that the largest has an amplitude."""
    own = strength_of_events(animation, chosen)
    if own is None or own.value <= 0:
        return animation, chosen
    factor = strength / own.value
    events = [event for event in animation.events if event.key in chosen.events]
    made = (sound(replace(event, amplitude=factor * event.amplitude)) for event in events)
    return with_events(animation, made), chosen
