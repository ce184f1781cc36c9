"""A captured performance as it came from a tracker: named channels of numbers at even steps of time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from fem.types import Float32Array

CaptureKind = Literal["openface", "live-link", "arkit", "fap", "landmarks", "plain"]
"""Where it comes from; each has a mapping table of its own."""

KIND_TITLES: dict[CaptureKind, str] = {
    "openface": "OpenFace",
    "live-link": "Live Link Face",
    "arkit": "ARKit or MediaPipe",
    "fap": "MPEG-4 face animation",
    "landmarks": "Landmarks of MediaPipe",
    "plain": "Weights of action units",
}


@dataclass(frozen=True, eq=False)
class Capture:
    """What a tracker saw.

    Attributes
    ----------
    kind : which mapping table it is meant for
    channels : (C,) names in the spelling of that table
    values : (N, C)
    rate : frames per second
    start : time of the first frame, seconds
    notes : one sentence each for what was missing, bridged or taken for granted
    rest : when the face was taken to be at rest, seconds from the first frame; none where it is not compared with one
    """

    kind: CaptureKind
    channels: tuple[str, ...]
    values: Float32Array
    rate: float
    start: float = 0.0
    notes: tuple[str, ...] = ()
    rest: float | None = None

    @property
    def duration(self) -> float:
        """Seconds from the first frame to the last."""
        return max(len(self.values) - 1, 0) / self.rate
