"""Where the points of a tracker's mesh lie on a face: a table that ships, and the drawn points that it means."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.openings import Slit, along, lids_of, mouth_of
from fem.types import BoolArray, FloatArray, IntArray
from resources import resource

EDGES = ("upper_lid", "lower_lid", "upper_lip", "lower_lip")
"""Edges of openings; a place on one is told by how far along it is."""


@dataclass(frozen=True)
class Place:
    """A point of the tracker's mesh and where it lies on any face.

    Attributes
    ----------
    index : of the mesh
    mix : shares of landmarks, whose mean is dropped on the skin; empty if it is on an edge
    edge : of ``EDGES``, with the side of the face for a lid: ``upper_lid_R``; empty if it is none
    at : how far along the edge, -1 at the subject's right corner and 1 at the left
    region : part of the face, such as ``mouth``
    weight : how much it counts
    still : whether expressions hardly move it
    """

    index: int
    mix: tuple[tuple[str, float], ...]
    edge: str
    at: float
    region: str
    weight: float
    still: bool


@dataclass(frozen=True, eq=False)
class Places:
    """The places that a face has.

    Attributes
    ----------
    indices : (K,) of the mesh
    points : (K,) of the drawn skin
    rest : (K, 3) where they are at rest, millimetres
    weights : (K,) how much each counts
    still : (K,) which are hardly moved by expressions
    regions : (K,) which part of the face each belongs to
    """

    indices: IntArray
    points: IntArray
    rest: FloatArray
    weights: FloatArray
    still: BoolArray
    regions: tuple[str, ...]


@cache
def _table() -> Mapping[str, Any]:
    found: Mapping[str, Any] = json.loads(resource("animation", "mediapipe.json").read_text("utf-8"))
    return found


@cache
def known_places() -> tuple[Place, ...]:
    """The table that ships."""
    return tuple(
        _place(raw, index, side if len(raw["at"]) > 1 else "")
        for raw in _table()["points"]
        for index, side in zip(raw["at"], "RL", strict=False)
    )


def _place(raw: Mapping[str, Any], index: int, side: str) -> Place:
    """One entry of the table on one side of the face, or on its midline."""
    edge, at = next(((name, float(raw["on"][name])) for name in EDGES if name in raw["on"]), ("", 0.0))
    mix = () if edge else tuple((_sided(name, side), float(share)) for name, share in raw["on"].items())
    where = f"{edge}_{side}" if edge.endswith("lid") else edge
    turned = -at if side == "L" else at
    return Place(index, mix, where, turned, raw["region"], raw.get("weight", 1.0), raw.get("still", False))


MIDLINE = frozenset(
    {
        *("supraglabella", "glabella", "nasion", "rhinion", "nose_tip", "subnasale", "upper_vermilion"),
        *("lower_vermilion", "chin_lip_fold", "pogonion", "chin", "menton"),
    }
)
"""Landmarks of which there is one."""


def _sided(name: str, side: str) -> str:
    return name if not side or name in MIDLINE else f"{name}_{side}"


def told_units() -> frozenset[int]:
    """Numbers of the action units that the points tell apart.

    Rarer ones look like these from outside, such as 13 like 12 and 41 like 43, or are not seen by any point.
    """
    return frozenset(_table()["units"])


def irises() -> Mapping[str, int]:
    """The middle of each iris by the side of its eye."""
    found: Mapping[str, int] = _table()["irises"]
    return found


def measures() -> Mapping[str, list[list[int]]]:
    """Distances between points of the mesh by which a region is measured: pairs of their indices."""
    found: Mapping[str, list[list[int]]] = _table()["measures"]
    return found


def places_on(face: Face, display: DisplaySurface) -> Places:
    """The places of the table that a face has landmarks or edges for."""
    slits = _slits(face)
    rest = {name: face.skin.positions[vertex] for name, vertex in face.landmarks.items()}
    found = [(place, _position(place, face, rest, slits)) for place in known_places()]
    here = [(place, at) for place, at in found if at is not None]
    drawn = display.points.astype(np.float64)
    points = np.array([int(np.argmin(((drawn - at) ** 2).sum(axis=1))) for _, at in here], dtype=np.int64)
    return Places(
        np.array([place.index for place, _ in here], dtype=np.int64),
        points,
        drawn[points],
        np.array([place.weight for place, _ in here]),
        np.array([place.still for place, _ in here], dtype=np.bool_),
        tuple(place.region for place, _ in here),
    )


def _slits(face: Face) -> dict[str, IntArray]:
    """Edges of the openings that a face has, by name."""
    found: dict[str, IntArray] = {}

    def keep(slit: Slit | None, upper: str, lower: str) -> None:
        if slit is not None:
            found[upper], found[lower] = slit.upper, slit.lower

    keep(mouth_of(face), "upper_lip", "lower_lip")
    for eye in face.eyes:
        keep(lids_of(face, eye), f"upper_lid_{eye.side}", f"lower_lid_{eye.side}")
    return found


def _position(
    place: Place, face: Face, rest: Mapping[str, FloatArray], slits: Mapping[str, IntArray]
) -> FloatArray | None:
    """Where a place is on a face at rest (3,); none if the face has nothing to tell it by."""
    if place.edge:
        chain = slits.get(place.edge)
        if chain is None:
            return None
        nearest = int(np.argmin(np.abs(along(face.skin.positions, chain) - place.at)))
        return np.asarray(face.skin.positions[chain[nearest]])
    if any(name not in rest for name, _ in place.mix):
        return None
    return np.asarray(sum((share * rest[name] for name, share in place.mix), np.zeros(3)))
