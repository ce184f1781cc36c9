"""Take the arrays of an archive one by one, each checked against what it has to be."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from facemodel.io.damage import DamageError
from fem.types import BoolArray, FloatArray, IntArray

Shape = tuple[int | None, ...]
"""Wanted lengths of the axes; ``None`` is any length."""


class Members:
    """The arrays of one archive and which of them have been asked for.

    All methods raise `DamageError` with the name of the member if it is not as wanted.
    """

    def __init__(self, arrays: Mapping[str, NDArray[Any]]) -> None:
        self._arrays = dict(arrays)

    def floats(self, name: str, shape: Shape, low: float, high: float) -> FloatArray:
        """Finite numbers in a range, as float64."""
        array = self._take(name, shape, "f").astype(np.float64)
        fair = (array >= low) & (array <= high)
        if not fair.all():
            where = tuple(int(k) for k in np.argwhere(~fair)[0])
            value = array[where]
            says = f"is {value:g} and not in {low:g} to {high:g}" if np.isfinite(value) else "is not finite"
            raise DamageError(f"{name}.npy", f"at {list(where)} {says}")
        return array

    def indices(self, name: str, shape: Shape, count: int) -> IntArray:
        """Whole numbers from 0 up to and without ``count``, as int64."""
        array = self._take(name, shape, "i").astype(np.int64)
        if array.size and (array.min() < 0 or array.max() >= count):
            worst = array.min() if array.min() < 0 else array.max()
            raise DamageError(f"{name}.npy", f"holds {worst}, which is outside 0 to {count - 1}")
        return array

    def flags(self, name: str, count: int) -> BoolArray:
        """Truth values, at least one of them true."""
        array = self._take(name, (count,), "b").astype(np.bool_)
        if not array.any():
            raise DamageError(f"{name}.npy", "marks nothing")
        return array

    def __contains__(self, name: str) -> bool:
        return name in self._arrays

    def finish(self) -> None:
        """Make sure that nothing is left over."""
        if self._arrays:
            raise DamageError(f"{min(self._arrays)}.npy", "is not part of a face of this version")

    def _take(self, name: str, shape: Shape, kind: str) -> NDArray[Any]:
        array = self._arrays.pop(name, None)
        if array is None:
            raise DamageError(f"{name}.npy", "is missing")
        if array.dtype.kind != kind:
            wanted = {"f": "real numbers", "i": "whole numbers", "b": "truth values"}[kind]
            raise DamageError(f"{name}.npy", f"does not hold {wanted}")
        fits = array.ndim == len(shape) and all(
            want in (None, have) for want, have in zip(shape, array.shape, strict=True)
        )
        if not fits:
            wanted = " x ".join("any" if want is None else str(want) for want in shape)
            raise DamageError(f"{name}.npy", f"has the shape {array.shape} and not {wanted}")
        return array
