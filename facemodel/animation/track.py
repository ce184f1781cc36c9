"""A track: all that moves one channel by itself."""

from __future__ import annotations

from dataclasses import dataclass

from facemodel.animation.curve import EMPTY, Curve
from facemodel.animation.displacement import Displacement
from facemodel.animation.samples import Samples


@dataclass(frozen=True, eq=False)
class Track:
    """One channel over time: what was captured, bent by its layers, plus a curve of keys.

    Attributes
    ----------
    channel : what it moves, see `facemodel.animation.channels`
    curve : its keys, added to what was captured
    captured : the dense curve, if it has one; layers leave it as it is
    layers : one over the other, each through its own keys
    muted : whether its channel stands still
    solo : whether only channels like it move
    locked : whether edits leave it alone
    group : tracks of one group are listed together; empty for none
    """

    channel: str
    curve: Curve = EMPTY
    captured: Samples | None = None
    layers: tuple[Displacement, ...] = ()
    muted: bool = False
    solo: bool = False
    locked: bool = False
    group: str = ""
