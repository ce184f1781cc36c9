"""What every gesture on the timeline has, and where the hand is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol


@dataclass(frozen=True)
class Spot:
    """Where the pointer is.

    Attributes
    ----------
    time : under it, seconds
    value : under it, in the unit of the curve; 0 where only time counts
    reach, rise : seconds and value that the tip of the pointer covers
    shift, control, alt : keys that are held
    x, y : pixels
    """

    time: float
    value: float = 0.0
    reach: float = 0.0
    rise: float = 0.0
    shift: bool = False
    control: bool = False
    alt: bool = False
    x: float = 0.0
    y: float = 0.0


class Gesture(Protocol):
    """A gesture that has begun."""

    @property
    def advice(self) -> str:
        """What keys change about it, for the status line."""

    def move(self, spot: Spot) -> None:
        """The hand goes on."""

    def release(self, spot: Spot) -> None:
        """The hand lets go: what was done stays."""

    def cancel(self) -> None:
        """All is as it was before."""
