"""The region in hand: skin vertices that are selected, and those that are locked against painting."""

from __future__ import annotations

import numpy as np
from psygnal import Signal

from facemodel.face import Face
from facemodel.mesh import Mesh
from fem.types import BoolArray


class Regions:
    """Selected and locked vertices of one skin; on another skin there are none."""

    changed = Signal()
    """Other vertices are selected or locked."""

    def __init__(self) -> None:
        self._skin: Mesh | None = None
        self._selected: BoolArray | None = None
        self._locked: BoolArray | None = None

    def selected(self, face: Face) -> BoolArray | None:
        """Selected vertices (N,); none if nothing is."""
        return self._selected if self._skin is face.skin else None

    def locked(self, face: Face) -> BoolArray | None:
        """Locked vertices (N,); none if nothing is."""
        return self._locked if self._skin is face.skin else None

    def kept(self, face: Face) -> BoolArray | None:
        """Vertices (N,) that a stroke leaves alone: the locked ones, and all outside of a selection."""
        selected, locked = self.selected(face), self.locked(face)
        if selected is None:
            return locked
        return ~selected if locked is None else ~selected | locked

    def select(self, face: Face, vertices: BoolArray | None) -> None:
        """Select these vertices (N,) and no others."""
        self._become(face, _some(vertices), self.locked(face))

    def lock(self, face: Face, vertices: BoolArray | None) -> None:
        """Keep strokes and fills from changing these vertices (N,), and no others."""
        self._become(face, self.selected(face), _some(vertices))

    def _become(self, face: Face, selected: BoolArray | None, locked: BoolArray | None) -> None:
        before = self.selected(face), self.locked(face)
        self._skin, self._selected, self._locked = face.skin, selected, locked
        if not all(map(_same, before, (selected, locked))):
            self.changed.emit()


def _some(vertices: BoolArray | None) -> BoolArray | None:
    return None if vertices is None or not vertices.any() else vertices.copy()


def _same(one: BoolArray | None, other: BoolArray | None) -> bool:
    return one is other or (one is not None and other is not None and np.array_equal(one, other))
