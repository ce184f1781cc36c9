"""Fields about idle life."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from app.timeline.chosen import Chosen
from app.timeline.moving import Edited
from app.timeline.readings import Reading
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from ui.timeline.inspector.field import FieldBar
from ui.timeline.inspector.page import Page, push_button
from ui.widgets.number_scale import NumberScale

FIELDS = (
    ("Blinks", NumberScale(0.0, 60.0, 15.0, "/min"), "blinks"),
    ("Jumps of the eyes", NumberScale(0.0, 3.0, 1.0, "×"), "saccades"),
    ("Breathing", NumberScale(0.0, 3.0, 1.0, "×"), "breathing"),
    ("Breaths", NumberScale(4.0, 40.0, 14.0, "/min"), "breaths"),
    ("Seed", NumberScale(0.0, 999.0, 1.0, whole=True), "seed"),
)


class LifePage(Page):
    """Idle life and its seed."""

    def __init__(self, timeline: Timeline) -> None:
        super().__init__(timeline, "Idle life")
        for label, scale, name in FIELDS:
            self.add(FieldBar(timeline, label, scale, _read(name), _write(name)))
        self.gap()
        self.add(push_button("Another life", self._reseed, "Take the next seed"))

    def _reseed(self) -> None:
        idle = self.timeline.animation.idle
        if idle is not None:
            fresh = replace(idle, seed=(idle.seed + 1) % 1000)
            self.timeline.edit(replace(self.timeline.animation, idle=fresh), "Another seed")


def _read(name: str) -> Callable[[Animation, Chosen], Reading | None]:
    def read(animation: Animation, _chosen: Chosen) -> Reading | None:
        return None if animation.idle is None else Reading(float(getattr(animation.idle, name)))

    return read


def _write(name: str) -> Callable[[Animation, Chosen, float], Edited]:
    def write(animation: Animation, chosen: Chosen, value: float) -> Edited:
        if animation.idle is None:
            return animation, chosen
        given = round(value) if name == "seed" else value
        return replace(animation, idle=replace(animation.idle, **{name: given})), chosen

    return write
