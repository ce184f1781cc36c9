"""Moving, stretching, removing and mirroring whatever is chosen: keys, events, sounds and marks together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TypeVar

from app.timeline.chosen import Chosen
from facemodel.actions import ActionUnit
from facemodel.animation.channels import RIGID, mirrored
from facemodel.animation.clip import Animation, KeyExpression, Marker, NamedRange
from facemodel.animation.curve import SAME_TIME
from facemodel.animation.editing.bulk import SMALLEST_FACTOR, deleted_keys, moved_keys, scaled_keys
from facemodel.animation.editing.clipboard import mirrored_keys
from facemodel.animation.editing.events import changed_events, moved_events, stretched_events, without_events
from facemodel.animation.editing.expressions import expression_keys
from facemodel.animation.editing.selection import Selection, unlocked
from facemodel.animation.editing.speech import SHORTEST, with_speech, without_phonemes
from facemodel.animation.event import Event

Edited = tuple[Animation, Chosen]
Way = Callable[[float], float]
"""Where a time goes."""

Mark = TypeVar("Mark", KeyExpression, Marker)


def moved(
    animation: Animation, chosen: Chosen, seconds: float, rise: float = 0.0, units: Sequence[ActionUnit] = ()
) -> Edited:
    """Everything chosen, later by seconds, and keys higher by a rise."""
    riding = riding_expressions(animation, chosen)
    made, keys = moved_keys(animation, chosen.keys, seconds, rise, units)
    made = moved_events(made, chosen.events, seconds) if chosen.events else made
    made = _sounds_moved(made, chosen.sounds, seconds)
    return _marks_moved(made, replace(chosen, keys=keys), riding, lambda time: time + seconds)


def scaled(
    animation: Animation, chosen: Chosen, about: float, factor: float, units: Sequence[ActionUnit] = ()
) -> Edited:
    """Everything chosen but sounds, drawn apart in time about a moment by a factor."""
    riding = riding_expressions(animation, chosen)
    kept = max(factor, SMALLEST_FACTOR)
    made, keys = scaled_keys(animation, chosen.keys, (about, 0.0), (kept, 1.0), units)
    made = stretched_events(made, chosen.events, about, kept) if chosen.events else made
    return _marks_moved(made, replace(chosen, keys=keys), riding, lambda time: about + kept * (time - about))


def deleted(animation: Animation, chosen: Chosen) -> Animation:
    """An animation without what is chosen; a key expression goes with the last of its keys."""
    gone = riding_expressions(animation, chosen)
    made = deleted_keys(animation, chosen.keys) if chosen.keys else animation
    made = without_events(made, chosen.events) if chosen.events else made
    made = without_phonemes(made, sorted(chosen.sounds)) if chosen.sounds else made
    return replace(
        made,
        expressions=tuple(each for each in made.expressions if each.time not in gone),
        markers=tuple(each for each in made.markers if each.time not in chosen.markers),
        ranges=tuple(each for each in made.ranges if each.name not in chosen.ranges),
    )


def on_other_side(animation: Animation, chosen: Chosen, units: Sequence[ActionUnit] = ()) -> Edited:
    """Keys and events that are chosen, moved to the other side of the face; what is chosen of both changes places."""
    made, keys = mirrored_keys(animation, chosen.keys, units) if chosen.keys else (animation, chosen.keys)
    made = changed_events(made, chosen.events, _event_mirrored) if chosen.events else made
    return made, replace(chosen, keys=keys)


def riding_expressions(animation: Animation, chosen: Chosen) -> frozenset[float]:
    """Times of the key expressions that are chosen, or of which every key is that is not locked."""
    return chosen.expressions | {
        each.time for each in animation.expressions if _all_chosen(animation, each.time, chosen.keys)
    }


def _all_chosen(animation: Animation, time: float, chosen: Selection) -> bool:
    keys = expression_keys(animation, time)
    free = unlocked(animation, keys)
    return bool(free) and all(set(keys[row]) <= set(chosen.get(row, ())) for row in free)


def _marks_moved(animation: Animation, chosen: Chosen, riding: frozenset[float], way: Way) -> Edited:
    """Key expressions, markers and ranges where a way takes them; those they land on give way."""
    expressions = [replace(e, time=way(e.time)) if e.time in riding else e for e in animation.expressions]
    markers = [replace(m, time=way(m.time)) if m.time in chosen.markers else m for m in animation.markers]
    ranges = [
        replace(each, start=way(each.start), end=way(each.end)) if each.name in chosen.ranges else each
        for each in animation.ranges
    ]
    carried = frozenset(map(way, riding))
    marked = frozenset(map(way, chosen.markers))
    made = replace(
        animation,
        expressions=_apart(expressions, carried) if riding else animation.expressions,
        markers=_apart(markers, marked) if chosen.markers else animation.markers,
        ranges=tuple(sorted(ranges, key=_start)) if chosen.ranges else animation.ranges,
    )
    return made, replace(chosen, expressions=carried if chosen.expressions else frozenset(), markers=marked)


def _start(each: NamedRange) -> float:
    return each.start


def _apart(marks: Iterable[Mark], moved: frozenset[float]) -> tuple[Mark, ...]:
    """Marks in the order of time; of two at one time the one that moved stays."""
    found: list[Mark] = []
    for mark in sorted(marks, key=lambda each: (each.time, each.time in moved)):
        if found and mark.time - found[-1].time <= SAME_TIME:
            found.pop()
        found.append(mark)
    return tuple(found)


def _sounds_moved(animation: Animation, places: frozenset[int], seconds: float) -> Animation:
    """Sounds later by seconds, as far as their neighbours leave room; what they push into is cut shorter."""
    sounds = list(animation.speech.phonemes)
    if not places or not sounds:
        return animation
    first, last = min(places), max(places)
    room = sounds[first - 1].start + SHORTEST - sounds[first].start if first else float("-inf")
    limit = sounds[last + 1].end - SHORTEST - sounds[last].end if last + 1 < len(sounds) else float("inf")
    shift = min(max(seconds, room), limit)
    for place in places:
        sounds[place] = replace(sounds[place], start=sounds[place].start + shift, end=sounds[place].end + shift)
    if first:
        before = sounds[first - 1]
        sounds[first - 1] = replace(before, end=min(before.end, sounds[first].start))
    if last + 1 < len(sounds):
        after = sounds[last + 1]
        sounds[last + 1] = replace(after, start=max(after.start, sounds[last].end))
    return with_speech(animation, replace(animation.speech, phonemes=tuple(sounds)))


def _event_mirrored(event: Event) -> Event:
    flips = all(name in RIGID and RIGID[name].flips for name in event.channels)
    channels = tuple(dict.fromkeys(map(mirrored, event.channels)))
    return replace(event, channels=channels, amplitude=-event.amplitude if flips else event.amplitude)
