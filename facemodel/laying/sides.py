"""Left and right: the mirror image of a muscle, and its partner kept in step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from facemodel.face import Face
from facemodel.laying.places import mirrored_place, mirrored_vector
from facemodel.muscles import Fibre, Muscle, Sphincter
from facemodel.muscles.muscle import MuscleSide
from fem.types import FloatArray

OTHER: Mapping[MuscleSide, MuscleSide] = {"L": "R", "R": "L", "M": "M"}

MIDLINE = 1.0
"""Millimetres from the middle plane within which both ends of a fibre lie on it."""


def side_of(face: Face, *places: FloatArray) -> MuscleSide:
    """The side on which a muscle with some places (3,) lies; ``M`` if all of them are in the middle."""
    lateral = [float(place[0] - mirrored_place(face, place)[0]) / 2 for place in places]
    if all(abs(x) < MIDLINE for x in lateral):
        return "M"
    return "L" if sum(lateral) > 0 else "R"


def mirrored(muscle: Muscle, face: Face) -> Muscle:
    """The muscle on the other side of a face; one across the midline stays on it.

    Ends on skin vertices go to the mirrored vertices, ends on the bone under one to the bone under the mirrored
    one, everything else is reflected in the middle plane.  A ring keeps its outward normal.
    """
    ring = None if muscle.ring is None else _mirrored_ring(muscle.ring, face)
    fibres = tuple(_mirrored_fibre(fibre, face) for fibre in muscle.fibres)
    return replace(muscle, side=OTHER[muscle.side], fibres=fibres, ring=ring)


def _mirrored_fibre(fibre: Fibre, face: Face) -> Fibre:
    via = tuple(mirrored_place(face, point) for point in fibre.via)
    return Fibre(mirrored_place(face, fibre.origin), mirrored_place(face, fibre.attachment), via)


def _mirrored_ring(ring: Sphincter, face: Face) -> Sphincter:
    # A reflection turns the ring inside out; with its long axis turned round it faces outward again.
    return replace(
        ring,
        centre=mirrored_place(face, ring.centre),
        long_axis=-mirrored_vector(face, ring.long_axis),
        short_axis=mirrored_vector(face, ring.short_axis),
        sector=mirrored_vector(face, ring.sector),
    )


def partner(muscles: Sequence[Muscle], muscle: Muscle) -> Muscle | None:
    """The muscle of the same name on the other side, if there is one."""
    if muscle.side == "M":
        return None
    other = OTHER[muscle.side]
    return next((each for each in muscles if each.name == muscle.name and each.side == other), None)


def put(muscles: Sequence[Muscle], muscle: Muscle, face: Face) -> tuple[Muscle, ...]:
    """Muscles with one of the same key replaced, or added at the end; a linked partner follows as its mirror image."""
    kept = list(muscles)
    changed = [muscle]
    other = partner(kept, muscle)
    if other is not None and muscle.linked and other.linked:
        changed.append(mirrored(muscle, face))
    for each in changed:
        place = next((k for k, old in enumerate(kept) if old.key == each.key), len(kept))
        kept[place : place + 1] = [each]
    return tuple(kept)


def linked(muscles: Sequence[Muscle], muscle: Muscle, face: Face) -> tuple[Muscle, ...]:
    """Muscles with the partner of one made its mirror image, now and from now on."""
    other = partner(muscles, muscle)
    ready = tuple(replace(each, linked=True) if each is other else each for each in muscles)
    return put(ready, replace(muscle, linked=True), face)


def unlinked(muscles: Sequence[Muscle], muscle: Muscle) -> tuple[Muscle, ...]:
    """Muscles with one and its partner changed independently from now on."""
    return tuple(
        replace(each, linked=False) if each.name == muscle.name and each.side != "M" else each for each in muscles
    )
