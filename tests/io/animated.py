"""A small face with a clip that moves everything: skin, jaw, eyes and head, and a unit beyond its full strength."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from facemodel.animation.clip import Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.take import Take, take
from facemodel.animation.track import Track
from facemodel.eyeball import eyeball
from facemodel.kinematics import rig_of
from facemodel.project import Project
from facemodel.solve import Solution, solve_project
from facemodel.superposition import Superposition
from tests.io.small_project import small_project

PEAKS = {
    "12L": 1.6,
    "26": 0.9,
    "head.yaw": 25.0,
    "head.pitch": -10.0,
    "head.roll": 8.0,
    "head.z": 12.0,
    "eyeL.yaw": 15.0,
    "eyeR.yaw": 18.0,
    "eyeR.pitch": 9.0,
}
"""The largest value of every channel, which it reaches in the middle of the clip."""


def animated_project() -> Project:
    tracks = tuple(
        Track(name, curve_of([Key(0, 0.0), Key(0.5, peak), Key(1, 0.1 * peak)])) for name, peak in PEAKS.items()
    )
    return replace(small_project(), animation=Animation(tracks, rate=12.0, end=1.0))


PROJECT = animated_project()
SOLUTION: Solution = solve_project(PROJECT)


def played() -> Take:
    return take(PROJECT)


def shown(clip: Take) -> Iterator[dict[str, np.ndarray]]:
    """Where the editor has every mesh in each frame of a clip, millimetres."""
    face = PROJECT.face
    pose = Superposition(face, SOLUTION.basis, rig_of(PROJECT.units))
    for frame in range(len(clip)):
        pose.turned = clip.rigid(frame)
        pose.pose(clip.expression(frame))
        stands = pose.stance
        places = {"skin": moved(stands.head, pose.points)}
        places |= {name: moved(stands.head, points) for name, points in pose.parts.items()}
        for eye, turn in zip(face.eyes, stands.eyes, strict=True):
            side = {"L": "left", "R": "right"}[eye.side]
            for layer, (mesh, _) in (("eye", eyeball(eye).opaque), ("cornea", eyeball(eye).cornea)):
                places[f"{layer}-{side}"] = moved(stands.head @ turn, mesh.positions)
        yield places


def moved(motion: np.ndarray, points: np.ndarray) -> np.ndarray:
    return np.asarray(points @ motion[:3, :3].T + motion[:3, 3])
