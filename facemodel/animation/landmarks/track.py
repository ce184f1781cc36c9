"""Landmarks over time as a face tracker saw them: points of a face mesh in a picture."""

from __future__ import annotations

from dataclasses import dataclass

from fem.types import FloatArray

MESH, WITH_IRISES = 468, 478
"""Points of MediaPipe's face mesh, without and with five for each iris."""


@dataclass(frozen=True, eq=False)
class LandmarkTrack:
    """What a tracker of landmarks saw.

    Attributes
    ----------
    points : (N, 468 or 478, 3) of each frame, in the order of MediaPipe: x to the right in the picture, which is the
        subject's left, y down, z away from the camera, all in the same unit, whatever it is
    rate : frames per second
    notes : one sentence each for what was missing, bridged or taken for granted
    """

    points: FloatArray
    rate: float
    notes: tuple[str, ...] = ()

    @property
    def irises(self) -> bool:
        """Whether the irises are among the points."""
        return len(self.points[0]) == WITH_IRISES
