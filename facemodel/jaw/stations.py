"""Places of the skin that are led along when the jaw opens, and how far of its way each of them goes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from facemodel.face import Face
from facemodel.openings import Slit, along, on_upper_side
from facemodel.smooth import smooth_step
from fem.types import FloatArray, IntArray

LOWER_STATIONS = (-0.7, -0.35, 0.0, 0.35, 0.7)
UPPER_STATIONS = (-0.6, 0.0, 0.6)
"""Where along the lips they are led, from the right corner to the left one, and besides at the corners."""

NEAR_STATION = 0.15
"""Share of half a lip over which the place of a station is an average."""

PATCH = 0.45
"""Share of half a lip over which the force of a station fades along it."""

FULL, FADED = 4.0, 20.0
"""Millimetres from the edge of a lip within which a force is whole and beyond which there is none: over the red of
the lip and the skin that lies on the same muscle."""

CORNER = 9.0
"""Millimetres from a corner of the mouth over which the force on it fades: over the knot of muscles beside it, which
both lips hang on."""

AT_CORNER = 0.4
"""Share of the jaw's way that a corner of the mouth goes: 0.37 to 0.43 on scanned faces that open wide."""

UPPER_MIDDLE = 0.07
"""Share of it that the middle of the upper lip goes."""

NARROWING = 0.17
"""How far a corner comes inwards, as a share of how far it goes down: 0.16 and 0.17 on a scanned and a sculpted face.
The lips between keep their place to the sides."""

ARCH = 2.0
"""Power of the way along the upper lip by which it goes more of the jaw's way: 2 where a round mouth was measured; the
higher it is, the more the mouth opens like a letter box."""

CHIN_LINE = {"lower_vermilion": 0.94, "chin_lip_fold": 0.98, "pogonion": 0.98, "menton": 0.95}
"""Landmarks from the red of the lip down the middle of the chin, whose skin is grown to the bone by mentalis, and the
share of the jaw's way that they go."""

CHIN_SIDES = {"pogonion": ((0.35, 0.93), (0.6, 0.78)), "chin_lip_fold": ((0.35, 0.88), (0.6, 0.67))}
"""Beside two of them, as high: how far towards the second molar, and the share of the jaw's way that the skin goes
there, where the mandibular ligament ties it to the bone; as measured on a scanned face that opens wide."""

CHIN_FLOOR, DOWN, BACK = 0.7, 0.3, 0.5
"""Behind the menton, where the skin bends to the neck: how far towards the midst between the angles of the jaw, and the
shares of the menton's way down and back that the skin goes there.  No bone carries it but the floor of the mouth, which
comes down with chin and tongue bone, so that skin is not crammed into a fold: 0.8 down and 0.4 back on a scanned face,
none and 0.3 on a sculpted one."""

LEVEL = np.array([1.0, 0.0, 1.0])
"""Sideways and back, as high as it was."""

CHIN_NEAR, CHIN_PATCH = 4.0, 18.0
"""Millimetres over which a place of the chin is an average, and over which its force fades."""

LIPS_PULLED, CHIN_PULLED = 40.0, 3.0
"""N/mm by which lips and chin are pulled where they are to go; wide open, they miss it by a millimetre or two.  Pulled
harder, neighbours work against each other and the whole face shares less with measured ones."""

UNPARTED = 10.0
"""Millimetres below the middle of lips that are one piece of skin over which forces on the chin begin."""


@dataclass(frozen=True, eq=False)
class Station:
    """A place that is led, and the forces there are for it.

    Attributes
    ----------
    place : (n,) weights of the region's vertices whose average it is
    patch : (n,) how much of a force there acts on each of them
    axes : along which it is led
    way : (n,) weights of the jaw's way at the vertices, whose sum is the way that it is to go
    inward : (n,) weights of the jaw's way up, whose sum it is to go to the left besides
    pull : N/mm, how much force a millimetre is worth by which it misses that
    """

    place: FloatArray
    patch: FloatArray
    axes: tuple[int, ...]
    way: FloatArray
    inward: FloatArray
    pull: float

    def wanted(self, moved: FloatArray) -> FloatArray:
        """Where (3,) it goes when the bone at the vertices moves by (n, 3)."""
        way = self.way @ moved
        way[0] += self.inward @ moved[:, 1]
        return np.asarray(way)


def lip_stations(face: Face, mouth: Slit, vertices: IntArray) -> list[Station]:
    """Places along the edges of both lips and at their corners, whose vertices all belong to a region (n,)."""
    skin = face.skin.positions
    upper_side = on_upper_side(face.skin, mouth)[vertices]
    number = np.full(len(skin), -1)
    number[vertices] = np.arange(len(vertices))
    stations: list[Station] = []
    for is_upper, chain, places in ((False, mouth.lower, LOWER_STATIONS), (True, mouth.upper, UPPER_STATIONS)):
        lip = _Lip(number[chain], along(skin, chain), is_upper, len(vertices))
        away = np.linalg.norm(skin[vertices][:, None] - skin[chain][None], axis=2)
        nearest = lip.at[away.argmin(axis=1)]
        here = smooth_step((FADED - away.min(axis=1)) / (FADED - FULL)) * (upper_side == is_upper)
        axes = (1, 2) if is_upper else (0, 1, 2)
        stations += [lip.led(place, here * np.exp(-(((nearest - place) / PATCH) ** 2)), axes) for place in places]
        if not is_upper:
            for place, corner in zip((-1.0, 1.0), mouth.corners, strict=True):
                off = np.linalg.norm(skin[vertices] - skin[corner], axis=1)
                stations.append(lip.led(place, np.exp(-((off / CORNER) ** 2)), (0, 1, 2)))
    return stations


@dataclass(frozen=True, eq=False)
class _Lip:
    """An edge of the mouth: m vertices of a region of so many, and where (m,) they lie along it."""

    rows: IntArray
    at: FloatArray
    is_upper: bool
    count: int

    def led(self, place: float, patch: FloatArray, axes: tuple[int, ...]) -> Station:
        """The station at a place along it, led by such a force (n,)."""
        near = np.exp(-(((self.at - place) / NEAR_STATION) ** 2))
        near /= near.sum()
        share = _upper_share(self.at) if self.is_upper else _lower_share(self.at)
        inward = NARROWING * np.sign(self.at) * self.at**4 * share
        mean, way, aside = (_spread(self.rows, near * each, self.count) for each in (1.0, share, inward))
        return Station(mean, patch, axes, way, aside, LIPS_PULLED)


def chin_stations(face: Face, mouth: Slit | None, vertices: IntArray) -> list[Station]:
    """Places on the chin and beside it; none on a face whose landmarks do not tell where it is."""
    marks, skin = face.landmarks, face.skin.positions
    molars = [f"lower_second_molar_{side}" for side in "LR"]
    if not {*CHIN_LINE, "lower_lip_mid", *molars} <= marks.keys():
        return []
    below = _below_the_mouth(face, mouth)[vertices]
    stations = [_on_chin(skin[marks[name]], share, (1, 2), skin[vertices], below) for name, share in CHIN_LINE.items()]
    for name, sides in CHIN_SIDES.items():
        middle = skin[marks[name]]
        for molar in molars:
            for part, share in sides:
                towards = middle + part * LEVEL * (skin[marks[molar]] - middle)
                stations.append(_on_chin(towards, share, (0, 1, 2), skin[vertices], below))
    return [*stations, *_floor_stations(skin, marks, skin[vertices], below)]


def _floor_stations(skin: FloatArray, marks: Mapping[str, int], region: FloatArray, below: FloatArray) -> list[Station]:
    """The place under the chin, down and back, on the skin (n, 3) of a region; none without the angles of the jaw."""
    if not {"gonion_L", "gonion_R"} <= marks.keys():
        return []
    menton = skin[marks["menton"]]
    back = (skin[marks["gonion_L"]] + skin[marks["gonion_R"]]) / 2 - menton
    chin = _on_chin(menton, 1.0, (1,), region, below)
    there = _on_chin(menton + CHIN_FLOOR * LEVEL * back, 1.0, (1,), region, below)
    return [replace(there, axes=(axis,), way=share * chin.way) for axis, share in ((1, DOWN), (2, BACK))]


def _below_the_mouth(face: Face, mouth: Slit | None) -> FloatArray:
    """How much (N,) of a force on the chin the skin is given: none of it goes to the upper lip."""
    if mouth is not None:
        return np.asarray(~on_upper_side(face.skin, mouth), dtype=np.float64)
    depth = face.skin.positions[face.landmarks["lower_lip_mid"], 1] - face.skin.positions[:, 1]
    return smooth_step(depth / UNPARTED)


def _on_chin(towards: FloatArray, share: float, axes: tuple[int, ...], skin: FloatArray, below: FloatArray) -> Station:
    """The station at the place of a region's skin (n, 3) that is nearest to a point."""
    centre = skin[np.linalg.norm(skin - towards, axis=1).argmin()]
    away = np.linalg.norm(skin - centre, axis=1)
    near, patch = (below * np.exp(-((away / reach) ** 2)) for reach in (CHIN_NEAR, CHIN_PATCH))
    place = near / near.sum()
    return Station(place, patch, axes, share * place, np.zeros_like(place), CHIN_PULLED)


def _spread(rows: IntArray, values: FloatArray, count: int) -> FloatArray:
    """Some numbers (m,) at their rows of so many, zeros elsewhere."""
    spread = np.zeros(count)
    spread[rows] = values
    return spread


def _lower_share(at: FloatArray) -> FloatArray:
    """Share of the jaw's way that the lower lip goes: its middle stays before the lower incisors."""
    return np.asarray(1 - (1 - AT_CORNER) * at**2)


def _upper_share(at: FloatArray) -> FloatArray:
    """Share of the jaw's way that the upper lip goes: its middle all but stays."""
    return np.asarray(UPPER_MIDDLE + (AT_CORNER - UPPER_MIDDLE) * np.abs(at) ** ARCH)
