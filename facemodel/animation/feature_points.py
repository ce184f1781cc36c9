"""MPEG-4 feature points on a face: where its parameters are measured, and in which units of the face."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from facemodel.basis import Basis
from facemodel.errors import FaceError
from facemodel.face import Face
from fem.types import FloatArray, IntArray
from resources import resource

SHARE = 1024.0
"""A unit of the face is a 1024th of the distance that it is called after."""

MEASURED = (
    *(f"{lid}_lid_mid_{side}" for lid in ("upper", "lower") for side in "LR"),
    *("subnasale", "upper_lip_mid", "mouth_corner_L", "mouth_corner_R"),
)
"""Landmarks between which the units of a face are measured."""


@dataclass(frozen=True)
class FeaturePoint:
    """Where a parameter is measured.

    Attributes
    ----------
    landmarks : of the face; the mean of their motion counts
    direction : unit vector along which it is positive
    """

    landmarks: tuple[str, ...]
    direction: tuple[float, float, float]


@cache
def feature_points() -> Mapping[str, FeaturePoint]:
    """The point of every parameter that is a distance, by the parameter's name."""
    raw = json.loads(resource("animation", "feature_points.json").read_text("utf-8"))["points"]
    return {name: FeaturePoint(tuple(each["landmarks"]), tuple(each["direction"])) for name, each in raw.items()}


def face_units(face: Face) -> dict[str, float]:
    """Millimetres of the units MNS, MW, ENS, ES and IRISD of a face at rest.

    Raises
    ------
    FaceError
        If it has no landmarks at eyes, nose or mouth to measure between.
    """
    missing = [name for name in MEASURED if name not in face.landmarks]
    if missing:
        raise FaceError(
            f"MPEG-4 measures faces by landmarks, and {face.title} has no {missing[0]}; export another format."
        )
    at = {name: face.skin.positions[vertex] for name, vertex in face.landmarks.items()}
    left, right = (eye.centre for eye in face.eyes)
    lids = np.mean([at[f"upper_lid_mid_{side}"][1] - at[f"lower_lid_mid_{side}"][1] for side in "LR"])
    return {
        "ES": abs(float(left[0] - right[0])) / SHARE,
        "ENS": float((left[1] + right[1]) / 2 - at["subnasale"][1]) / SHARE,
        "MNS": float(at["subnasale"][1] - at["upper_lip_mid"][1]) / SHARE,
        "MW": float(np.linalg.norm(at["mouth_corner_L"] - at["mouth_corner_R"])) / SHARE,
        "IRISD": float(lids) / SHARE,
    }


def point_motions(face: Face, basis: Basis, fields: Sequence[str]) -> dict[str, FloatArray]:
    """How far (C,) each field (C,) moves every feature point along its direction at weight 1, millimetres."""
    names = sorted({name for point in feature_points().values() for name in point.landmarks if name in face.landmarks})
    rows = _drawn_points(basis, face.skin.positions[[face.landmarks[name] for name in names]])
    moved = {name: np.zeros((len(fields), 3)) for name in names}
    for k, field in enumerate(fields):
        if field in basis.index:
            motion = basis.field(field)[rows]
            for name, vector in zip(names, motion, strict=True):
                moved[name][k] = vector
    found: dict[str, FloatArray] = {}
    for parameter, point in feature_points().items():
        present = [moved[name] for name in point.landmarks if name in moved]
        if present:
            found[parameter] = np.asarray(np.mean(present, axis=0) @ np.array(point.direction, dtype=np.float64))
    return found


def _drawn_points(basis: Basis, positions: FloatArray) -> IntArray:
    """The drawn point nearest to each position."""
    points = basis.display.points.astype(np.float64)
    return np.array([int(np.argmin(((points - at) ** 2).sum(axis=1))) for at in positions], dtype=np.int64)
