"""What of a muscle a hand can take hold of, and what becomes of the muscle when it drags there."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from facemodel.face import Face
from facemodel.laying.fibres import fibre_of, with_end, with_via
from facemodel.laying.places import Snap, on_bone, on_skin
from facemodel.laying.rings import ring_of, with_axis, with_centre
from facemodel.laying.values import parameter_of
from facemodel.muscles import Muscle
from facemodel.muscles.cosine import cosine_of
from facemodel.muscles.curve import SHORTEST
from facemodel.muscles.models import MODELS
from facemodel.muscles.parameters import Parameter
from fem.types import FloatArray

Part = Literal["origin", "attachment", "via", "radius", "box", "centre", "long", "short"]


@dataclass(frozen=True, eq=False)
class Handle:
    """A point of a muscle that can be dragged.

    Attributes
    ----------
    part : what it moves
    point : (3,) where it is, millimetres
    fibre : number of the central fibre it belongs to, for ends, intermediate points and radii
    place : which intermediate point of it, or which of x, y and z of a box
    """

    part: Part
    point: FloatArray
    fibre: int = 0
    place: int = 0


def handles(muscle: Muscle, face: Face) -> tuple[Handle, ...]:
    """All handles of a muscle under its model: ends and radii of fibres, middle, tips and radius of a ring, the box."""
    made: list[Handle] = []
    if MODELS[muscle.model].geometry == "fibres":
        for number, fibre in enumerate(muscle.fibres):
            made.append(Handle("origin", fibre.origin, number))
            made += [Handle("via", point, number, place) for place, point in enumerate(fibre.via)]
            made.append(Handle("attachment", fibre.attachment, number))
        made += _radii(muscle, face)
    elif muscle.ring is not None:
        ring = muscle.ring
        made.append(Handle("centre", ring.centre))
        made.append(Handle("long", ring.centre + ring.long_axis))
        made.append(Handle("short", ring.centre + ring.short_axis))
        made += _radii(muscle, face)
    if MODELS[muscle.model].action == "displacement":
        made += [
            Handle("box", _box_centre(muscle) + step, 0, k) for k, step in enumerate(np.diag(cosine_of(muscle).box))
        ]
    return tuple(made)


def dragged(
    muscle: Muscle, handle: Handle, to: FloatArray, face: Face, *, bone: Snap = "surface", skin: Snap = "vertex"
) -> Muscle:
    """A muscle with one of its handles dragged to a place (3,), snapped as asked.

    Origins are snapped to the skull and attachments to the skin; the rest goes where it is dragged.  Numbers
    stop at the ends of their range.

    Raises
    ------
    MuscleError
        If the muscle has no such handle, or a ring would be left without a width.
    """
    if handle.part == "origin":
        return with_end(muscle, handle.fibre, "origin", on_bone(face, to, bone))
    if handle.part == "attachment":
        return with_end(muscle, handle.fibre, "attachment", on_skin(face, to, skin))
    if handle.part == "via":
        return with_via(muscle, handle.fibre, handle.place, to)
    if handle.part == "radius":
        return replace(muscle, width=_within(muscle, "width", _radius_at(muscle, handle.fibre, to)))
    if handle.part == "box":
        how = cosine_of(muscle)
        box = how.box.copy()
        half = abs(float((to - _box_centre(muscle))[handle.place]))
        box[handle.place] = _within(muscle, f"cosine.box.{'xyz'[handle.place]}", half)
        return replace(muscle, cosine=replace(how, box=box))
    return with_centre(muscle, to) if handle.part == "centre" else with_axis(muscle, handle.part, to)


def _within(muscle: Muscle, name: str, value: float) -> float:
    parameter = parameter_of(muscle, name)
    assert isinstance(parameter, Parameter)
    return float(np.clip(value, parameter.least, parameter.most))


def _radii(muscle: Muscle, face: Face) -> list[Handle]:
    """Handles of the width: beside the outer attachments, or past the tip of a ring's long axis."""
    if all(parameter.name != "width" for parameter in MODELS[muscle.model].parameters):
        return []
    if MODELS[muscle.model].geometry == "ring":
        ring = ring_of(muscle)
        tip = ring.long_axis * (1 + muscle.width / max(float(np.linalg.norm(ring.long_axis)), SHORTEST))
        return [Handle("radius", ring.centre + tip)]
    last = len(muscle.fibres) - 1
    sides = ((0, 1.0),) if last == 0 else ((0, 1.0), (last, -1.0))
    return [
        Handle("radius", muscle.fibres[k].attachment + turn * muscle.width * _aside(muscle, k, face), k)
        for k, turn in sides
    ]


def _radius_at(muscle: Muscle, number: int, to: FloatArray) -> float:
    """The width that a radius dragged to a place (3,) means."""
    if MODELS[muscle.model].geometry == "fibres":
        return float(np.linalg.norm(to - fibre_of(muscle, number).attachment))
    ring = ring_of(muscle)
    length = float(np.linalg.norm(ring.long_axis))
    return float((to - ring.centre) @ ring.long_axis) / max(length, SHORTEST) - length


def _aside(muscle: Muscle, number: int, face: Face) -> FloatArray:
    """Unit vector (3,) along the skin at an attachment, away from the other fibres or across the only one."""
    fibre = muscle.fibres[number]
    normal = face.skin.normals[face.skin.tree.query(fibre.attachment)[1]]
    aside = np.cross(normal, fibre.points[-2] - fibre.attachment)
    if len(muscle.fibres) > 1:
        spine = muscle.fibres[0].attachment - muscle.fibres[-1].attachment
        flat = spine - (spine @ normal) * normal
        aside = flat if np.linalg.norm(flat) > SHORTEST else aside
    return np.asarray(aside / max(float(np.linalg.norm(aside)), SHORTEST))


def _box_centre(muscle: Muscle) -> FloatArray:
    """The point of application (3,): the first attachment, or the middle of the ring."""
    if MODELS[muscle.model].geometry == "fibres":
        return fibre_of(muscle, 0).attachment
    return ring_of(muscle).centre
