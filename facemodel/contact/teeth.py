"""Lips lie before the teeth: what a pose would put into them comes out, and the lip around with it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.arch import Arch, arch_of, depth_in
from facemodel.contact.lips import Lip
from facemodel.contact.spread import lift
from facemodel.face import Face
from facemodel.kinematics import Stance
from fem.types import Float32Array, FloatArray

CLEARANCE = 0.4
"""Millimetres between the teeth and the drawn skin of a lip that lies on them."""


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


class PosedRow(NamedTuple):
    """A row of teeth where it is.

    Attributes
    ----------
    arch : its front at rest
    turn, shift : (3, 3), (3,) what has moved it from there
    """

    arch: Arch
    turn: FloatArray
    shift: FloatArray


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
    lips : of the mouth
    corners : (I,) how far each of their columns is in a corner, from 0 to 1: both lips come out together there
    rows : of teeth
    skin : points of the site that are skin, from this number on
    rest : (n, 3) points of the site at rest; a point that rests deeper keeps its own depth
    """

    def __init__(
        self, lips: tuple[Lip, Lip], corners: FloatArray, rows: Sequence[Row], skin: int, rest: Float32Array
    ) -> None:
        self._lips, self._corners, self._rows = lips, corners, rows
        self._first = [int(np.searchsorted(lip.kept, skin)) for lip in lips]
        still = np.eye(4)
        self._allowed = [
            [_resting_depths(rest, _posed(row, still), lip, first) for lip, first in self._skins()] for row in rows
        ]

    def give_way(self, here: Float32Array, stance: Stance) -> bool:
        """Bring the lips of posed points (n, 3) out of the teeth, in place, each with the skin around it.

        Whether any was in them is returned.
        """
        met = False
        for row, allowed in zip(self._rows, self._allowed, strict=True):
            posed = _posed(row, stance.jaw)
            lips = zip(self._skins(), allowed, strict=True)
            ways = [_ways(here, posed, lip, first, spared, len(self._corners)) for (lip, first), spared in lips]
            if any(way.any() for way in ways):
                met = True
                _give_way(here, *self._lips, ways[0], ways[1], self._corners)
        return met

    def push(self, here: Float32Array, stance: Stance) -> bool:
        """Bring out every point that is still in the teeth, in place; whether there was any."""
        met = False
        for row, allowed in zip(self._rows, self._allowed, strict=True):
            posed = _posed(row, stance.jaw)
            for (lip, first), spared in zip(self._skins(), allowed, strict=True):
                met |= _push(here, posed, lip, first, spared)
        return met

    def _skins(self) -> list[tuple[Lip, int]]:
        return list(zip(self._lips, self._first, strict=True))


def _resting_depths(rest: Float32Array, row: PosedRow, lip: Lip, first: int) -> FloatArray:
    return np.maximum(_depths(rest, row, lip, first, np.empty((len(lip.kept) - first, 3))), 0.0)


def _posed(row: Row, jaw: FloatArray) -> PosedRow:
    motion = jaw if row.on_jaw else np.eye(4)
    return PosedRow(row.arch, np.ascontiguousarray(motion[:3, :3]), np.ascontiguousarray(motion[:3, 3]))


@compiled
def _depths(here: Float32Array, row: PosedRow, lip: Lip, first: int, out: FloatArray) -> FloatArray:
    """How deep the kept points of a lip, from a first one on, are in a row of teeth with its clearance.

    The ways out are written into an array (m, 3).
    """
    found = np.empty(len(lip.kept) - first)
    kept, arch, turn, shift = lip.kept, row.arch, row.turn, row.shift
    for number in range(len(found)):
        i = kept[first + number]
        x, y, z = here[i, 0] - shift[0], here[i, 1] - shift[1], here[i, 2] - shift[2]
        depth, right, front = depth_in(
            arch,
            turn[0, 0] * x + turn[1, 0] * y + turn[2, 0] * z,
            turn[0, 1] * x + turn[1, 1] * y + turn[2, 1] * z,
            turn[0, 2] * x + turn[1, 2] * y + turn[2, 2] * z,
        )
        found[number] = depth + CLEARANCE
        for axis in range(3):
            out[number, axis] = turn[axis, 0] * right + turn[axis, 2] * front
    return found


@compiled
def _ways(here: Float32Array, row: PosedRow, lip: Lip, first: int, allowed: FloatArray, count: int) -> FloatArray:
    """The ways (3, I) by which the columns of a lip come out of a row of teeth, each as its deepest point does."""
    out, most, ways = np.empty((len(allowed), 3)), np.zeros(count), np.zeros((3, count))
    depths = _depths(here, row, lip, first, out)
    for number in range(len(allowed)):
        depth = lip.hold[first + number] * (depths[number] - allowed[number])
        column = lip.column[first + number]
        if depth > most[column]:
            most[column] = depth
            ways[:, column] = depth * out[number]
    return ways


@compiled
def _give_way(
    here: Float32Array, upper: Lip, lower: Lip, rise: FloatArray, fall: FloatArray, corners: FloatArray
) -> None:
    """Move both lips by ways (3, I) of their columns, in place, and their corners by the longer one of both."""
    for k in range(len(corners)):
        one, other = rise[:, k].copy(), fall[:, k].copy()
        most = one if (one * one).sum() > (other * other).sum() else other
        rise[:, k] += corners[k] * (most - one)
        fall[:, k] += corners[k] * (most - other)
    for axis in range(3):
        unit = np.zeros(3)
        unit[axis] = 1.0
        lift(here, upper.whole, rise[axis], unit)
        lift(here, lower.whole, fall[axis], unit)


@compiled
def _push(here: Float32Array, row: PosedRow, lip: Lip, first: int, allowed: FloatArray) -> bool:
    """Bring the kept points of a lip from a first one on out of a row of teeth, in place; whether any was in them."""
    met = False
    out = np.empty((len(allowed), 3))
    depths = _depths(here, row, lip, first, out)
    for number in range(len(allowed)):
        by = lip.hold[first + number] * (depths[number] - allowed[number])
        if by > 0.0:
            met = True
            for axis in range(3):
                here[lip.kept[first + number], axis] += by * out[number, axis]
    return met
