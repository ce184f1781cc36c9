"""A curve: keys over time and how it runs between them.  A frozen value of arrays; no key is too many."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from fem.types import BoolArray, FloatArray

Shape = Literal["step", "linear", "smooth", "bezier"]
"""How a curve runs from one key to the next: it waits and jumps, goes straight, goes smoothly and never past the
keys, or follows the handles."""

SHAPES: tuple[Shape, ...] = ("step", "linear", "smooth", "bezier")
"""In the order of their codes in `Curve.shapes`."""

STEP, LINEAR, SMOOTH, BEZIER = range(4)

SAME_TIME = 1e-6
"""Seconds within which two keys are one: a ten-thousandth of a frame, and as fine as files of text tell times."""

ShapeCodes = NDArray[np.int8]

Handle = tuple[float, float]
"""From a key to its handle: seconds and value."""


@dataclass(frozen=True)
class Key:
    """One key, as people see it.

    Attributes
    ----------
    time : seconds
    value : weight, degrees or millimetres
    shape : how the curve runs from here to the next key
    arrives, leaves : handles behind (seconds not above 0) and ahead (not below 0), used next to a ``bezier`` segment
    weighted : whether the length of the handles counts; else only their slope does, each a third of its segment long
    broken : whether both handles turn on their own
    """

    time: float
    value: float
    shape: Shape = "smooth"
    arrives: Handle = (0.0, 0.0)
    leaves: Handle = (0.0, 0.0)
    weighted: bool = False
    broken: bool = False


def _empty(width: int = 0) -> FloatArray:
    return np.zeros((0, width) if width else 0)


@dataclass(frozen=True, eq=False)
class Curve:
    """Keys in the order of time.  Before the first and behind the last the curve stays at their values.

    Attributes
    ----------
    times : (K,) seconds, increasing by more than `SAME_TIME`
    values : (K,)
    shapes : (K,) index into `SHAPES` of the segment behind each key
    handles : (K, 4) seconds and value to the handle behind, seconds and value to the one ahead
    weighted, broken : (K,) as in `Key`
    overshoot : whether handles may take it beyond its own highest and lowest key; unless asked they never do
    """

    times: FloatArray = field(default_factory=_empty)
    values: FloatArray = field(default_factory=_empty)
    shapes: ShapeCodes = field(default_factory=lambda: np.zeros(0, np.int8))
    handles: FloatArray = field(default_factory=lambda: _empty(4))
    weighted: BoolArray = field(default_factory=lambda: np.zeros(0, np.bool_))
    broken: BoolArray = field(default_factory=lambda: np.zeros(0, np.bool_))
    overshoot: bool = False

    def __len__(self) -> int:
        return len(self.times)

    @property
    def keys(self) -> tuple[Key, ...]:
        """Its keys one by one."""
        return tuple(map(self.key, range(len(self))))

    def key(self, index: int) -> Key:
        """One of its keys."""
        back_time, back_value, ahead_time, ahead_value = self.handles[index].tolist()
        return Key(
            float(self.times[index]),
            float(self.values[index]),
            SHAPES[int(self.shapes[index])],
            (back_time, back_value),
            (ahead_time, ahead_value),
            bool(self.weighted[index]),
            bool(self.broken[index]),
        )

    def near(self, time: float, within: float = SAME_TIME) -> int | None:
        """Index of the key at a time; none if no key is that near."""
        if not len(self):
            return None
        nearest = int(np.argmin(np.abs(self.times - time)))
        return nearest if abs(self.times[nearest] - time) <= within else None


EMPTY = Curve()
"""The curve without keys; it is worth nothing everywhere."""


def curve_of(keys: Iterable[Key], overshoot: bool = False) -> Curve:
    """A curve through keys in any order; of two at one time the later one counts."""
    ordered: list[Key] = []
    latest: list[int] = []
    for order, key in sorted(enumerate(keys), key=lambda each: (each[1].time, each[0])):
        if ordered and key.time - ordered[-1].time <= SAME_TIME:
            if order > latest[-1]:
                ordered[-1], latest[-1] = key, order
        else:
            ordered.append(key)
            latest.append(order)
    if not ordered:
        return Curve(overshoot=overshoot)
    return Curve(
        np.array([key.time for key in ordered], dtype=np.float64),
        np.array([key.value for key in ordered], dtype=np.float64),
        np.array([SHAPES.index(key.shape) for key in ordered], dtype=np.int8),
        np.array([(*key.arrives, *key.leaves) for key in ordered], dtype=np.float64),
        np.array([key.weighted for key in ordered], dtype=np.bool_),
        np.array([key.broken for key in ordered], dtype=np.bool_),
        overshoot,
    )


def curve_through(times: FloatArray, values: FloatArray, shape: Shape = "smooth") -> Curve:
    """A curve of plain keys through increasing times (K,) and values (K,)."""
    count = len(times)
    return Curve(
        np.array(times, dtype=np.float64),
        np.array(values, dtype=np.float64),
        np.full(count, SHAPES.index(shape), dtype=np.int8),
        np.zeros((count, 4)),
        np.zeros(count, np.bool_),
        np.zeros(count, np.bool_),
    )
