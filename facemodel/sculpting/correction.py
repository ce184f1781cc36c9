"""A correction: what a hand has added to one displacement field, kept apart from what is solved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.face import Face
from facemodel.mesh import Mesh
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

SPLIT_WIDTH = 12.0
"""Millimetres to both sides of the midline over which what is sculpted goes over from one side's field to the other's,
as wide as where the hand-made units are split."""

FARTHEST = 100.0
"""Millimetres; nothing on a face goes farther than a hand's breadth."""


@dataclass(frozen=True, eq=False)
class Correction:
    """A displacement of some vertices of the skin, on top of a field.

    It belongs to the mesh and not to what is drawn, so that it survives every solve and every density.

    Attributes
    ----------
    vertices : (k,) skin vertices, in order, each once
    moved : (k, 3) float32, millimetres at activation 1 of the field
    amount : 0 to 1, how much of it is added
    on : whether it is added at all
    """

    vertices: IntArray
    moved: Float32Array
    amount: float = 1.0
    on: bool = True

    @property
    def share(self) -> float:
        """How much of it is added to the field, 0 to 1."""
        return self.amount if self.on else 0.0

    @property
    def largest(self) -> float:
        """Largest displacement, millimetres at activation 1 and full amount."""
        return float(np.linalg.norm(self.moved, axis=1).max(initial=0.0))

    def everywhere(self, count: int) -> FloatArray:
        """It at all vertices of a skin of so many, (N, 3), zero where there is none."""
        full = np.zeros((count, 3))
        full[self.vertices] = self.moved
        return full


Corrections = Mapping[str, Correction]
"""By the name of the field, such as ``12L`` or ``17``."""

NOTHING = Correction(np.zeros(0, dtype=np.int64), np.zeros((0, 3), dtype=np.float32))
"""What a field has before anybody sculpts it."""


def correction_of(moved: FloatArray, like: Correction = NOTHING) -> Correction:
    """The correction of displacements (N, 3) of all vertices, with amount and switch of another one.

    What would go farther than `FARTHEST` in a coordinate stops there.
    """
    whole = np.clip(moved, -FARTHEST, FARTHEST).astype(np.float32)
    vertices = np.flatnonzero(whole.any(axis=1))
    return replace(like, vertices=vertices, moved=whole[vertices])


def summed(corrections: Corrections, fields: tuple[str, ...], count: int) -> FloatArray:
    """What is added to some fields together, (N, 3) millimetres at activation 1."""
    total = np.zeros((count, 3))
    for name in fields:
        layer = corrections.get(name)
        if layer is not None:
            total[layer.vertices] += layer.share * layer.moved
    return total


def mirrored(layer: Correction, partners: IntArray) -> Correction:
    """Its mirror image across the midline; vertices without a partner (-1) are left out."""
    across = partners[layer.vertices]
    there = np.flatnonzero(across >= 0)
    moved = np.zeros((len(partners), 3))
    moved[across[there]] = layer.moved[there] * [-1.0, 1.0, 1.0]
    return correction_of(moved, layer)


def joined(one: Correction, other: Correction, count: int) -> Correction:
    """Both on top of each other as one that is fully on."""
    return correction_of(one.share * one.everywhere(count) + other.share * other.everywhere(count))


def side_shares(unit: ActionUnit, skin: Mesh) -> dict[str, FloatArray]:
    """Which part (N,) of what is sculpted goes to each field of a unit: by side, and in sum all of it."""
    if not unit.paired:
        return {unit.fields[0]: np.ones(len(skin.positions))}
    left = (1 + np.sin(np.pi / 2 * np.clip(skin.positions[:, 0] / SPLIT_WIDTH, -1, 1))) / 2
    return dict(zip(unit.fields, (left, 1 - left), strict=True))


def copied(corrections: Corrections, fields: Mapping[str, str]) -> Corrections:
    """Corrections with those of some fields on other fields too; the very same if they have none."""
    more = {other: corrections[name] for name, other in fields.items() if name in corrections}
    return dict(sorted({**corrections, **more}.items())) if more else corrections


def halved(corrections: Corrections, unit: ActionUnit, skin: Mesh) -> Corrections:
    """Corrections in which that of one field is shared out to both sides, as a unit that is split now has them."""
    whole = corrections.get(str(unit.number))
    if whole is None:
        return corrections
    moved = whole.everywhere(len(skin.positions))
    sides = {name: correction_of(part[:, None] * moved, whole) for name, part in side_shares(unit, skin).items()}
    others = {name: each for name, each in corrections.items() if name != str(unit.number)}
    return dict(sorted({**others, **sides}.items()))


def movable(face: Face) -> BoolArray:
    """Which vertices (N,) a hand can move: those that are solved, but not the rim where they join the held head."""
    can = np.zeros(len(face.skin.positions), dtype=np.bool_)
    can[face.skin.triangles[face.solved]] = True
    can[face.skin.triangles[~face.solved]] = False
    return can
