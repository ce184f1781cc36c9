"""The clip that is tried: the default face smiles, blinks, opens its jaw, shows its tongue and turns eyes and head."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from facemodel.animation.clip import Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.take import take
from facemodel.animation.track import Track
from facemodel.cache import solve_cached
from facemodel.eyeball import eyeball
from facemodel.io.export import Asked, export_project
from facemodel.kinematics import rig_of
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solve import Solution
from facemodel.superposition import Superposition

RATE = 24.0
FRAMES = (0, 11, 24, 37)
"""Those that are compared; in the third everything is at its peak."""

PEAKS = {
    "12L": 1.3,
    "12R": 0.9,
    "43L": 1.0,
    "43R": 0.6,
    "26": 0.8,
    "19": 0.7,
    "4L": 0.7,
    "head.yaw": 20.0,
    "head.pitch": -8.0,
    "head.roll": 6.0,
    "head.x": 10.0,
    "eyeL.yaw": -20.0,
    "eyeR.yaw": -18.0,
    "eyeL.pitch": 8.0,
}

FILES = {
    "units.glb": Asked(rate=RATE),
    "clip.glb": Asked(rate=RATE, shaping="clip"),
    "still.glb": Asked(animated=False),
    "units.usdc": Asked(rate=RATE),
    "clip.usdc": Asked(rate=RATE, shaping="clip"),
}
"""What is exported, and how."""


def written(folder: Path) -> tuple[Project, Solution]:
    """Export the clip in every way into a folder."""
    tracks = tuple(
        Track(name, curve_of([Key(0, 0.0), Key(1, peak), Key(2, 0.2 * peak)])) for name, peak in PEAKS.items()
    )
    project = replace(new_project(), animation=Animation(tracks, rate=RATE, end=2.0))
    solution = solve_cached(project)
    for name, asked in FILES.items():
        print(f"{name}: {export_project(project, solution, folder / name, asked)}")
    return project, solution


def shown(project: Project, solution: Solution, frames: Sequence[int] = FRAMES) -> Iterator[dict[str, np.ndarray]]:
    """Where the editor has every mesh in some frames, millimetres."""
    clip = take(project)
    pose = Superposition(project.face, solution.basis, rig_of(project.units))
    for frame in frames:
        pose.turned = clip.rigid(frame)
        pose.pose(clip.expression(frame))
        stands = pose.stance
        places = {name: _moved(stands.head, points) for name, points in pose.parts.items()}
        places["skin"] = _moved(stands.head, pose.points)
        for eye, turn in zip(project.face.eyes, stands.eyes, strict=True):
            side = {"L": "left", "R": "right"}[eye.side]
            for layer, (mesh, _) in (("eye", eyeball(eye).opaque), ("cornea", eyeball(eye).cornea)):
                places[f"{layer}-{side}"] = _moved(stands.head @ turn, mesh.positions)
        yield places


def _moved(motion: np.ndarray, points: np.ndarray) -> np.ndarray:
    return np.asarray(points @ motion[:3, :3].T + motion[:3, 3])
