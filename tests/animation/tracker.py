"""A tracker that makes no mistakes: the places of a face as it is posed, as MediaPipe would tell them of a picture."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.actions import Expression
from facemodel.animation.landmarks import WITH_IRISES
from facemodel.animation.landmarks.gaze import CORNERS, REACH
from facemodel.animation.landmarks.places import irises, places_on
from facemodel.kinematics import rig_of
from facemodel.project import Project
from facemodel.solution import Solution
from facemodel.superposition import Superposition

PIXELS = 1.3
"""Of the picture in a millimetre."""

CORNER = np.array([640.0, 360.0, 0.0])
"""Where the middle of the head is in the picture, pixels."""


@dataclass(frozen=True)
class Shown:
    """What a face does in a frame: weights, degrees of the head as its channels count them, and of both eyes."""

    weights: Expression = field(default_factory=dict)
    head: tuple[float, float, float] = (0.0, 0.0, 0.0)
    look: tuple[float, float] = (0.0, 0.0)


def seen(project: Project, solution: Solution, frames: Sequence[Shown]) -> np.ndarray:
    """Landmarks (N, 478, 3); points of the mesh that no place is known for are all in the middle of the face."""
    places = places_on(project.face, solution.basis.display)
    posed = Superposition(project.face, solution.basis, rig_of(project.units))
    found = np.zeros((len(frames), WITH_IRISES, 3))
    for frame, shown in zip(found, frames, strict=True):
        posed.pose(shown.weights)
        points = posed.points[places.points].astype(np.float64)
        frame[:] = points.mean(axis=0)
        frame[places.indices] = points
        _look(frame, shown.look)
        yaw, pitch, roll = shown.head
        frame[:] = Rotation.from_euler("YXZ", [yaw, -pitch, -roll], degrees=True).apply(frame)
    return found * [PIXELS, -PIXELS, -PIXELS] + CORNER


def _look(frame: np.ndarray, look: tuple[float, float]) -> None:
    for side, iris in irises().items():
        outer, inner = (frame[corner] for corner in CORNERS[side])
        reach = REACH * np.linalg.norm(outer - inner)
        frame[iris] = (outer + inner) / 2 + reach * np.append(np.sin(np.radians(look)), 0.0)
