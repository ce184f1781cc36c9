"""The binary chunk of a glTF file: arrays one behind the other, and the accessors that describe them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from pygltflib import (
    ARRAY_BUFFER,
    ELEMENT_ARRAY_BUFFER,
    FLOAT,
    SCALAR,
    UNSIGNED_INT,
    UNSIGNED_SHORT,
    VEC2,
    VEC3,
    VEC4,
    Accessor,
    AccessorSparseIndices,
    AccessorSparseValues,
    BufferView,
    Sparse,
)

from fem.types import Float32Array, FloatArray, IntArray

ALIGNMENT = 4
LARGEST_SHORT = 65_534
"""The index 65535 restarts primitives in some graphics libraries, and glTF forbids it."""

POINT_BYTES = 12
"""Three float32; a view that several accessors share has to say how far its elements are apart."""

TYPES = {2: VEC2, 3: VEC3, 4: VEC4}


class GltfBuffer:
    """Collects arrays; `views` and `accessors` are the lists of the glTF document, `data` its buffer."""

    def __init__(self) -> None:
        self.views: list[BufferView] = []
        self.accessors: list[Accessor] = []
        self._blobs: list[bytes] = []
        self._length = 0
        self._zeros_of: dict[int, int] = {}

    @property
    def data(self) -> bytes:
        """The buffer."""
        return b"".join(self._blobs)

    def attribute(self, values: NDArray[Any], *, bounded: bool = False) -> int:
        """An accessor of vertex data (P, 2 to 4) float32; ``bounded`` notes the extent, as positions must."""
        values = np.ascontiguousarray(values, dtype="<f4")
        view = self._view(values.tobytes(), ARRAY_BUFFER)
        return self._accessor(FLOAT, values, TYPES[values.shape[1]], view=view, bounded=bounded)

    def triangles(self, triangles: IntArray) -> int:
        """An accessor of triangle corners (T, 3)."""
        kind, component = _index_type(int(triangles.max(initial=0)))
        corners = triangles.astype(kind).ravel()
        view = self._view(corners.tobytes(), ELEMENT_ARRAY_BUFFER)
        return self._accessor(component, corners, SCALAR, view=view)

    def change(self, values: Float32Array, smallest: float, *, bounded: bool = False) -> int:
        """An accessor of a change of vertex data (P, 3), in which rows smaller than ``smallest`` count as zero.

        The rows are stored with their numbers (a sparse accessor) where that is shorter than all rows.
        """
        rows = np.flatnonzero(np.abs(values).max(axis=1) > smallest)
        kept = np.zeros(values.shape, dtype="<f4")
        kept[rows] = values[rows]
        kind, component = _index_type(len(values))
        if len(rows) * (kept.itemsize * 3 + kind.itemsize) >= kept.nbytes:
            return self.attribute(kept, bounded=bounded)
        accessor = self._accessor(FLOAT, kept, VEC3, view=self._zeros(kept.nbytes), bounded=bounded)
        if len(rows):
            self.accessors[accessor].sparse = Sparse(
                count=len(rows),
                indices=AccessorSparseIndices(
                    bufferView=self._view(rows.astype(kind).tobytes()), componentType=component
                ),
                values=AccessorSparseValues(bufferView=self._view(kept[rows].tobytes())),
            )
        return accessor

    def samples(self, values: FloatArray, *, bounded: bool = False) -> int:
        """An accessor of something over time: (T,) numbers, or (T, 2 to 4) vectors; ``bounded`` as times must be."""
        held = np.ascontiguousarray(values, dtype="<f4")
        kind = SCALAR if held.ndim == 1 else TYPES[held.shape[1]]
        return self._accessor(FLOAT, held, kind, view=self._view(held.tobytes()), bounded=bounded)

    def _zeros(self, length: int) -> int:
        """A shared view of zeros; sparse accessors may do without one, but not every reader knows that."""
        if length not in self._zeros_of:
            self._zeros_of[length] = self._view(bytes(length), ARRAY_BUFFER)
            self.views[self._zeros_of[length]].byteStride = POINT_BYTES
        return self._zeros_of[length]

    def _view(self, blob: bytes, target: int | None = None) -> int:
        self.views.append(BufferView(buffer=0, byteOffset=self._length, byteLength=len(blob), target=target))
        padded = blob + bytes(-len(blob) % ALIGNMENT)
        self._blobs.append(padded)
        self._length += len(padded)
        return len(self.views) - 1

    def _accessor(self, component: int, values: NDArray[Any], kind: str, *, view: int, bounded: bool = False) -> int:
        accessor = Accessor(bufferView=view, componentType=component, count=len(values), type=kind)
        if bounded:
            accessor.min = np.atleast_1d(values.min(axis=0)).tolist()
            accessor.max = np.atleast_1d(values.max(axis=0)).tolist()
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def _index_type(largest: int) -> tuple[np.dtype[Any], int]:
    if largest <= LARGEST_SHORT:
        return np.dtype("<u2"), UNSIGNED_SHORT
    return np.dtype("<u4"), UNSIGNED_INT
