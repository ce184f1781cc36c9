"""Carry points of one head to another by landmarks: scaled differently along every direction, then bent to fit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import RBFInterpolator

from facemodel.errors import MuscleError
from facemodel.face import Face
from fem.types import FloatArray

FEWEST = 4
"""Landmarks that two heads must share: as many as decide an affine map."""

CORNERS = ("mouth_corner_L", "mouth_corner_R")

FLATTEST = 0.02
"""Smallest extent of the landmarks over their largest below which they lie in a plane."""

STEP = 1.0
"""Millimetres over which the scale of a warp is measured."""


def control_points(face: Face) -> dict[str, FloatArray]:
    """Places (2, 3) of a head by name: each landmark on the skin and the bone under it, the eyeballs and the mouth.

    The middle of the mouth, between its corners, is where sphincters hang that no other place holds.
    """
    places = {name: np.array([face.skin.positions[v], face.skull.anchors[v]]) for name, v in face.landmarks.items()}
    places |= {f"eyeball {eye.side}": np.tile(eye.centre, (2, 1)) for eye in face.eyes}
    if places.keys() >= set(CORNERS):
        middle = np.mean([places[name][0] for name in CORNERS], axis=0)
        places["mouth"] = np.tile(middle, (2, 1))
    return places


@dataclass(frozen=True, eq=False)
class Warp:
    """A smooth map of space that takes control points to control points.

    The affine part scales non-proportionally; what is left is spread by the biharmonic spline of three
    dimensions, whose kernel is the distance: the counterpart of the thin plate in the plane.
    """

    spline: RBFInterpolator

    def __call__(self, points: FloatArray) -> FloatArray:
        """Where points (n, 3) come to lie."""
        return np.asarray(self.spline(np.atleast_2d(points)))

    def scale(self, point: FloatArray) -> float:
        """How much lengths about a point (3,) grow, the mean over all directions."""
        steps = STEP * np.concatenate([np.eye(3), -np.eye(3)])
        moved = self(point + steps)
        stretch = (moved[:3] - moved[3:]) / (2 * STEP)
        return float(np.cbrt(abs(np.linalg.det(stretch))))


def landmark_warp(source: Mapping[str, FloatArray], target: Mapping[str, FloatArray]) -> Warp:
    """The warp between two heads by the control points that both have.

    Raises
    ------
    MuscleError
        If they share too few, or these lie in a plane.
    """
    shared = [name for name in source if name in target]
    if len(shared) < FEWEST:
        raise MuscleError(
            f"Both heads share {len(shared)} landmarks and at least {FEWEST} are needed; "
            "set more of them on the new head."
        )
    start = np.concatenate([source[name] for name in shared])
    start, first = np.unique(start, axis=0, return_index=True)
    goal = np.concatenate([target[name] for name in shared])[first]
    for places, whose in ((start, "old"), (goal, "new")):
        extent = np.linalg.svd(places - places.mean(axis=0), compute_uv=False)
        if extent[2] < FLATTEST * extent[0]:
            raise MuscleError(f"The landmarks of the {whose} head lie in a plane; set some in its depth, too.")
    return Warp(RBFInterpolator(start, goal, kernel="linear", degree=1))
