"""What was copied from the timeline: keys, events and marks at times after the first of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from app.timeline.chosen import Chosen, times_of
from app.timeline.moving import riding_expressions
from facemodel.actions import ActionUnit
from facemodel.animation.clip import Animation, KeyExpression
from facemodel.animation.curve import SAME_TIME
from facemodel.animation.editing.clipboard import Copied, copied_keys, pasted_keys
from facemodel.animation.editing.events import free_group, free_key, with_events
from facemodel.animation.editing.selection import Row, span
from facemodel.animation.event import Event


@dataclass(frozen=True)
class Clipping:
    """Things for another place.

    Attributes
    ----------
    keys : by row, at times after the first of all
    offset : of the first key after the first of all, seconds
    events : that start so many seconds after the first of all
    expressions : marks of key expressions, likewise
    """

    keys: Copied
    offset: float = 0.0
    events: tuple[Event, ...] = ()
    expressions: tuple[KeyExpression, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.keys or self.events)


NOTHING_COPIED = Clipping({})


def clipping(animation: Animation, chosen: Chosen) -> Clipping:
    """What is chosen, for another place."""
    reach = times_of(animation, replace(chosen, markers=frozenset(), sounds=frozenset(), ranges=frozenset()))
    if reach is None:
        return NOTHING_COPIED
    begin = reach[0]
    riding = riding_expressions(animation, chosen)
    return Clipping(
        copied_keys(animation, chosen.keys) if chosen.keys else {},
        span(animation, chosen.keys)[0] - begin if chosen.keys else 0.0,
        tuple(replace(e, start=e.start - begin) for e in animation.events if e.key in chosen.events),
        tuple(replace(e, time=e.time - begin) for e in animation.expressions if e.time in riding),
    )


def pasted(
    animation: Animation,
    clip: Clipping,
    time: float,
    onto: Sequence[Row] = (),
    units: Sequence[ActionUnit] = (),
) -> tuple[Animation, Chosen]:
    """An animation with a clipping that begins at a time, and what was put there.

    Parameters
    ----------
    onto : rows that keys of a single one go to instead
    """
    made, keys = pasted_keys(animation, clip.keys, time + clip.offset, onto, units)
    groups: dict[str, str] = {}
    fresh: list[Event] = []
    for event in clip.events:
        key = free_key(made, event.key.rstrip("0123456789 "), [each.key for each in fresh])
        if event.group and event.group not in groups:
            groups[event.group] = free_group(made, event.group.rstrip("0123456789 "))
        fresh.append(replace(event, key=key, group=groups.get(event.group, ""), start=event.start + time))
    made = with_events(made, fresh) if fresh else made
    marks = tuple(replace(mark, time=mark.time + time) for mark in clip.expressions)
    if marks:
        stay = [e for e in made.expressions if all(abs(e.time - mark.time) > SAME_TIME for mark in marks)]
        made = replace(made, expressions=tuple(sorted((*stay, *marks), key=lambda each: each.time)))
    return made, Chosen(
        keys=keys, events=frozenset(each.key for each in fresh), expressions=frozenset(mark.time for mark in marks)
    )
