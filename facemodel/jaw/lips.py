"""The forces by which the lips follow an opening jaw, derived rather than guessed.

An opening jaw pulls the lower lip down by the floor of the mouth, to which it is grown, while the upper lip stays with
the maxilla; a membrane with a hole in it knows neither, and drags both lips along with the cheeks.  Choe, Lee and Ko
2001 add heuristic forces about the lips for that.  Here the lips' edges are told how far of the bone's way they go, as
it was measured on scanned faces, and the forces on the lips that bring them there are solved for, from the face's own
stiffness: a few smooth patches along the lips, so that they stay small and leave no mark.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.face import Face
from facemodel.jaw.modes import JawMode, mode_motion
from facemodel.openings import Slit, along, mouth_of, on_upper_side
from facemodel.system import HeldFace
from fem.types import FloatArray, IntArray

LOWER_STATIONS = (-1.0, -0.5, 0.0, 0.5, 1.0)
UPPER_STATIONS = (-0.5, 0.0, 0.5)
"""Where along the lips they are led, from the right corner to the left one."""

NEAR_STATION = 0.15
"""Share of half a lip over which the place of a station is an average."""

PATCH = 0.35
"""Share of half a lip over which the force of a station fades along it."""

FULL, FADED = 4.0, 18.0
"""Millimetres from the edge of a lip within which a force is whole and beyond which there is none: over the red of
the lip and the skin that lies on the same muscle."""

AT_CORNER = 0.4
"""Share of the jaw's way that a corner of the mouth goes: 0.37 to 0.43 on scanned faces that open wide."""

UPPER_MIDDLE = 0.07
"""Share of it that the middle of the upper lip goes."""

NARROWING = 0.2
"""How far the corners come together, as a share of how far they go down."""

WEAKEST = 1e-4
"""Share of the largest singular value below which a direction counts as held: no force is spent on it."""


@dataclass(frozen=True, eq=False)
class _Stations:
    """Places along the lips.

    Attributes
    ----------
    margins : (S, n) weights of the region's vertices whose average each place is
    patches : (F, n, 3) the forces that lead them, each along one axis about one place
    led : (F,) which of the 3 S coordinates of the places each of the forces is there for
    shares : (n,) how much of the jaw's way the vertices of the margins go
    narrowing : (n,) how far they come to the left, as a share of how far they go up
    """

    margins: FloatArray
    patches: FloatArray
    led: IntArray
    shares: FloatArray
    narrowing: FloatArray


@dataclass(frozen=True, eq=False)
class LedLips:
    """What each mode of the jaw does with the lips led along.

    Attributes
    ----------
    actions : M of (n, 3) force per area on the region's vertices, N/mm^2, and the rest of what was given
    coefficients : (n_dofs, 3, M) of the displacement of the region
    """

    actions: tuple[FloatArray, ...]
    coefficients: FloatArray


def lead_lips(face: Face, held: HeldFace, modes: Sequence[JawMode], acting: Sequence[FloatArray]) -> LedLips:
    """Solve for modes of the jaw, with forces on the lips that lead them along.

    Parameters
    ----------
    face : whose jaw moves; without the slit of a mouth its skin follows the tissue alone
    held : its factorised system
    modes : M of them
    acting : M of (n, 3) force per area with which the tissue alone pulls in each mode, N/mm^2; a fourth column is
        the volume per area that bone brings under the skin, millimetres
    """
    mouth = mouth_of(face)
    vertices = held.surfaces.region.vertices
    if mouth is None or not np.isin(np.concatenate([mouth.upper, mouth.lower]), vertices).all():
        return LedLips(tuple(acting), held.system.solve(held.consistent_loads(acting)))
    stations, places = _stations(face, mouth, vertices), face.skin.positions[vertices]
    count, values = len(stations.patches), held.surfaces.region.assembler.dofs.value_dofs
    solved = held.system.solve(held.consistent_loads([*stations.patches, *acting]))
    reached = np.einsum("sn,nck->sck", stations.margins, solved[values]).reshape(-1, count + len(acting))[stations.led]
    wanted = np.stack([_wanted(stations, mode_motion(face.skull.jaw, mode, places)) for mode in modes], axis=-1)
    amounts = np.linalg.lstsq(reached[:, :count], wanted[stations.led] - reached[:, count:], rcond=WEAKEST)[0]
    led = np.einsum("km,knc->mnc", amounts, stations.patches)
    return LedLips(
        tuple(_pushed(own, push) for own, push in zip(acting, led, strict=True)),
        solved[..., count:] + solved[..., :count] @ amounts,
    )


def _pushed(action: FloatArray, push: FloatArray) -> FloatArray:
    """An action with further forces (n, 3)."""
    return np.column_stack([action[:, :3] + push, action[:, 3:]])


def _wanted(stations: _Stations, moved: FloatArray) -> FloatArray:
    """Where (3 S,) the stations go when the bone moves by (n, 3)."""
    way = stations.shares[:, None] * moved
    way[:, 0] += stations.narrowing * way[:, 1]
    return np.asarray(stations.margins @ way).ravel()


def _stations(face: Face, mouth: Slit, vertices: IntArray) -> _Stations:
    skin, upper_side = face.skin, on_upper_side(face.skin, mouth)
    number = np.full(len(skin.positions), -1)
    number[vertices] = np.arange(len(vertices))
    shares, narrowing = np.zeros(len(vertices)), np.zeros(len(vertices))
    margins: list[FloatArray] = []
    patches: list[FloatArray] = []
    led: list[int] = []
    for chain, stations, is_upper in ((mouth.lower, LOWER_STATIONS, False), (mouth.upper, UPPER_STATIONS, True)):
        at = along(skin.positions, chain)
        shares[number[chain]] = UPPER_MIDDLE + (AT_CORNER - UPPER_MIDDLE) * at**4 if is_upper else _lower_share(at)
        narrowing[number[chain]] = NARROWING * np.sign(at) * at**2
        away = np.linalg.norm(skin.positions[vertices][:, None] - skin.positions[chain][None], axis=2)
        nearest = at[away.argmin(axis=1)]
        t = np.clip((FADED - away.min(axis=1)) / (FADED - FULL), 0.0, 1.0)
        here = t * t * (3 - 2 * t) * (upper_side[vertices] == is_upper)
        for station in stations:
            weight = np.zeros(len(vertices))
            weight[number[chain]] = np.exp(-(((at - station) / NEAR_STATION) ** 2))
            patch = here * np.exp(-(((nearest - station) / PATCH) ** 2))
            for axis in (0, 1, 2) if abs(station) == 1 else (1, 2):
                patches.append(patch[:, None] * np.eye(3)[axis])
                led.append(3 * len(margins) + axis)
            margins.append(weight / weight.sum())
    return _Stations(np.array(margins), np.array(patches), np.array(led), shares, narrowing)


def _lower_share(at: FloatArray) -> FloatArray:
    """Share of the jaw's way that the lower lip goes: its middle stays before the lower incisors."""
    return np.asarray(1 - (1 - AT_CORNER) * at**2)
