"""One entry of the timeline's table, and the action of the editor that it becomes for one timeline."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from app.actions.action import Action
from app.timeline.keying import chosen_channels
from app.timeline.timeline import Timeline

MENU = "Animation"

Possible = Callable[[Timeline], bool]


def always(_timeline: Timeline) -> bool:
    """At any time."""
    return True


def with_keys(timeline: Timeline) -> bool:
    """While keys are chosen."""
    return bool(timeline.chosen.keys)


def with_keys_or_events(timeline: Timeline) -> bool:
    """While keys or events are chosen."""
    return bool(timeline.chosen.keys or timeline.chosen.events)


def with_tracks(timeline: Timeline) -> bool:
    """While tracks are chosen."""
    return bool(chosen_channels(timeline))


def with_things(timeline: Timeline) -> bool:
    """While things other than tracks are chosen."""
    return bool(timeline.chosen)


def with_anything(timeline: Timeline) -> bool:
    """While anything is chosen."""
    return bool(timeline.chosen) or with_tracks(timeline)


def with_capture(timeline: Timeline) -> bool:
    """While a track with a captured curve is chosen."""
    channels = chosen_channels(timeline)
    track = timeline.animation.track(channels[0]) if channels else None
    return track is not None and track.captured is not None


@dataclass(frozen=True)
class Entry:
    """Something that can be done with a timeline.

    Attributes
    ----------
    key : unique in the table
    title, hint : for people
    run : does it
    possible : whether it is possible now
    shortcut, also : keys of the whole window
    on : for a switch, whether it is on
    caption : its title now, where that changes
    """

    key: str
    title: str
    run: Callable[[Timeline], None]
    hint: str
    possible: Possible = always
    shortcut: str = ""
    also: tuple[str, ...] = ()
    on: Possible | None = None
    caption: Callable[[Timeline], str] | None = None

    def action(self, timeline: Timeline, menu: tuple[str, ...], group: int) -> Action:
        """The action for one timeline, in a submenu of its menu."""
        run, possible, on, caption = self.run, self.possible, self.on, self.caption
        return Action(
            f"timeline.{self.key}",
            self.title,
            lambda _context: run(timeline),
            (MENU, *menu),
            group,
            self.shortcut,
            self.also,
            self.hint,
            "command" if on is None else "toggle",
            lambda _context: possible(timeline),
            lambda _context: on is not None and on(timeline),
            None if caption is None else lambda _context: caption(timeline),
        )
