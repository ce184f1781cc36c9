"""Where moved things come to rest: on frames, on keys that stay, on markers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from app.timeline.chosen import Chosen
from app.timeline.state import SnapTarget
from facemodel.animation.clip import Animation
from facemodel.animation.editing.selection import curve_of_row, rows
from facemodel.animation.timecode import snapped
from fem.types import FloatArray

MOST_TARGETS = 20_000
"""Keys beyond which they lie closer than anybody could mean one of them: a baked capture has one on every frame."""


def _none() -> FloatArray:
    return np.zeros(0)


@dataclass(frozen=True, eq=False)
class Snapping:
    """Where times snap to.

    Attributes
    ----------
    rate : frames per second, if whole frames are wanted; else none
    places : (n,) times in order that draw what comes near
    """

    rate: float | None = None
    places: FloatArray = field(default_factory=_none)

    def time(self, time: float, reach: float) -> float:
        """Where a time comes to rest: on a place within reach, else on the nearest frame, else where it is."""
        if len(self.places):
            after = int(np.searchsorted(self.places, time))
            near = self.places[max(after - 1, 0) : after + 1]
            best = float(near[np.abs(near - time).argmin()])
            if abs(best - time) <= reach:
                return best
        return time if self.rate is None else snapped(time, self.rate)


FREE = Snapping()
"""Nothing snaps."""


def snapping(
    animation: Animation, targets: Iterable[SnapTarget], moving: Chosen, also: Iterable[float] = ()
) -> Snapping:
    """What things that move snap to.

    Parameters
    ----------
    targets : kinds of places
    moving : what moves itself and is no place to come to rest at
    also : further times, such as that of the playhead
    """
    wanted = frozenset(targets)
    places: list[FloatArray] = [np.array(list(also), dtype=np.float64)] if wanted else []
    if "keys" in wanted:
        places += _keys(animation, moving)
        places += [np.array([e.begins, e.ends]) for e in animation.events if e.key not in moving.events]
    if "markers" in wanted:
        marks = [each.time for each in animation.markers if each.time not in moving.markers]
        ends = [end for each in animation.ranges if each.name not in moving.ranges for end in (each.start, each.end)]
        places.append(np.array([*marks, *ends, animation.start, animation.end]))
    rate = animation.rate if "frames" in wanted else None
    return Snapping(rate, np.unique(np.concatenate(places)) if places else np.zeros(0))


def _keys(animation: Animation, moving: Chosen) -> list[FloatArray]:
    found: list[FloatArray] = []
    count = 0
    for row in rows(animation):
        times = curve_of_row(animation, row).times
        stays = np.ones(len(times), dtype=np.bool_)
        stays[list(moving.keys.get(row, ()))] = False
        count += len(times)
        if count > MOST_TARGETS:
            return []
        found.append(times[stays])
    return found
