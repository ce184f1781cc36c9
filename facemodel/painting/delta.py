"""What a stroke changes, as values before and after: cheap to keep, exact to undo."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from facemodel.face import Layers
from fem.types import IntArray

Member = Literal["direction", "stretching", "bending", "stiffness", "thickness", "sliding", "volume", "supports"]
"""An array of `facemodel.face.Layers`."""


@dataclass(frozen=True, eq=False)
class LayerDelta:
    """Other rows for some vertices of one array of the layers.

    Attributes
    ----------
    member : which array
    vertices : (k,) skin vertices whose rows differ, each once
    before, after : (k,) or (k, c) their rows
    """

    member: Member
    vertices: IntArray
    before: NDArray[Any]
    after: NDArray[Any]

    @property
    def nbytes(self) -> int:
        """Bytes that it keeps."""
        return self.vertices.nbytes + self.before.nbytes + self.after.nbytes

    def __len__(self) -> int:
        return len(self.vertices)

    def done(self, layers: Layers) -> Layers:
        """The layers with the rows after."""
        return self._with(layers, self.after)

    def undone(self, layers: Layers) -> Layers:
        """The layers with the rows before, to the last bit those that `done` was given."""
        return self._with(layers, self.before)

    def _with(self, layers: Layers, rows: NDArray[Any]) -> Layers:
        array = getattr(layers, self.member).copy()
        array[self.vertices] = rows
        return replace(layers, **{self.member: array})


def layer_delta(layers: Layers, member: Member, vertices: IntArray, rows: NDArray[Any]) -> LayerDelta:
    """The change of some vertices (k,) to other rows, without those whose row is the same already."""
    before = getattr(layers, member)[vertices]
    after = rows.astype(before.dtype)
    differs = before != after
    changed = np.flatnonzero(differs if differs.ndim == 1 else differs.any(axis=1))
    return LayerDelta(member, vertices[changed], before[changed], after[changed])
