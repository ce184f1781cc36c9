"""Fields about events: the temporal parameters of one, or when, how long and how strong several are."""

from __future__ import annotations

from dataclasses import replace

from app.timeline.readings import (
    length_of_events,
    of_event,
    start_of,
    strength_of_events,
    with_event,
    with_length_of_events,
    with_start,
    with_strength_of_events,
)
from app.timeline.timeline import Timeline
from facemodel.animation.channels import channel_of
from facemodel.animation.event import BRISKEST
from ui.timeline.inspector.field import FieldBar, TimeBar
from ui.timeline.inspector.keys_page import scale_of
from ui.timeline.inspector.page import Page
from ui.widgets.number_scale import NumberScale

LONGEST = 10.0
"""Seconds that a latency reaches on its bar."""

LATENCY = NumberScale(0.0, LONGEST, 0.0, "s", bend=2.0)
BRISKNESS = NumberScale(1.0, BRISKEST, 1.0, "×", bend=2.5)


class EventPage(Page):
    """What the chosen events are."""

    def __init__(self, timeline: Timeline) -> None:
        chosen = [event for event in timeline.animation.events if event.key in timeline.chosen.events]
        single = len(chosen) == 1
        names = {event.group for event in chosen}
        title = next(iter(names)) if len(names) == 1 and next(iter(names)) else "Event" if single else "Events"
        super().__init__(timeline, title)
        self.add(TimeBar(timeline, "Start", start_of, with_start(timeline.document.project.units)))
        if single:
            self._add_parameters()
        else:
            self.add(FieldBar(timeline, "Length", LATENCY, length_of_events, with_length_of_events))
            self.add(
                FieldBar(timeline, "Strength", NumberScale(0.0, 2.0, 1.0), strength_of_events, with_strength_of_events)
            )

    def _add_parameters(self) -> None:
        timeline = self.timeline
        event = next(event for event in timeline.animation.events if event.key in timeline.chosen.events)
        channel = channel_of(event.channels[0], timeline.document.project.units)
        for label, scale, name in (
            ("Onset latency", LATENCY, "onset"),
            ("Acceleration", BRISKNESS, "acceleration"),
            ("Peak amplitude", scale_of(channel), "amplitude"),
            ("Peak latency", LATENCY, "peak"),
            ("Deceleration", BRISKNESS, "deceleration"),
            ("Offset latency", LATENCY, "offset"),
        ):
            read = of_event(lambda event, name=name: float(getattr(event, name)))  # type: ignore[misc]
            write = with_event(lambda event, value, name=name: replace(event, **{name: value}))  # type: ignore[misc]
            self.add(FieldBar(timeline, label, scale, read, write))
