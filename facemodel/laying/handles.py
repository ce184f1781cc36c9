"""What of a muscle a hand can take hold of, and what becomes of the muscle when it drags there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from facemodel.face import Face
from facemodel.laying.fibres import snapped, with_end, with_via
from facemodel.laying.measures import Measure, measured, measures_of, places
from facemodel.laying.places import Snap
from facemodel.laying.rings import with_axis, with_centre
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from fem.types import FloatArray

Part = Literal["origin", "attachment", "via", "centre", "long", "short"] | Measure

MEASURES: tuple[Measure, ...] = get_args(Measure)


@dataclass(frozen=True, eq=False)
class Handle:
    """A point of a muscle that can be dragged.

    Attributes
    ----------
    part : what it moves, or what it measures
    point : (3,) where it is, millimetres
    fibre : number of the central fibre it belongs to, for ends, intermediate points and radii
    place : which intermediate point of it, or which of x, y and z of a box or of the factors of a ring
    """

    part: Part
    point: FloatArray
    fibre: int = 0
    place: int = 0


def handles(muscle: Muscle, face: Face) -> tuple[Handle, ...]:
    """All handles of a muscle under its model: points of its fibres or of its ring, then what it measures."""
    made: list[Handle] = []
    geometry = MODELS[muscle.model].geometry
    if geometry == "fibres":
        for number, fibre in enumerate(muscle.fibres):
            made.append(Handle("origin", fibre.origin, number))
            made += [Handle("via", point, number, place) for place, point in enumerate(fibre.via)]
            made.append(Handle("attachment", fibre.attachment, number))
    elif muscle.ring is not None and geometry == "ring":
        ring = muscle.ring
        made.append(Handle("centre", ring.centre))
        made.append(Handle("long", ring.centre + ring.long_axis))
        made.append(Handle("short", ring.centre + ring.short_axis))
    if made or geometry == "skull":
        for measure in measures_of(muscle):
            made += [Handle(measure, point, fibre, place) for point, fibre, place in places(muscle, measure, face)]
    return tuple(made)


def dragged(
    muscle: Muscle, handle: Handle, to: FloatArray, face: Face, *, bone: Snap = "surface", skin: Snap = "vertex"
) -> Muscle:
    """A muscle with one of its handles dragged to a place (3,), snapped as asked.

    Origins are snapped to the skull and attachments to the skin, all of a fold to the skin; the rest goes where it is
    dragged.  Numbers stop at the ends of their range.

    Raises
    ------
    MuscleError
        If the muscle has no such handle, or a ring would be left without a width.
    """
    if handle.part == "origin" or handle.part == "attachment":
        return with_end(muscle, handle.fibre, handle.part, snapped(muscle, handle.part, face, to, bone=bone, skin=skin))
    if handle.part == "via":
        return with_via(muscle, handle.fibre, handle.place, snapped(muscle, "via", face, to, skin=skin))
    if handle.part == "centre":
        return with_centre(muscle, to)
    if handle.part == "long" or handle.part == "short":
        return with_axis(muscle, handle.part, to)
    return measured(muscle, handle.part, handle.fibre, handle.place, to, face)
