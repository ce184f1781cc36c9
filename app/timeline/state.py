"""How the timeline is looked at and worked with.  It is no part of the project, so it is neither saved nor undone."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from app.timeline.chosen import Chosen
from facemodel.animation.curve import Shape
from facemodel.animation.displacement import SPACING
from facemodel.animation.timecode import TimeStyle

SnapTarget = Literal["frames", "keys", "markers"]

Mode = Literal["keys", "curves"]


@dataclass(frozen=True)
class TimelineState:
    """What is chosen and how it is shown.

    Attributes
    ----------
    chosen : keys, events, sounds and marks that the next deed is about
    lines : keys of the lines that are chosen at the left, such as ``track 12L``; curves of these are drawn large
    sought : what is searched for among the lines; all are listed if it is empty
    flipped : keys of the groups and tracks that are folded, and of the clips of events that are open
    mode : keys on lines, or curves in one graph
    style : how times are written
    snaps : what moved things snap to
    shape : how curves go on from new keys; as they did there if none
    spacing : seconds between the knots of new layers
    fields : whether the fields at the right are shown; as there is room if none
    page : name of the page of parameters that is open at the right; empty for what is chosen
    """

    chosen: Chosen = field(default_factory=Chosen)
    lines: frozenset[str] = frozenset()
    sought: str = ""
    flipped: frozenset[str] = frozenset()
    mode: Mode = "keys"
    style: TimeStyle = "timecode"
    snaps: frozenset[SnapTarget] = frozenset(("frames",))
    shape: Shape | None = None
    spacing: float = SPACING
    fields: bool | None = None
    page: str = ""
