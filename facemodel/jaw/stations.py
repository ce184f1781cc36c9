"""Places of the skin that are led along when the jaw opens, and how far of its way each of them goes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.face import Face
from facemodel.openings import Slit, along, on_upper_side
from facemodel.smooth import smooth_step
from fem.types import FloatArray, IntArray

LOWER_STATIONS = (-1.0, -0.7, -0.35, 0.0, 0.35, 0.7, 1.0)
UPPER_STATIONS = (-0.5, 0.0, 0.5)
"""Where along the lips they are led, from the right corner to the left one."""

NEAR_STATION = 0.15
"""Share of half a lip over which the place of a station is an average."""

PATCH = 0.35
"""Share of half a lip over which the force of a station fades along it."""

FULL, FADED = 4.0, 14.0
"""Millimetres from the edge of a lip within which a force is whole and beyond which there is none: over the red of
the lip and the skin that lies on the same muscle."""

AT_CORNER = 0.4
"""Share of the jaw's way that a corner of the mouth goes: 0.37 to 0.43 on scanned faces that open wide."""

UPPER_MIDDLE = 0.07
"""Share of it that the middle of the upper lip goes."""

NARROWING = 0.2
"""How far the corners come together, as a share of how far they go down."""

CHIN_LINE = {"lower_vermilion": 0.94, "chin_lip_fold": 0.98, "pogonion": 0.98, "menton": 0.95}
"""Landmarks from the red of the lip down the middle of the chin, whose skin is grown to the bone by mentalis, and the
share of the jaw's way that they go."""

CHIN_SIDES = {"pogonion": ((0.35, 0.93), (0.6, 0.78)), "chin_lip_fold": ((0.35, 0.88), (0.6, 0.67))}
"""Beside two of them, as high: how far towards the second molar, and the share of the jaw's way that the skin goes
there, where the mandibular ligament ties it to the bone; as measured on a scanned face that opens wide."""

LEVEL = np.array([1.0, 0.0, 1.0])
"""Sideways and back, as high as it was."""

CHIN_NEAR, CHIN_PATCH = 4.0, 18.0
"""Millimetres over which a place of the chin is an average, and over which its force fades."""

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
    """

    place: FloatArray
    patch: FloatArray
    axes: tuple[int, ...]
    way: FloatArray
    inward: FloatArray

    def wanted(self, moved: FloatArray) -> FloatArray:
        """Where (3,) it goes when the bone at the vertices moves by (n, 3)."""
        way = self.way @ moved
        way[0] += self.inward @ moved[:, 1]
        return np.asarray(way)


def lip_stations(face: Face, mouth: Slit, vertices: IntArray) -> list[Station]:
    """Places along the edges of both lips, whose vertices all belong to a region (n,)."""
    skin, upper_side = face.skin, on_upper_side(face.skin, mouth)[vertices]
    number = np.full(len(skin.positions), -1)
    number[vertices] = np.arange(len(vertices))
    stations: list[Station] = []
    for chain, places, is_upper in ((mouth.lower, LOWER_STATIONS, False), (mouth.upper, UPPER_STATIONS, True)):
        at = along(skin.positions, chain)
        share = UPPER_MIDDLE + (AT_CORNER - UPPER_MIDDLE) * at**4 if is_upper else _lower_share(at)
        inward = NARROWING * np.sign(at) * at**2 * share
        away = np.linalg.norm(skin.positions[vertices][:, None] - skin.positions[chain][None], axis=2)
        nearest = at[away.argmin(axis=1)]
        here = smooth_step((FADED - away.min(axis=1)) / (FADED - FULL)) * (upper_side == is_upper)
        for place in places:
            near = np.exp(-(((at - place) / NEAR_STATION) ** 2))
            near /= near.sum()
            spread = [_spread(number[chain], near * each, len(vertices)) for each in (1.0, share, inward)]
            patch = here * np.exp(-(((nearest - place) / PATCH) ** 2))
            stations.append(Station(spread[0], patch, (0, 1, 2) if abs(place) == 1 else (1, 2), *spread[1:]))
    return stations


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
    return stations


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
    return Station(place, patch, axes, share * place, np.zeros_like(place))


def _spread(rows: IntArray, values: FloatArray, count: int) -> FloatArray:
    """Some numbers (m,) at their rows of so many, zeros elsewhere."""
    spread = np.zeros(count)
    spread[rows] = values
    return spread


def _lower_share(at: FloatArray) -> FloatArray:
    """Share of the jaw's way that the lower lip goes: its middle stays before the lower incisors."""
    return np.asarray(1 - (1 - AT_CORNER) * at**2)
