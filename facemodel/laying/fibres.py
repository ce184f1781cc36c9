"""Lay a fibre, drag its ends, bend it over the bone; a muscle is given and a muscle comes back."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from facemodel.errors import MuscleError
from facemodel.face import Face
from facemodel.laying.places import Snap, kind_of_place, on_bone, on_skin, settled
from facemodel.muscles import Fibre, Muscle
from facemodel.muscles.curve import SHORTEST
from facemodel.muscles.models import MODELS
from facemodel.muscles.quadrilateral import nearest_on_line
from fem.types import FloatArray

End = Literal["origin", "attachment"]
Point = Literal["origin", "attachment", "via"]


def laid_fibre(
    face: Face, origin: FloatArray, attachment: FloatArray, *, bone: Snap = "surface", skin: Snap = "vertex"
) -> Fibre:
    """A straight fibre from a place on the skull to one on the skin, each snapped as asked; (3,) in millimetres."""
    return Fibre(on_bone(face, origin, bone), on_skin(face, attachment, skin))


def snapped(
    muscle: Muscle, part: Point, face: Face, to: FloatArray, *, bone: Snap = "surface", skin: Snap = "vertex"
) -> FloatArray:
    """Where (3,) a point of a muscle's fibre that is dragged to ``to`` (3,) comes to lie.

    An origin lies on the skull, an attachment on the skin, what is between them anywhere; all of a fold is on the skin.
    """
    if MODELS[muscle.model].along_skin:
        return on_skin(face, to, "surface" if part == "via" and skin == "vertex" else skin)
    if part == "via":
        return np.array(to, dtype=np.float64)
    return on_bone(face, to, bone) if part == "origin" else on_skin(face, to, skin)


def fibre_of(muscle: Muscle, number: int) -> Fibre:
    """One of the central fibres of a muscle, counted from 0.

    Raises
    ------
    MuscleError
        If it has no such fibre.
    """
    if not 0 <= number < len(muscle.fibres):
        raise MuscleError(f"“{muscle.key}” has no fibre {number + 1}; it has {len(muscle.fibres)}.")
    return muscle.fibres[number]


def with_fibre(muscle: Muscle, number: int, fibre: Fibre) -> Muscle:
    """A muscle with another central fibre in place of one; raises `MuscleError` if there is no such fibre."""
    fibre_of(muscle, number)
    return replace(muscle, fibres=(*muscle.fibres[:number], fibre, *muscle.fibres[number + 1 :]))


def with_end(muscle: Muscle, number: int, end: End, point: FloatArray) -> Muscle:
    """A muscle with one end of a central fibre at another point (3,); snap it first with `places`."""
    fibre = fibre_of(muscle, number)
    at = np.array(point, dtype=np.float64)
    return with_fibre(muscle, number, replace(fibre, origin=at) if end == "origin" else replace(fibre, attachment=at))


def added_fibre(muscle: Muscle, fibre: Fibre) -> Muscle:
    """A muscle with one more central fibre, put where the spine of the muscle grows least by it."""
    ends = np.array([_middle(each) for each in muscle.fibres]).reshape(-1, 3)
    new = _middle(fibre)
    slots = range(len(muscle.fibres) + 1)
    slot = min(slots, key=lambda k: _detour(ends, new, k)) if len(ends) else 0
    return replace(muscle, fibres=(*muscle.fibres[:slot], fibre, *muscle.fibres[slot:]))


def beside(muscle: Muscle, face: Face) -> Muscle:
    """A muscle with one more central fibre at the end of its fan, a step beside the last.

    Its ends lie on what those of the last one lie on.  The step is the one between the last two fibres, or half the
    width of a muscle that has only one.

    Raises
    ------
    MuscleError
        If it has no fibre to lay one beside.
    """
    last = fibre_of(muscle, len(muscle.fibres) - 1)
    step = _middle(last) - _middle(muscle.fibres[-2]) if len(muscle.fibres) > 1 else np.zeros(3)
    if np.linalg.norm(step) < SHORTEST:
        normal = face.skin.normals[face.skin.tree.query(last.attachment)[1]]
        across = np.cross(normal, last.origin - last.attachment)
        step = across * (muscle.width / 2) / max(float(np.linalg.norm(across)), SHORTEST)
    origin, attachment = (
        settled(face, end + step, kind_of_place(face, end)[0]) for end in (last.origin, last.attachment)
    )
    via = tuple(np.asarray(point + step) for point in last.via)
    return replace(muscle, fibres=(*muscle.fibres, Fibre(origin, attachment, via)))


def removed_fibre(muscle: Muscle, number: int) -> Muscle:
    """A muscle without one of its central fibres.

    Raises
    ------
    MuscleError
        If there is no such fibre, or it is the last.
    """
    fibre_of(muscle, number)
    if len(muscle.fibres) == 1:
        raise MuscleError(f"“{muscle.key}” has no other fibre; delete the muscle instead.")
    return replace(muscle, fibres=(*muscle.fibres[:number], *muscle.fibres[number + 1 :]))


def reordered(muscle: Muscle, number: int, to: int) -> Muscle:
    """A muscle with one of its central fibres at another place in the order in which the fan goes through them.

    Raises
    ------
    MuscleError
        If there is no such fibre.
    """
    fibre = fibre_of(muscle, number)
    left = [*muscle.fibres[:number], *muscle.fibres[number + 1 :]]
    left.insert(min(max(to, 0), len(left)), fibre)
    return replace(muscle, fibres=tuple(left))


def bent(muscle: Muscle, number: int, point: FloatArray) -> tuple[Muscle, int]:
    """A muscle with an intermediate point (3,) more in a fibre, between the two points that it lies nearest to.

    Returns
    -------
    muscle : with the point
    place : which of the fibre's intermediate points it is
    """
    fibre = fibre_of(muscle, number)
    points = fibre.points
    at = np.array(point, dtype=np.float64)
    away = [float(np.linalg.norm(nearest_on_line(at[None], points[k : k + 2])[0] - at)) for k in range(len(points) - 1)]
    place = int(np.argmin(away))
    return with_fibre(muscle, number, replace(fibre, via=(*fibre.via[:place], at, *fibre.via[place:]))), place


def with_via(muscle: Muscle, number: int, place: int, point: FloatArray) -> Muscle:
    """A muscle with an intermediate point of a fibre elsewhere (3,)."""
    fibre = _bent_fibre(muscle, number, place)
    at = np.array(point, dtype=np.float64)
    return with_fibre(muscle, number, replace(fibre, via=(*fibre.via[:place], at, *fibre.via[place + 1 :])))


def without_via(muscle: Muscle, number: int, place: int) -> Muscle:
    """A muscle with an intermediate point of a fibre less; without any the fibre is straight."""
    fibre = _bent_fibre(muscle, number, place)
    return with_fibre(muscle, number, replace(fibre, via=(*fibre.via[:place], *fibre.via[place + 1 :])))


def _bent_fibre(muscle: Muscle, number: int, place: int) -> Fibre:
    fibre = fibre_of(muscle, number)
    if not 0 <= place < len(fibre.via):
        raise MuscleError(
            f"Fibre {number + 1} of “{muscle.key}” has no intermediate point {place + 1}; it has {len(fibre.via)}."
        )
    return fibre


def _middle(fibre: Fibre) -> FloatArray:
    return np.asarray((fibre.origin + fibre.attachment) / 2)


def _detour(middles: FloatArray, new: FloatArray, slot: int) -> float:
    """Millimetres by which a line through the middles of the fibres grows with a new one at a slot."""
    before, after = middles[slot - 1 : slot] if slot else middles[:0], middles[slot : slot + 1]
    around = [float(np.linalg.norm(each[0] - new)) for each in (before, after) if len(each)]
    spanned = float(np.linalg.norm(before[0] - after[0])) if len(around) == 2 else 0.0
    return sum(around) - spanned
