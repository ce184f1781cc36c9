"""The same smile three times: how it comes and goes decides what it means."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from facemodel.animation.clip import Animation
from facemodel.animation.editing.events import free_group, with_events
from facemodel.animation.editing.marks import with_marker, with_range
from facemodel.animation.event import Event
from facemodel.animation.idle import Idle
from facemodel.project import Project
from facemodel.projects import new_project


@dataclass(frozen=True)
class Smile:
    """How one of the smiles comes and goes.

    Attributes
    ----------
    name : for people
    start, lasts : seconds
    corners, cheeks : how far the lip corners and the cheeks go
    acceleration, peak : of the rise: how many times faster than it has to be, and when it is full at the latest
    deceleration : of the fall
    late : seconds by which the left side comes after the right one
    """

    name: str
    start: float
    lasts: float
    corners: float
    cheeks: float
    acceleration: float
    peak: float
    deceleration: float
    late: float = 0.0


SMILES = (
    Smile("Polite: there at once, gone at once", 0.8, 1.8, 0.7, 0.0, 6.0, 0.9, 6.0),
    Smile("Warm: comes slowly, with the eyes, and lingers", 3.6, 3.4, 0.85, 0.8, 1.3, 1.1, 1.2),
    Smile("Mocking: one side first", 8.0, 2.6, 0.65, 0.1, 2.5, 0.9, 2.0, late=0.35),
)


def timing_project(_folder: Path) -> Project:
    """A face that smiles three times, each a group of events with a marker and a named range."""
    project = new_project()
    animation = Animation(end=11.4, idle=Idle(seed=11, blinks=10.0))
    for smile in SMILES:
        animation = _placed(animation, smile)
    return replace(project, animation=animation)


def _placed(animation: Animation, smile: Smile) -> Animation:
    group = free_group(animation, smile.name.partition(":")[0])
    parts = [("12R", smile.corners, 0.0), ("12L", smile.corners, smile.late)]
    parts += [(field, smile.cheeks, 0.1) for field in ("6R", "6L") if smile.cheeks]
    events = [
        Event(
            key=f"{group} {field}",
            channels=(field,),
            start=smile.start,
            onset=late,
            acceleration=smile.acceleration,
            amplitude=amplitude,
            peak=late + smile.peak,
            deceleration=smile.deceleration,
            offset=smile.lasts - 0.1 * (field[0] == "6"),
            group=group,
        )
        for field, amplitude, late in parts
    ]
    made = with_marker(with_events(animation, events), smile.start, smile.name)
    return with_range(made, group, smile.start, smile.start + smile.lasts)
