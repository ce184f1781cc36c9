"""Dynamic expressions: groups of events that make an emotion, a blink or a nod, to be dropped on the timeline."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from facemodel.actions import ActionUnit, Emotion, expand, resolve
from facemodel.animation.channels import RIGID
from facemodel.animation.clip import Animation
from facemodel.animation.editing.events import free_group, free_key, with_events
from facemodel.animation.event import Event
from facemodel.errors import UnknownNameError
from resources import resource


@dataclass(frozen=True)
class DynamicExpression:
    """Events that belong together, at times after the expression's start.

    Attributes
    ----------
    name : unique
    title : for people
    events : their channels are one name each, of a unit as `facemodel.actions.resolve` knows it or of a rigid motion
    """

    name: str
    title: str
    events: tuple[Event, ...]

    @property
    def duration(self) -> float:
        """Seconds until all of it is over."""
        return max((event.ends for event in self.events), default=0.0)


@cache
def library() -> tuple[DynamicExpression, ...]:
    """The dynamic expressions that ship."""
    raw = json.loads(resource("animation", "library.json").read_text("utf-8"))
    return tuple(
        DynamicExpression(each["name"], each["title"], tuple(_event(k, part) for k, part in enumerate(each["events"])))
        for each in raw["expressions"]
    )


def _event(number: int, part: Mapping[str, object]) -> Event:
    timing = {name: float(str(value)) for name, value in part.items() if name != "unit"}
    return Event(key=str(number), channels=(str(part["unit"]),), start=0.0, **timing)  # type: ignore[arg-type]


def find_expression(name: str) -> DynamicExpression:
    """A dynamic expression by name, whatever its case.

    Raises
    ------
    UnknownNameError
        If there is none.
    """
    for each in library():
        if each.name == name.strip().lower():
            return each
    known = ", ".join(each.name for each in library())
    raise UnknownNameError(f"There is no dynamic expression “{name}”; choose one of {known}.")


def dynamic(emotion: Emotion, units: Sequence[ActionUnit]) -> DynamicExpression:
    """A named expression of the project as a dynamic one: half a second up, a second there, and down again."""
    fields = expand(emotion.weights, units)
    events = tuple(
        Event(str(number), (name,), 0.0, 0.0, 2.0, weight, 1.0, 2.0, 2.4)
        for number, (name, weight) in enumerate(fields.items())
    )
    return DynamicExpression(emotion.name, emotion.title, events)


def placed(
    animation: Animation,
    expression: DynamicExpression,
    time: float,
    units: Sequence[ActionUnit],
    strength: float = 1.0,
    duration: float | None = None,
) -> tuple[Animation, str]:
    """An animation with a dynamic expression at a time, and the name of the group that its events are in.

    Parameters
    ----------
    units : of the face; events of units that it does not have are left out
    strength : by which all amplitudes are multiplied
    duration : seconds that it takes; as it is written if not given
    """
    group = free_group(animation, expression.title)
    stretch = 1.0 if duration is None or expression.duration <= 0 else max(duration, 0.01) / expression.duration
    made: list[Event] = []
    for event in expression.events:
        channels = _channels(event.channels, units)
        if channels:
            key = free_key(animation, expression.name, [each.key for each in made])
            made.append(
                replace(
                    event,
                    key=key,
                    channels=channels,
                    start=time,
                    onset=stretch * event.onset,
                    peak=stretch * event.peak,
                    offset=stretch * event.offset,
                    amplitude=strength * event.amplitude,
                    group=group,
                )
            )
    return with_events(animation, made), group


def _channels(names: Sequence[str], units: Sequence[ActionUnit]) -> tuple[str, ...]:
    found: list[str] = []
    for name in names:
        if name in RIGID:
            found.append(name)
            continue
        try:
            found += resolve(name, units)
        except UnknownNameError:
            continue
    return tuple(found)
