"""Blend shapes of ARKit or MediaPipe as JSON, in the shapes in which programs write them."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from facemodel.animation.capture import Capture
from facemodel.io.damage import DamageError
from facemodel.io.weights.names import live_link_name
from facemodel.io.weights.table import decoded
from facemodel.io.weights.timing import even, kept
from fem.types import FloatArray

Frame = Mapping[str, float]

AGAIN = "write it with one list of frames, each with its blend shapes by name"
RATES = ("fps", "exportFps", "frameRate", "frame_rate", "rate")
LISTS = ("frames", "data", "blendshapes", "results")
TIMES = {"time": 1.0, "timestamp": 1.0, "timestamp_s": 1.0, "timestamp_ms": 1e-3, "timestampMs": 1e-3, "time_ms": 1e-3}
SHAPES = ("blendshapes", "blendShapes", "faceBlendshapes", "face_blendshapes", "weights", "categories", "shapes")
NAMES = ("names", "facsNames", "blendshapeNames", "blendshape_names")
MATRICES = ("weightMat", "frames", "weights", "values")


def read_arkit_json(data: bytes, rate: float | None = None) -> Capture:
    """A capture from JSON: a list of frames (or an object that holds one), names beside a matrix, or a list per name.

    A frame has its weights by name, or a list of categories with name and score as MediaPipe gives it.

    Raises
    ------
    DamageError
        If it is no JSON, none of that, names nothing that ARKit knows, or goes back in time.
    """
    try:
        raw = json.loads(decoded(data))
    except (ValueError, RecursionError) as error:
        raise DamageError("the file", "is no JSON", "write it again") from error
    own = rate or noted_rate(raw)
    names, values, times = _matrix(raw) or _lists(raw) or _frames(raw)
    known = [(k, name) for k, name in enumerate(map(live_link_name, names)) if name is not None]
    if not known:
        raise DamageError("the file", "names no blend shape of ARKit such as jawOpen", AGAIN)
    chosen = values[:, [k for k, _ in known]]
    found = even(None if rate else times, chosen, range(1, len(values) + 1), own if times is None or rate else None)
    return Capture("arkit", tuple(name for _, name in known), kept(found.values), found.rate, 0.0, found.notes)


Found = tuple[list[str], FloatArray, FloatArray | None]


def noted_rate(raw: Any) -> float | None:
    """Frames per second that a file says it has; none if it does not say."""
    if not isinstance(raw, dict):
        return None
    found = next((raw[name] for name in RATES if name in raw), None)
    return float(found) if isinstance(found, int | float) and math.isfinite(found) and found > 0 else None


def _matrix(raw: Any) -> Found | None:
    """Names beside a list of lists."""
    if not isinstance(raw, dict):
        return None
    names = next((raw[name] for name in NAMES if isinstance(raw.get(name), list)), None)
    rows = next((raw[name] for name in MATRICES if isinstance(raw.get(name), list)), None)
    if names is None or rows is None or not all(isinstance(row, list) for row in rows):
        return None
    for number, row in enumerate(rows, start=1):
        if len(row) != len(names):
            raise DamageError(f"frame {number}", f"has {len(row)} weights and there are {len(names)} names", AGAIN)
    values = [[_number(cell, number) for cell in row] for number, row in enumerate(rows, start=1)]
    return [str(name) for name in names], _array(values, len(names)), None


def _lists(raw: Any) -> Found | None:
    """A list of numbers for every name."""
    if not isinstance(raw, dict):
        return None
    lists = {name: each for name, each in raw.items() if isinstance(each, list) and live_link_name(name) is not None}
    if not lists:
        return None
    lengths = {len(each) for each in lists.values()}
    if len(lengths) > 1:
        raise DamageError("the file", "has lists of different lengths", AGAIN)
    columns = [[_number(cell, k) for k, cell in enumerate(each, start=1)] for each in lists.values()]
    times = next((raw[name] for name in ("times", "time") if isinstance(raw.get(name), list)), None)
    stamps = None if times is None else np.array([_number(each, k) for k, each in enumerate(times, start=1)])
    if stamps is not None and len(stamps) != max(lengths):
        raise DamageError("the file", "has not one time for every frame", AGAIN)
    return list(lists), np.array(columns, dtype=np.float64).T, stamps


def _frames(raw: Any) -> Found:
    """A list of frames."""
    frames = raw if isinstance(raw, list) else None
    if isinstance(raw, dict):
        frames = next((raw[name] for name in LISTS if isinstance(raw.get(name), list)), None)
    if not frames:
        raise DamageError("the file", "holds no list of frames", AGAIN)
    read = [_frame(frame, number) for number, frame in enumerate(frames, start=1)]
    names = list(dict.fromkeys(name for weights, _ in read for name in weights))
    values = _array([[weights.get(name, np.nan) for name in names] for weights, _ in read], len(names))
    times = [time for _, time in read]
    stamps = None if any(time is None for time in times) else np.array(times, dtype=np.float64)
    return names, values, stamps


def _frame(frame: Any, number: int) -> tuple[Frame, float | None]:
    """Weights by name, and the time in seconds if it has one."""
    if isinstance(frame, list):
        return _categories(frame, number), None
    if not isinstance(frame, dict):
        raise DamageError(f"frame {number}", "is neither an object nor a list", AGAIN)
    noted = next(((frame[name], unit) for name, unit in TIMES.items() if name in frame), None)
    time = None if noted is None else _number(noted[0], number) * noted[1]
    shapes = next((frame[name] for name in SHAPES if name in frame), None)
    if shapes is None:
        shapes = {name: each for name, each in frame.items() if live_link_name(name) is not None}
    if isinstance(shapes, list):
        return _categories(shapes, number), time
    if not isinstance(shapes, dict):
        raise DamageError(f"frame {number}", "has no blend shapes by name", AGAIN)
    return {str(name): _number(each, number) for name, each in shapes.items()}, time


def _categories(items: Sequence[Any], number: int) -> Frame:
    """MediaPipe's categories, of the first face."""
    first = items[0] if items else None
    if isinstance(first, list):
        return _categories(first, number)
    if isinstance(first, dict) and isinstance(first.get("categories"), list):
        return _categories(first["categories"], number)
    found: dict[str, float] = {}
    for item in items:
        if not isinstance(item, dict):
            raise DamageError(f"frame {number}", "has no blend shapes by name", AGAIN)
        name = next(
            (item[key] for key in ("categoryName", "category_name", "name", "displayName") if item.get(key)), ""
        )
        value = next((item[key] for key in ("score", "value", "weight") if key in item), None)
        found[str(name)] = _number(value, number)
    return found


def _number(value: Any, number: int) -> float:
    if value is None:
        return math.nan
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise DamageError(f"frame {number}", f"says “{str(value)[:30]}” where a number has to be", AGAIN)
    return float(value) if math.isfinite(value) else math.nan


def _array(rows: Sequence[Sequence[float]], width: int) -> FloatArray:
    return np.array(rows, dtype=np.float64).reshape(len(rows), width)
