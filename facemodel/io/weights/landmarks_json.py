"""Landmarks of MediaPipe's face mesh as JSON, in the shapes in which its results are written down."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from facemodel.animation.landmarks import WITH_IRISES, LandmarkTrack
from facemodel.io.damage import DamageError
from facemodel.io.weights.arkit_json import LISTS, TIMES, noted_rate
from facemodel.io.weights.landmark_frames import AGAIN, tracked
from facemodel.io.weights.table import decoded
from fem.types import FloatArray

KEYS = ("faceLandmarks", "face_landmarks", "multiFaceLandmarks", "multi_face_landmarks", "landmarks")
"""Names of the points of a frame, or of its faces."""

WEIGHTS = (b'lendshapes"', b'lendShapes"', b'"categories"')
"""What names weights beside them, which say more of a face than its landmarks do."""


def holds_landmarks(data: bytes) -> bool:
    """Whether a file of JSON has landmarks and no weights."""
    return any(f'"{key}"'.encode() in data for key in KEYS) and not any(name in data for name in WEIGHTS)


def read_landmarks_json(data: bytes, rate: float | None = None) -> LandmarkTrack:
    """The landmarks in a list of frames, or in an object that holds one; of several faces, the first.

    A frame is a list of points, or has one; a point is ``[x, y, z]`` or has these by name.  A frame without a face is
    ``null`` or has none.

    Raises
    ------
    DamageError
        If it is no JSON, none of that, a point is none, or no frame shows a face.
    """
    try:
        raw = json.loads(decoded(data))
    except (ValueError, RecursionError) as error:
        raise DamageError("the file", "is no JSON", "write it again") from error
    frames = raw
    if isinstance(raw, dict):
        frames = next((raw[name] for name in (*LISTS, *KEYS) if isinstance(raw.get(name), list)), None)
    if not isinstance(frames, list) or not frames:
        raise DamageError("the file", "holds no list of frames", AGAIN)
    points = [_points(frame, number) for number, frame in enumerate(frames, start=1)]
    count = next((len(each) for each in points if len(each)), WITH_IRISES)
    filled = [each if len(each) else np.full((count, 3), np.nan) for each in points]
    for number, each in enumerate(filled, start=1):
        if len(each) != count:
            raise DamageError(f"frame {number}", f"has {len(each)} points and those before {count}", AGAIN)
    return tracked(np.array(filled), _times(frames), rate or noted_rate(raw))


def _times(frames: Sequence[Any]) -> FloatArray | None:
    """Seconds (N,) noted with the frames, if each has one."""
    noted = [
        next((frame[name] * unit for name, unit in TIMES.items() if _is_number(frame.get(name))), None)
        for frame in frames
        if isinstance(frame, dict)
    ]
    return None if len(noted) < len(frames) or None in noted else np.array(noted, dtype=np.float64)


def _points(frame: Any, number: int) -> FloatArray:
    """The points (P, 3) of the first face of a frame; (0, 3) without one."""
    while isinstance(frame, dict) or _are_faces(frame):
        frame = frame[0] if isinstance(frame, list) else next((frame[key] for key in KEYS if key in frame), None)
    if frame is None:
        return np.zeros((0, 3))
    if not isinstance(frame, list):
        raise DamageError(f"frame {number}", "is no list of points", AGAIN)
    return np.array([_point(point, number) for point in frame], dtype=np.float64).reshape(-1, 3)


def _are_faces(frame: Any) -> bool:
    """Whether the first of a list is a face, and no point."""
    if not isinstance(frame, list) or not frame:
        return False
    first = frame[0]
    return any(key in first for key in KEYS) if isinstance(first, dict) else _is_list_of_points(first)


def _is_list_of_points(item: Any) -> bool:
    return isinstance(item, list) and bool(item) and isinstance(item[0], list | dict)


def _point(point: Any, number: int) -> list[float]:
    cells = [point.get(axis) for axis in "xyz"] if isinstance(point, dict) else point
    if not isinstance(cells, list) or len(cells) != 3:
        raise DamageError(f"frame {number}", f"says “{str(point)[:30]}” where a point x, y, z has to be", AGAIN)
    return [_number(cell, number) for cell in cells]


def _number(cell: Any, number: int) -> float:
    if cell is None:
        return math.nan
    if not _is_number(cell):
        raise DamageError(f"frame {number}", f"says “{str(cell)[:30]}” where a number has to be", AGAIN)
    return float(cell)


def _is_number(cell: Any) -> bool:
    return isinstance(cell, int | float) and not isinstance(cell, bool)
