"""Lips lie before the teeth: what a pose would put into them comes out, and the lip around with it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.contact.arch import Arch, arch_of
from facemodel.contact.slit import SlitColumns
from facemodel.face import Face
from facemodel.kinematics import Stance
from fem.types import Float32Array, FloatArray, IntArray

CLEARANCE = 0.4
"""Millimetres between the teeth and the drawn skin of a lip that lies on them."""

NEAR = 0.5
"""Millimetres before the teeth from which on all points of a lip are looked at, not its columns alone."""


@dataclass(frozen=True, eq=False)
class Row:
    """A row of teeth.

    Attributes
    ----------
    arch : its front at rest
    on_jaw : whether it moves with the jaw
    """

    arch: Arch
    on_jaw: bool


def rows_of_teeth(face: Face) -> tuple[Row, ...]:
    """The rows of teeth of a face, as far as they have a front."""
    found = []
    for part in face.parts:
        if part.kind == "teeth":
            arch = arch_of(part.mesh, upwards=part.carrier == "skull")
            if arch is not None:
                found.append(Row(arch, part.carrier == "jaw"))
    return tuple(found)


class BeforeTeeth:
    """Keeps the lips of a face before its teeth.

    Parameters
    ----------
    columns : of the mouth
    rows : of teeth
    skin : points of the site that are skin, from this number on
    rest : (n, 3) points of the site at rest; a point that rests deeper keeps its own depth
    """

    def __init__(self, columns: SlitColumns, rows: Sequence[Row], skin: int, rest: Float32Array) -> None:
        self._columns, self._rows = columns, rows
        kept = np.concatenate([columns.upper_kept, columns.lower_kept])
        self._points: IntArray = np.sort(kept[kept >= skin])
        self._allowed = [np.maximum(self._depth(row, rest[self._points], np.eye(4))[0], 0.0) for row in rows]

    def move(self, here: Float32Array, stance: Stance) -> None:
        """Bring the lips of posed points (n, 3) out of the teeth, in place."""
        sides = (
            (self._columns.upper.places(here), self._columns.upper_spread),
            (self._columns.lower.places(here), self._columns.lower_spread),
        )
        near = False
        for row in self._rows:
            for places, spread in sides:
                depth, out = self._depth(row, places, stance.jaw)
                deepest = depth.argmax(axis=1)[:, None]
                most = np.take_along_axis(depth, deepest, axis=1)[:, 0]
                near |= bool(most.max(initial=-NEAR) > -NEAR)
                if most.max(initial=0.0) > 0:
                    way = np.maximum(most, 0.0)[:, None] * np.take_along_axis(out, deepest[..., None], axis=1)[:, 0]
                    here += spread @ way.astype(np.float32)
        if near:
            self._push(here, stance)

    def _push(self, here: Float32Array, stance: Stance) -> None:
        """Bring out what the spread from column to column has left in the teeth, in place."""
        lips = here[self._points]
        for row, allowed in zip(self._rows, self._allowed, strict=True):
            depth, out = self._depth(row, lips, stance.jaw)
            way = np.maximum(depth - allowed, 0.0)
            if way.any():
                lips += (way[:, None] * out).astype(np.float32)
        here[self._points] = lips

    @staticmethod
    def _depth(row: Row, places: Float32Array, jaw: FloatArray) -> tuple[FloatArray, FloatArray]:
        """How deep (...,) places (..., 3) are in a row that the jaw may have moved, and the ways out (..., 3)."""
        if not row.on_jaw:
            depth, out = row.arch.depth(places)
            return depth + CLEARANCE, out
        turn, shift = jaw[:3, :3], jaw[:3, 3]
        depth, out = row.arch.depth((places - shift) @ turn)
        return depth + CLEARANCE, out @ turn.T
