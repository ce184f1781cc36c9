"""Steps that paint: other values at some skin vertices of some layers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

import numpy as np

from app.commands.command import Command
from facemodel.face import Face
from facemodel.painting.delta import LayerDelta, Member
from facemodel.project import Project
from fem.types import IntArray

Rows = np.ndarray[Any, np.dtype[Any]]
"""Values of an array, one row per vertex."""

ArrayName = Literal[Member, "anchors", "jawbone"]
"""What is painted: the arrays of `facemodel.face.Layers`, and those of `facemodel.face.Skull` with a row per vertex of
the skin."""

ARRAY_NAMES: tuple[ArrayName, ...] = get_args(ArrayName)

ON_SKULL = ("anchors", "jawbone")


@dataclass(frozen=True, eq=False)
class PaintedRows:
    """The changed rows of one array.

    Attributes
    ----------
    array : its name
    indices : (k,) skin vertices, in order
    before, after : (k, ...) their values
    """

    array: ArrayName
    indices: IntArray
    before: Rows
    after: Rows


@dataclass(frozen=True, eq=False)
class PaintLayers:
    """Give some skin vertices other values in one or more layers.

    Attributes
    ----------
    label : what a person calls it
    rows : what is different, each array once
    gesture : steps with the same gesture in a row are one step; empty for a step of its own
    """

    label: str
    rows: tuple[PaintedRows, ...]
    gesture: str = ""

    @property
    def cost(self) -> int:
        """Bytes that only this command keeps alive."""
        return sum(each.indices.nbytes + each.before.nbytes + each.after.nbytes for each in self.rows)

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return bool(self.rows)

    def do(self, project: Project) -> Project:
        """The project with the new values."""
        return _painted(project, ((each.array, each.indices, each.after) for each in self.rows))

    def undo(self, project: Project) -> Project:
        """The project with the old values."""
        return _painted(project, ((each.array, each.indices, each.before) for each in self.rows))

    def joined(self, later: Command) -> Command | None:
        """Both as one step if they belong to one gesture."""
        if not isinstance(later, PaintLayers) or not self.gesture or later.gesture != self.gesture:
            return None
        mine, theirs = ({each.array: each for each in step.rows} for step in (self, later))
        both = (_both(mine.get(name), theirs.get(name)) for name in ARRAY_NAMES)
        return PaintLayers(later.label, tuple(rows for rows in both if rows is not None), self.gesture)


def layer_array(face: Face, name: ArrayName) -> Rows:
    """An array of a face with one row per skin vertex."""
    array: Rows = getattr(face.skull if name in ON_SKULL else face.layers, name)
    return array


def with_layer_array(face: Face, name: ArrayName, array: Rows) -> Face:
    """A face with another array in place of one."""
    members: dict[str, Any] = {name: array}
    if name in ON_SKULL:
        return replace(face, skull=replace(face.skull, **members))
    return replace(face, layers=replace(face.layers, **members))


def changed_rows(before: Rows, after: Rows) -> IntArray:
    """Which rows of two arrays are not the same to the last bit."""
    if before is after:
        return np.zeros(0, dtype=np.int64)
    one, other = (np.ascontiguousarray(array).view(np.uint8).reshape(len(array), -1) for array in (before, after))
    return np.flatnonzero((one != other).any(axis=1))


def paint_layers(before: Face, after: Face, label: str, gesture: str = "") -> PaintLayers:
    """The step from one face to another that differs in painted arrays alone."""
    made = (_rows(name, layer_array(before, name), layer_array(after, name)) for name in ARRAY_NAMES)
    return PaintLayers(label, tuple(rows for rows in made if rows is not None), gesture)


def paint_deltas(deltas: Iterable[LayerDelta], label: str, gesture: str = "") -> PaintLayers:
    """The step of a stroke or a fill, as `facemodel.painting` gives it; of several no two change one array."""
    rows = (PaintedRows(each.member, each.vertices, each.before, each.after) for each in deltas if len(each))
    return PaintLayers(label, tuple(rows), gesture)


def _rows(name: ArrayName, before: Rows, after: Rows) -> PaintedRows | None:
    indices = changed_rows(before, after)
    return PaintedRows(name, indices, before[indices], after[indices]) if len(indices) else None


def _painted(project: Project, changes: Iterable[tuple[ArrayName, IntArray, Rows]]) -> Project:
    face = project.face
    for name, indices, values in changes:
        array = layer_array(face, name).copy()
        array[indices] = values
        face = with_layer_array(face, name, array)
    return replace(project, face=face)


def _both(first: PaintedRows | None, later: PaintedRows | None) -> PaintedRows | None:
    """What two changes of one array come to; rows that are as they were before both are left out."""
    if first is None or later is None:
        return first or later
    indices = np.union1d(first.indices, later.indices)
    shape = (len(indices), *first.before.shape[1:])
    before, after = np.empty(shape, first.before.dtype), np.empty(shape, first.after.dtype)
    for each in (later, first):
        before[np.searchsorted(indices, each.indices)] = each.before
    for each in (first, later):
        after[np.searchsorted(indices, each.indices)] = each.after
    moved = changed_rows(before, after)
    return PaintedRows(first.array, indices[moved], before[moved], after[moved]) if len(moved) else None
