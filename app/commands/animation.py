"""Steps that change what happens over time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any

import numpy as np

from app.commands.command import ITEM_BYTES, Command
from app.commands.keyed import KeyedDelta, keyed_delta
from facemodel.animation.clip import Animation
from facemodel.animation.event import Event
from facemodel.animation.track import Track
from facemodel.project import Project
from facemodel.sameness import same

PARTS = tuple(each.name for each in fields(Animation) if each.name not in ("tracks", "events"))
"""Members that are replaced as a whole."""

Parts = Mapping[str, Any]


@dataclass(frozen=True, eq=False)
class EditAnimation:
    """Change, add, remove or reorder tracks and events, and replace other members.

    A track that changes shares with its successor what it has in common, a captured curve above all.

    Attributes
    ----------
    label : what a person calls it
    tracks, events : what is different, by channel and key
    before, after : the other members that are different, by name
    gesture : steps with the same gesture in a row are one step; empty for a step of its own
    """

    label: str
    tracks: KeyedDelta[Track] = field(default_factory=KeyedDelta)
    events: KeyedDelta[Event] = field(default_factory=KeyedDelta)
    before: Parts = field(default_factory=dict)
    after: Parts = field(default_factory=dict)
    gesture: str = ""

    @cached_property
    def cost(self) -> int:
        """Bytes that only this command keeps alive: arrays that stand on one side alone."""
        old, new = (dict(_arrays(tuple(each.values()))) for each in (self.tracks.before, self.tracks.after))
        arrays = sum(array.nbytes for key, array in {**old, **new}.items() if key not in old or key not in new)
        items = sum(len(delta.before) + len(delta.after) for delta in (self.tracks, self.events))
        spoken = sum(len(parts["speech"].phonemes) for parts in (self.before, self.after) if "speech" in parts)
        return arrays + ITEM_BYTES * (items + len(self.after) + spoken)

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return self.tracks.changes or self.events.changes or bool(self.after)

    def do(self, project: Project) -> Project:
        """The project with the new values."""
        animation = project.animation
        return _with(
            project,
            self.tracks.do(animation.tracks, track_name),
            self.events.do(animation.events, event_name),
            self.after,
        )

    def undo(self, project: Project) -> Project:
        """The project with the old values."""
        animation = project.animation
        return _with(
            project,
            self.tracks.undo(animation.tracks, track_name),
            self.events.undo(animation.events, event_name),
            self.before,
        )

    def joined(self, later: Command) -> Command | None:
        """Both as one step if they belong to one gesture."""
        if not isinstance(later, EditAnimation) or not self.gesture or later.gesture != self.gesture:
            return None
        before, after = {**later.before, **self.before}, {**self.after, **later.after}
        moved = [name for name in after if not same(before[name], after[name])]
        return EditAnimation(
            later.label,
            self.tracks.then(later.tracks),
            self.events.then(later.events),
            {name: before[name] for name in moved},
            {name: after[name] for name in moved},
            self.gesture,
        )


def edit_animation(before: Animation, after: Animation, label: str, gesture: str = "") -> EditAnimation:
    """The step from one animation to another; tracks and events that are the same objects are the same."""
    if before is after:
        return EditAnimation(label, gesture=gesture)
    moved = [name for name in PARTS if not same(getattr(before, name), getattr(after, name))]
    return EditAnimation(
        label,
        keyed_delta(before.tracks, after.tracks, track_name),
        keyed_delta(before.events, after.events, event_name),
        {name: getattr(before, name) for name in moved},
        {name: getattr(after, name) for name in moved},
        gesture,
    )


def track_name(track: Track) -> str:
    """What a track is told apart by."""
    return track.channel


def event_name(event: Event) -> str:
    """What an event is told apart by."""
    return event.key


def _with(project: Project, tracks: tuple[Track, ...], events: tuple[Event, ...], parts: Parts) -> Project:
    return replace(project, animation=replace(project.animation, tracks=tracks, events=events, **parts))


def _arrays(value: Any) -> Iterator[tuple[int, np.ndarray[Any, Any]]]:
    """All arrays in tracks, at any depth, by identity."""
    if isinstance(value, np.ndarray):
        yield id(value), value
    elif isinstance(value, tuple):
        for item in value:
            yield from _arrays(item)
    elif hasattr(value, "__dataclass_fields__"):
        for member in fields(value):
            yield from _arrays(getattr(value, member.name))
