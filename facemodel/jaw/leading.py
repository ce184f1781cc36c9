"""The forces by which lips and chin follow an opening jaw, derived rather than guessed.

An opening jaw pulls the lower lip down by the floor of the mouth, to which it is grown, while the upper lip stays with
the maxilla, and the skin of the chin goes with the bone to which mentalis and the mandibular ligament tie it; a
membrane with a hole in it knows none of this, drags both lips along with the cheeks and lets the chin lag.  Choe, Lee
and Ko 2001 add heuristic forces about the lips for that.  Here places of lips and chin are told how far of the bone's
way they go, as it was measured on scanned faces, and the forces that bring them there are solved for, from the face's
own stiffness: a few smooth patches, whose forces do as little work on the skin as brings the places near to where they
are to go.  Asked to bring them there to the hair, neighbours would pull against each other, and the cheek pay for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.face import Face
from facemodel.jaw.modes import JawMode, mode_motion
from facemodel.jaw.stations import Station, chin_stations, lip_stations
from facemodel.openings import mouth_of
from facemodel.system import HeldFace
from fem.types import FloatArray

SLIGHT = 1e-12
"""Share of the mean work of a force that is added to all, so that forces which do the same are told apart."""


@dataclass(frozen=True, eq=False)
class LedSkin:
    """What each mode of the jaw does with lips and chin led along.

    Attributes
    ----------
    actions : M of (n, 3) force per area on the region's vertices, N/mm^2
    coefficients : (n_dofs, 3, M) of the displacement of the region
    """

    actions: tuple[FloatArray, ...]
    coefficients: FloatArray


def lead_skin(face: Face, held: HeldFace, modes: Sequence[JawMode], acting: Sequence[FloatArray]) -> LedSkin:
    """Solve for modes of the jaw, with forces on lips and chin that lead them along.

    Parameters
    ----------
    face : whose jaw moves; lips without a slit between them, and a chin without landmarks, follow the tissue alone
    held : its factorised system
    modes : M of them
    acting : M of (n, 3) force per area with which the tissue alone pulls in each mode, N/mm^2
    """
    mouth = mouth_of(face)
    vertices = held.surfaces.region.vertices
    if mouth is not None and not np.isin(np.concatenate([mouth.upper, mouth.lower]), vertices).all():
        mouth = None
    lips = lip_stations(face, mouth, vertices) if mouth is not None else []
    stations = [*lips, *chin_stations(face, mouth, vertices)]
    if not stations:
        return LedSkin(tuple(acting), held.system.solve(held.consistent_loads(acting)))
    patches, led = _patches(stations)
    count, values = len(patches), held.surfaces.region.assembler.dofs.value_dofs
    loads = held.consistent_loads([*patches, *acting])
    solved = held.system.solve(loads)
    margins = np.array([station.place for station in stations])
    reached = np.einsum("sn,nck->sck", margins, solved[values]).reshape(-1, count + len(acting))[led]
    moved = [mode_motion(face.skull.jaw, mode, face.skin.positions[vertices]) for mode in modes]
    wanted = np.array([[station.wanted(each) for each in moved] for station in stations])
    there = np.moveaxis(wanted, 2, 1).reshape(-1, len(modes))[led]
    work = np.einsum("nck,ncl->kl", loads[..., :count], solved[..., :count])
    pull = np.array([station.pull for station in stations for _ in station.axes])[:, None]
    amounts = _least_work(work, reached[:, :count], there - reached[:, count:], pull)
    pushes = np.einsum("km,knc->mnc", amounts, patches)
    return LedSkin(
        tuple(own + push for own, push in zip(acting, pushes, strict=True)),
        solved[..., count:] + solved[..., :count] @ amounts,
    )


def _least_work(work: FloatArray, reached: FloatArray, missing: FloatArray, pull: FloatArray) -> FloatArray:
    """How much (F, M) of each force brings places near to where they are to go.

    It is the x of least x . G x + (A x - b) . k (A x - b).

    Parameters
    ----------
    work : (F, F) G, that of every force on the way that every other one goes, N mm
    reached : (F, F) A, how far every force brings the coordinates that are led, millimetres
    missing : (F, M) b, how far they are off without any, millimetres
    pull : (F, 1) k of each coordinate, N/mm
    """
    count = len(work)
    kept = (work + work.T) / 2 + SLIGHT * np.trace(work) / count * np.eye(count)
    return np.linalg.solve(kept + reached.T @ (pull * reached), reached.T @ (pull * missing))


def _patches(stations: Sequence[Station]) -> tuple[FloatArray, list[int]]:
    """The forces (F, n, 3) that lead stations, each along one axis, and which of their 3 S coordinates each is for."""
    made = [station.patch[:, None] * np.eye(3)[axis] for station in stations for axis in station.axes]
    led = [3 * number + axis for number, station in enumerate(stations) for axis in station.axes]
    return np.array(made), led
