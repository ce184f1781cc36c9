"""Where a face furrows when its skin is pushed together: lines across the forehead, between the brows, beside eyes and
nose.

They run square to the muscles that press the skin, and are the same in all of us; how deep they are is for the pose to
say, see `ui.viewport.folding`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import igl
import numpy as np

from facemodel.face import Face
from fem.types import FloatArray
from ui.viewport.brows import on_chart
from ui.viewport.complexion import smooth

STEPS = 24
"""Places along a furrow."""

FACING = 0.15
"""Forward share of its normal from which on skin belongs to the front of a face."""

FOREHEAD = (14.0, 9.0, 4)
"""Millimetres from the middle of the brows up to the first line of the forehead, from line to line, and lines."""

FROWN = 7.0
"""Millimetres from the midline to the lines between the brows."""

CROWS_FEET = (-40.0, -17.0, 4.0, 24.0)
"""Degrees above the horizontal in which lines run outwards from the outer corner of an eye."""

BESIDE_NOSE = 3
"""Lines that climb over either side of the nose."""


@dataclass(frozen=True, eq=False)
class Furrow:
    """One line.

    Attributes
    ----------
    points : (K, 2) on the chart
    depth : (K,) how deep it gets there, 0 to 1
    """

    points: FloatArray
    depth: FloatArray


@dataclass(frozen=True, eq=False)
class Furrows:
    """All lines of a face, and the skin that they are in.

    Attributes
    ----------
    lines : the furrows
    share : (N,) how much each vertex of the skin belongs to such skin, 0 to 1
    across : (N, 3) which way the skin there is pushed together
    """

    lines: tuple[Furrow, ...]
    share: FloatArray
    across: FloatArray


def furrows(face: Face) -> Furrows:
    """The furrows of a face whose features are known."""
    front = _Front(face)
    found = [*_forehead(front), *_frown(front), *_crows_feet(front), *_beside_nose(front)]
    share, across = np.zeros(len(face.skin.positions)), np.zeros_like(face.skin.positions)
    for region in (_forehead_skin, _frown_skin, _skin_beside_eyes, _skin_of_nose):
        own, way = region(front)
        chosen = own > share
        share[chosen], across[chosen] = own[chosen], way[chosen]
    return Furrows(tuple(front.furrow(*each) for each in found), share, across)


class _Front:
    """The front of a face, on which places are found by x and y."""

    def __init__(self, face: Face) -> None:
        self.face = face
        self.skin = face.skin.positions
        self._tree = igl.AABB()
        self._tree.init(self.skin, face.skin.triangles)
        self.random = np.random.default_rng(5)

    def at(self, name: str) -> FloatArray:
        """A landmark (3,)."""
        return self.skin[self.face.landmarks[name]]

    @property
    def between_brows(self) -> float:
        """Height of the inner ends of the brows."""
        return float(self.at("brow_inner_L")[1] + self.at("brow_inner_R")[1]) / 2

    def furrow(self, places: FloatArray, depth: FloatArray) -> Furrow:
        """A line through places (K, 2), x and y, on the skin; where there is none under them it has no depth."""
        start = float(self.skin[:, 2].max()) + 1.0
        origins = np.column_stack([places, np.full(len(places), start)])
        back = np.broadcast_to([0.0, 0.0, -1.0], origins.shape).copy()
        met, away, _ = self._tree.intersect_ray_first(self.skin, self.face.skin.triangles, origins, back)
        found = np.column_stack([places, start - np.where(met >= 0, away, 0.0)])
        return Furrow(on_chart(self.face, found), np.where(met >= 0, depth, 0.0))


_Line = tuple[FloatArray, FloatArray]


def _tapered(sharp: float = 1.0) -> FloatArray:
    """Depth (K,) of a line that begins and ends in nothing."""
    return np.sin(np.pi * np.linspace(0, 1, STEPS)) ** sharp


def _forehead(front: _Front) -> Iterator[_Line]:
    first, apart, count = FOREHEAD
    brow, wide = front.at("brow_mid_L"), 0.82 * front.at("brow_outer_L")[0]
    for line in range(count):
        for begin, end in ((-1.0, -0.06), (-0.22, 0.30), (0.05, 1.0)):
            ends = np.array([begin, end]) + front.random.uniform(-0.05, 0.05, 2)
            s = np.linspace(*ends, STEPS)
            arch = 3.0 * np.cos(np.pi * s) ** 2 - 3.0 - 4.0 * np.abs(s) ** 3
            wave = 0.5 * np.sin(front.random.uniform(5, 9) * s + front.random.uniform(0, 6))
            y = brow[1] + first + line * apart - arch * 0.6 + wave + front.random.uniform(-0.8, 0.8)
            middle = 1.0 if begin < 0 < end else 0.85
            yield np.column_stack([wide * s, y]), middle * _tapered(0.6) * (1.0 - 0.12 * line)


def _forehead_skin(front: _Front) -> tuple[FloatArray, FloatArray]:
    x, y = front.skin[:, 0], front.skin[:, 1]
    low, high = front.at("brow_mid_L")[1] + 7.0, front.at("brow_mid_L")[1] + FOREHEAD[0] + FOREHEAD[1] * FOREHEAD[2]
    wide = front.at("brow_outer_L")[0]
    share = smooth(y, low, low + 5.0) * smooth(y, high + 12.0, high) * smooth(np.abs(x), wide + 4.0, wide - 8.0)
    return share * _on_front(front), np.broadcast_to([0.0, 1.0, 0.0], front.skin.shape)


def _frown(front: _Front) -> Iterator[_Line]:
    brow = front.between_brows
    for side in (-1.0, 1.0):
        t = np.linspace(0, 1, STEPS)
        x = side * (FROWN - 1.8 + 2.6 * t + 0.5 * np.sin(4 * t + side))
        yield np.column_stack([x, brow - 6.0 + 17.5 * t]), _tapered(0.9)
        yield np.column_stack([x * 0.45 + 0.4, brow - 3.0 + 10.0 * t]), 0.4 * _tapered()
    nasion = front.at("nasion")
    for height, depth in ((2.0, 0.9), (-2.2, 0.6)):
        x = np.linspace(-7.5, 7.5, STEPS)
        yield np.column_stack([x, nasion[1] + height - 0.02 * x**2]), depth * _tapered(0.8)


def _frown_skin(front: _Front) -> tuple[FloatArray, FloatArray]:
    x, y = front.skin[:, 0], front.skin[:, 1]
    brow, nasion = front.between_brows, front.at("nasion")[1]
    low = (brow + nasion) / 2 - 2.0
    share = smooth(y, low, low + 3.0) * smooth(y, brow + 13.0, brow + 6.0) * smooth(np.abs(x), 14.0, 9.0)
    return share * _on_front(front), np.broadcast_to([1.0, 0.0, 0.0], front.skin.shape)


def _crows_feet(front: _Front) -> Iterator[_Line]:
    for side in "LR":
        corner = front.at(f"eye_outer_{side}")
        outward = 1.0 if side == "L" else -1.0
        for number, degrees in enumerate(CROWS_FEET):
            angle = np.radians(degrees)
            length = (11.0, 15.0, 15.0, 11.0)[number]
            t = np.linspace(0, 1, STEPS)
            bend = angle + 0.35 * (t - 0.3) * np.sign(degrees + 1e-9) * (1.0 if number in (0, 3) else 0.3)
            away = 5.0 + length * t
            places = np.column_stack([outward * away * np.cos(bend), away * np.sin(bend)])
            yield corner[:2] + places, (0.75, 1.0, 1.0, 0.75)[number] * _tapered(0.8)


def _skin_beside_eyes(front: _Front) -> tuple[FloatArray, FloatArray]:
    share, across = np.zeros(len(front.skin)), np.zeros_like(front.skin)
    for side in "LR":
        outward = 1.0 if side == "L" else -1.0
        away = front.skin - front.at(f"eye_outer_{side}")
        beside = away[:, 0] * outward
        distance = np.linalg.norm(away, axis=1)
        own = smooth(distance, 26.0, 16.0) * smooth(distance, 2.0, 6.0) * smooth(beside, 0.0, 5.0)
        chosen = own > share
        share[chosen] = own[chosen]
        across[chosen] = np.cross(away, [0.0, 0.0, outward])[chosen]
    return share, across


def _beside_nose(front: _Front) -> Iterator[_Line]:
    nasion, tip = front.at("nasion"), front.at("nose_tip")
    for side in (-1.0, 1.0):
        for line in range(BESIDE_NOSE):
            t = np.linspace(0, 1, STEPS)
            x = side * (2.5 + (9.0 + 1.5 * line) * t)
            y = nasion[1] - 7.0 - 3.6 * line - (2.0 + 5.5 * t) * t - 0.06 * (nasion[1] - tip[1]) * line
            yield np.column_stack([x, y]), (0.9 - 0.15 * line) * _tapered(0.8)


def _skin_of_nose(front: _Front) -> tuple[FloatArray, FloatArray]:
    x, y = front.skin[:, 0], front.skin[:, 1]
    (_, nasion, nasion_z), tip = front.at("nasion"), front.at("nose_tip")[1]
    half = 0.55 * nasion + 0.45 * tip
    share = smooth(y, half - 5.0, half + 2.0) * smooth(y, nasion + 8.0, nasion + 4.0) * smooth(np.abs(x), 18.0, 11.0)
    return share * smooth(front.skin[:, 2], nasion_z - 16.0, nasion_z - 11.0), np.broadcast_to(
        [0.0, 1.0, 0.0], front.skin.shape
    )


def _on_front(front: _Front) -> FloatArray:
    return smooth(front.face.skin.normals[:, 2], FACING, 2 * FACING)
