"""Lips lie before the teeth: what a pose would put into them comes out, and the lip around with it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from facemodel.compiled import compiled
from facemodel.contact.arch import SMALLEST, Arch, arch_of, depth_in
from facemodel.contact.lips import Lip
from facemodel.contact.spread import carry
from facemodel.face import Face
from facemodel.kinematics import Stance
from fem.types import BoolArray, Float32Array, FloatArray

CLEARANCE = 0.4
"""Millimetres between the teeth and the drawn skin of a lip that lies on them."""

WAYS = 2
"""How often lips give way as a whole: a column goes less than it should where those beside it need not go."""

CLOSE = 6.0
"""Millimetres from a row of teeth within which points are looked at again; one by one they go less far."""


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
    upper, lower : how deep in it, with its clearance, each kept point of the skin of a lip rests
    """

    arch: Arch
    turn: FloatArray
    shift: FloatArray
    upper: FloatArray
    lower: FloatArray


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
    lips : of the mouth, the upper one first
    corners : (I,) how far each of their columns is in a corner, from 0 to 1: both lips come out together there
    rows : of teeth
    rest : (n, 3) points of the site at rest; a point that rests deeper keeps its own depth
    """

    def __init__(self, lips: tuple[Lip, Lip], corners: FloatArray, rows: Sequence[Row], rest: Float32Array) -> None:
        self._lips, self._corners, self._rows = lips, corners, rows
        bare = [_posed(row, np.eye(4), *(np.zeros(len(lip.kept) - lip.skin) for lip in lips)) for row in rows]
        self._resting = [tuple(_resting_depths(rest, row, lip) for lip in lips) for row in bare]

    def posed(self, stance: Stance) -> tuple[PosedRow, ...]:
        """The rows of teeth where they are."""
        rows = zip(self._rows, self._resting, strict=True)
        return tuple(_posed(row, stance.jaw, *resting) for row, resting in rows)

    def give_way(self, here: Float32Array, rows: tuple[PosedRow, ...]) -> tuple[bool, BoolArray]:
        """Bring the lips of posed points (n, 3) out of the teeth, in place, each with the skin around it.

        Returned are whether any was in them, and which points (r, n) are close to each row.
        """
        close = np.ones((len(rows), len(here)), dtype=np.bool_)
        return bool(rows) and _give_way(here, rows, *self._lips, self._corners, close), close

    def push(self, here: Float32Array, rows: tuple[PosedRow, ...], close: BoolArray, slack: float = 0.0) -> bool:
        """Bring out points that are still in the teeth by more than some millimetres, in place; whether there were any.

        Parameters
        ----------
        close : (r, n) which are looked at; those stay marked that are close to the row
        """
        return bool(rows) and _push(here, rows, *self._lips, close, slack)


def _posed(row: Row, jaw: FloatArray, upper: FloatArray, lower: FloatArray) -> PosedRow:
    motion = jaw if row.on_jaw else np.eye(4)
    turn, shift = np.ascontiguousarray(motion[:3, :3]), np.ascontiguousarray(motion[:3, 3])
    return PosedRow(row.arch, turn, shift, upper, lower)


@compiled
def _depth(here: Float32Array, row: PosedRow, i: int) -> tuple[float, float, float]:
    """How deep a point is in a row of teeth with its clearance, and x and z of the way out, of any length, at rest."""
    turn, shift = row.turn, row.shift
    x, y, z = here[i, 0] - shift[0], here[i, 1] - shift[1], here[i, 2] - shift[2]
    depth, right, front = depth_in(
        row.arch,
        turn[0, 0] * x + turn[1, 0] * y + turn[2, 0] * z,
        turn[0, 1] * x + turn[1, 1] * y + turn[2, 1] * z,
        turn[0, 2] * x + turn[1, 2] * y + turn[2, 2] * z,
    )
    return depth + CLEARANCE, right, front


@compiled
def _go_out(place: FloatArray | Float32Array, row: PosedRow, right: float, front: float, by: float) -> None:
    """Move a place (3,) by millimetres along the way out that x and z of the row at rest give, in place."""
    length = max(np.sqrt(right * right + front * front), SMALLEST)
    for axis in range(3):
        place[axis] += by * (row.turn[axis, 0] * right + row.turn[axis, 2] * front) / length


@compiled
def _resting_depths(rest: Float32Array, row: PosedRow, lip: Lip) -> FloatArray:
    """How deep the kept points of the skin of a lip are in a row of teeth, where they are."""
    found = np.empty(len(lip.kept) - lip.skin)
    for number in range(len(found)):
        found[number] = max(_depth(rest, row, lip.kept[lip.skin + number])[0], 0.0)
    return found


@compiled
def _ways(here: Float32Array, row: PosedRow, lip: Lip, resting: FloatArray, ways: FloatArray, close: BoolArray) -> bool:
    """Write the ways (I, 3) by which the columns of a lip come out of a row of teeth, each as its deepest point does.

    Of the points (n,) that are looked at those stay marked that are close to it.  Whether there are ways is returned.
    """
    most = np.zeros(len(ways))
    ways[:] = 0.0
    met = False
    for number in range(len(resting)):
        at = lip.skin + number
        i = lip.kept[at]
        if not close[i]:
            continue
        depth, right, front = _depth(here, row, i)
        by, column = lip.hold[at] * (depth - resting[number]), lip.column[at]
        close[i] = depth > -CLOSE
        if by > most[column]:
            met, most[column] = True, by
            ways[column] = 0.0
            _go_out(ways[column], row, right, front, by)
    return met


@compiled
def _give_way(
    here: Float32Array, rows: tuple[PosedRow, ...], upper: Lip, lower: Lip, corners: FloatArray, close: BoolArray
) -> bool:
    """See `BeforeTeeth.give_way`."""
    met = False
    rise, fall = np.empty((len(corners), 3)), np.empty((len(corners), 3))
    for _ in range(WAYS):
        again = False
        for number, row in enumerate(rows):
            over = _ways(here, row, upper, row.upper, rise, close[number])
            under = _ways(here, row, lower, row.lower, fall, close[number])
            if over or under:
                again = True
                _join(rise, fall, corners)
                carry(here, upper.whole, rise)
                carry(here, lower.whole, fall)
        if not again:
            break
        met = True
    return met


@compiled
def _join(rise: FloatArray, fall: FloatArray, corners: FloatArray) -> None:
    """Let the columns in the corners of both lips go the longer one of their ways (I, 3), in place."""
    for k in range(len(corners)):
        one, other = rise[k].copy(), fall[k].copy()
        most = one if (one * one).sum() > (other * other).sum() else other
        rise[k] += corners[k] * (most - one)
        fall[k] += corners[k] * (most - other)


@compiled
def _push(
    here: Float32Array, rows: tuple[PosedRow, ...], upper: Lip, lower: Lip, close: BoolArray, slack: float
) -> bool:
    """See `BeforeTeeth.push`."""
    met = False
    for number, row in enumerate(rows):
        met = _push_lip(here, row, upper, row.upper, close[number], slack) or met
        met = _push_lip(here, row, lower, row.lower, close[number], slack) or met
    return met


@compiled
def _push_lip(here: Float32Array, row: PosedRow, lip: Lip, resting: FloatArray, close: BoolArray, slack: float) -> bool:
    """Bring the kept points of the skin of a lip that are close out of a row of teeth, in place; whether any was."""
    met = False
    for number in range(len(resting)):
        at = lip.skin + number
        i = lip.kept[at]
        if close[i]:
            depth, right, front = _depth(here, row, i)
            close[i] = depth > -CLOSE
            by = lip.hold[at] * (depth - resting[number] - slack)
            if by > 0.0:
                met = True
                _go_out(here[i], row, right, front, by)
    return met
