"""Where a face furrows when its skin is pushed together: lines across the forehead, between the brows, beside eyes and
nose.

They run square to the muscles that press the skin, in all of us in the same places. How they bend, break and branch
there is everybody's own, drawn from the key of the face, and a little different on either side; how deep they are is
for the pose to say, see `ui.viewport.folding`.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from dataclasses import dataclass

import igl
import numpy as np

from facemodel.face import Face
from facemodel.smooth import smooth
from fem.types import FloatArray
from ui.viewport.brows import on_chart

STEPS = 24
"""Places along a furrow."""

FACING = 0.15
"""Forward share of its normal from which on skin belongs to the front of a face."""

FOREHEAD = (14.0, 9.0, 4)
"""Millimetres from the middle of the brows up to the first line of the forehead, from line to line, and lines."""

SHORTEST = 0.22
"""Length of the shortest piece of a line across the forehead, as a share of the half of it."""

FROWN = 7.0
"""Millimetres from the midline to the lines between the brows."""

CROWS_FEET = (-38.0, 26.0)
"""Degrees above the horizontal between which lines run outwards from the outer corner of an eye."""

BRANCHED = 0.4
"""Share of these lines that branch."""

BESIDE_NOSE = (2, 4)
"""Fewest and most lines that climb over either side of the nose."""


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

    def habit(self, place: str) -> np.random.Generator:
        """What is this face's own in a place, always the same."""
        return np.random.default_rng(zlib.crc32(f"{self.face.key} {place}".encode()))

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


def _tapered(sharp: float = 1.0, peak: float = 0.5) -> FloatArray:
    """Depth (K,) of a line that begins and ends in nothing and is deepest at some share of its length."""
    along = np.linspace(0, 1, STEPS) ** (np.log(0.5) / np.log(peak))
    return np.asarray(np.clip(np.sin(np.pi * along), 0.0, 1.0) ** sharp)


def _forehead(front: _Front) -> Iterator[_Line]:
    own = front.habit("forehead")
    first, apart, count = FOREHEAD
    brow, wide = front.at("brow_mid_L"), 0.82 * front.at("brow_outer_L")[0]
    arch, droop, height = own.uniform(0.4, 2.6), own.uniform(1.6, 3.2), brow[1] + first + own.uniform(-2.0, 2.0)
    for line in range(count):
        for begin, end in _pieces(own):
            s = np.linspace(begin, end, STEPS)
            wave = own.uniform(0.3, 0.7) * np.sin(own.uniform(5, 9) * s + own.uniform(0, 6))
            bend = arch * np.sin(np.pi * s) ** 2 + droop * np.abs(s) ** 3
            depth = own.uniform(0.65, 1.0) * (1.0 - 0.12 * line)
            y = height + bend + wave + own.uniform(-0.8, 0.8)
            yield np.column_stack([wide * s, y]), depth * _tapered(0.75, own.uniform(0.4, 0.6))
        height += apart * own.uniform(0.8, 1.2)


def _pieces(own: np.random.Generator) -> list[tuple[float, float]]:
    """Into which pieces, from -1 on the right to 1 on the left, a line across the forehead breaks."""
    breaks = np.sort(own.uniform(-0.5, 0.5, own.integers(1, 4)))
    begins = np.concatenate([[-1.0 + own.uniform(0, 0.25)], breaks - own.uniform(-0.04, 0.12, len(breaks))])
    ends = np.concatenate([breaks + own.uniform(-0.04, 0.12, len(breaks)), [1.0 - own.uniform(0, 0.25)]])
    return [(begin, end) for begin, end in zip(begins, ends, strict=True) if end - begin > SHORTEST]


def _forehead_skin(front: _Front) -> tuple[FloatArray, FloatArray]:
    x, y = front.skin[:, 0], front.skin[:, 1]
    low, high = front.at("brow_mid_L")[1] + 7.0, front.at("brow_mid_L")[1] + FOREHEAD[0] + FOREHEAD[1] * FOREHEAD[2]
    wide = front.at("brow_outer_L")[0]
    share = smooth(y, low, low + 5.0) * smooth(y, high + 12.0, high) * smooth(np.abs(x), wide + 4.0, wide - 8.0)
    return share * _on_front(front), np.broadcast_to([0.0, 1.0, 0.0], front.skin.shape)


def _frown(front: _Front) -> Iterator[_Line]:
    brow = front.between_brows
    t = np.linspace(0, 1, STEPS)
    for side, name in ((-1.0, "R"), (1.0, "L")):
        own = front.habit(f"frown {name}")
        x = FROWN - 1.8 + own.uniform(-1.0, 1.0) + own.uniform(1.2, 3.4) * t + 0.5 * np.sin(4 * t + own.uniform(0, 6))
        low, long = own.uniform(-7.5, -5.0), own.uniform(14.0, 19.0)
        yield np.column_stack([side * x, brow + low + long * t]), _tapered(0.9, own.uniform(0.4, 0.55))
        inner, begin = own.uniform(0.3, 0.6), own.uniform(-4.0, -1.0)
        faint = own.uniform(0.15, 0.5) * _tapered(1.2)
        yield np.column_stack([side * x * inner, brow + begin + own.uniform(6.0, 11.0) * t]), faint
    own, nasion = front.habit("root of the nose"), front.at("nasion")
    for height, depth in ((2.0, own.uniform(0.6, 0.95)), (-2.2, own.uniform(0.3, 0.7))):
        x = np.linspace(-own.uniform(5.5, 8.0), own.uniform(5.5, 8.0), STEPS)
        y = nasion[1] + height + own.uniform(-0.6, 0.6) + own.uniform(-0.05, 0.05) * x - 0.02 * x**2
        yield np.column_stack([x, y]), depth * _tapered(0.9, own.uniform(0.4, 0.6))


def _frown_skin(front: _Front) -> tuple[FloatArray, FloatArray]:
    x, y = front.skin[:, 0], front.skin[:, 1]
    brow, nasion = front.between_brows, front.at("nasion")[1]
    low = (brow + nasion) / 2 - 2.0
    share = smooth(y, low, low + 3.0) * smooth(y, brow + 13.0, brow + 6.0) * smooth(np.abs(x), 14.0, 9.0)
    return share * _on_front(front), np.broadcast_to([1.0, 0.0, 0.0], front.skin.shape)


def _crows_feet(front: _Front) -> Iterator[_Line]:
    low, high = CROWS_FEET
    for side in "LR":
        own = front.habit(f"beside eye {side}")
        corner, outward = front.at(f"eye_outer_{side}")[:2], np.array([1.0 if side == "L" else -1.0, 1.0])
        for share in np.linspace(-1, 1, own.integers(4, 6)):
            degrees = (low + high) / 2 + share * (high - low) / 2 + own.uniform(-5.0, 5.0)
            curl = 0.5 * share + own.uniform(-0.25, 0.25)
            ray = _ray(own, degrees, own.uniform(4.0, 7.5), own.uniform(9.0, 15.0) * (1 - 0.3 * abs(share)), curl)
            depth = own.uniform(0.7, 1.0) * (1 - 0.3 * abs(share))
            yield corner + outward * ray, depth * _tapered(1.3, own.uniform(0.3, 0.5))
            if own.uniform() < BRANCHED:
                off, away = own.choice([-1.0, 1.0]), own.uniform(9.0, 12.0)
                branch = _ray(own, degrees + off * 5.0, away, own.uniform(4.0, 7.0), curl + off * own.uniform(0.3, 0.5))
                yield corner + outward * branch, 0.5 * depth * _tapered(1.3)


def _ray(own: np.random.Generator, degrees: float, away: float, long: float, curl: float) -> FloatArray:
    """Places (K, 2) of a line that runs away from a corner, turning by some radians on its way."""
    t = np.linspace(0, 1, STEPS)
    wobble = 0.03 * np.sin(own.uniform(4, 8) * t + own.uniform(0, 6))
    angle, distance = np.radians(degrees) + curl * t**1.5 + wobble, away + long * t
    return np.column_stack([distance * np.cos(angle), distance * np.sin(angle)])


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
    fewest, most = BESIDE_NOSE
    t = np.linspace(0, 1, STEPS)
    for side, name in ((-1.0, "R"), (1.0, "L")):
        own = front.habit(f"beside nose {name}")
        height = nasion[1] - 7.0 + own.uniform(-1.0, 1.0)
        for line in range(own.integers(fewest, most + 1)):
            x = side * (own.uniform(2.0, 3.5) + (own.uniform(7.5, 10.0) + 1.5 * line) * t)
            y = height - (own.uniform(1.0, 3.0) + own.uniform(4.0, 7.0) * t) * t
            depth = own.uniform(0.65, 0.95) - 0.12 * line
            yield np.column_stack([x, y]), depth * _tapered(1.0, own.uniform(0.35, 0.55))
            height -= own.uniform(2.8, 4.4) + 0.06 * (nasion[1] - tip[1])


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
