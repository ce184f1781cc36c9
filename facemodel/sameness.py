"""Whether two values are the same inside, and keeping what was made from a value while it is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from typing import Any, Generic, TypeVar

import numpy as np

Made = TypeVar("Made")


def same(one: Any, other: Any) -> bool:
    """Whether two frozen values hold the same, array by array; the same object costs nothing to compare."""
    if one is other:
        return True
    if type(one) is not type(other):
        return False
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and np.array_equal(one, other)
    if isinstance(one, Mapping):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    if isinstance(one, tuple | list):
        return len(one) == len(other) and all(map(same, one, other))
    if is_dataclass(one):
        return all(same(getattr(one, each.name), getattr(other, each.name)) for each in fields(one))
    return bool(one == other)


class Kept(Generic[Made]):
    """The last result of one step, kept while what it was made from is the same.

    What no longer holds is let go before its successor is made, so that two large results never lie in memory at
    once.  If making one fails there is none, and the next call makes it: it never holds what is not true.
    """

    def __init__(self) -> None:
        self._entry: tuple[tuple[Any, ...], Made] | None = None

    def get(self, inputs: tuple[Any, ...], make: Callable[[], Made]) -> Made:
        """The result for these inputs, made only if it is not the one that is kept."""
        if not self.holds(inputs):
            self._entry = None
            self._entry = (inputs, make())
        assert self._entry is not None
        return self._entry[1]

    def holds(self, inputs: tuple[Any, ...]) -> bool:
        """Whether `get` would make nothing."""
        return self._entry is not None and same(self._entry[0], inputs)
