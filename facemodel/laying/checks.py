"""What is wrong with a muscle, in sentences for the person who lays it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from facemodel.errors import MuscleError
from facemodel.face import Face
from facemodel.laying.places import outside_head
from facemodel.muscles import Fibre, Muscle, Profile, Sphincter
from facemodel.muscles.cosine import cosine_of
from facemodel.muscles.models import MODELS, muscle_action
from facemodel.muscles.parameters import Parameter, ProfileParameter, value_of

ONE_POINT = 0.5
"""Millimetres: points of a fibre that are nearer than this have no direction that a hand could have meant."""

SQUARE = 0.02
"""Cosine between the half axes of a ring that still counts as a right angle."""

FEW = 8
"""Generated fibres that are enough to tell whether a muscle reaches the skin."""

THINNEST = 0.5
"""Millimetres of the smallest half axis of a ring."""


def complaints(muscle: Muscle, face: Face) -> tuple[str, ...]:
    """Everything that is wrong with a muscle on a face, one sentence each; empty if it can be used."""
    found = [*shape_complaints(muscle), *value_complaints(muscle)]
    if not found:
        found = list(_place_complaints(muscle, face))
    if not found and not reaches_skin(muscle, face):
        found = [f"“{muscle.key}” reaches no vertex of the skin; make it wider or move it to the skin."]
    return tuple(found)


def checked(muscle: Muscle, face: Face) -> Muscle:
    """The muscle itself, if it can be used.

    Raises
    ------
    MuscleError
        With the first complaint.
    """
    for complaint in complaints(muscle, face):
        raise MuscleError(complaint)
    return muscle


def reaches_skin(muscle: Muscle, face: Face) -> bool:
    """Whether fibres act on any vertex at all when they contract; a ring lies on the skin if it is placed well."""
    if MODELS[muscle.model].geometry != "fibres":
        return True
    contracted = replace(muscle, strength=1.0, count=FEW, cosine=replace(cosine_of(muscle), share=1.0))
    return bool(muscle_action(contracted, face).any())


def shape_complaints(muscle: Muscle) -> Iterator[str]:
    """What is wrong with the fibres or the ring of a muscle, wherever it lies."""
    works_on = MODELS[muscle.model].geometry
    if works_on == "fibres" and not muscle.fibres:
        yield f"“{muscle.key}” has no fibre; draw one from the skull to the skin."
    if works_on == "ring" and muscle.ring is None:
        yield f"“{muscle.key}” has no ring; draw an ellipse on the skin."
    for number, fibre in enumerate(muscle.fibres, start=1):
        yield from _fibre_complaints(f"Fibre {number} of “{muscle.key}”", fibre)
    if muscle.ring is not None:
        yield from _ring_complaints(muscle.key, muscle.ring)


def _fibre_complaints(name: str, fibre: Fibre) -> Iterator[str]:
    points = fibre.points
    if not np.isfinite(points).all():
        yield f"{name} has an end that is nowhere; place both ends anew."
    elif np.linalg.norm(fibre.origin - fibre.attachment) < ONE_POINT:
        yield f"{name} begins and ends at one point; drag its origin away from its attachment."
    elif any(np.linalg.norm(after - before) < ONE_POINT for before, after in pairwise(points)):
        yield f"{name} has two points at one place; take one of them out or drag it away."


def _ring_complaints(key: str, ring: Sphincter) -> Iterator[str]:
    axes = ring.long_axis, ring.short_axis
    if not np.isfinite([ring.centre, *axes, ring.sector]).all():
        yield f"The ring of “{key}” is nowhere; draw it anew."
        return
    a, b = (float(np.linalg.norm(axis)) for axis in axes)
    if min(a, b) < THINNEST:
        yield f"The ring of “{key}” has no width; drag its half axes to {THINNEST:g} mm at least."
    elif abs(axes[0] @ axes[1]) > SQUARE * a * b:
        yield f"The half axes of the ring of “{key}” are not at a right angle; drag one of them."


def value_complaints(muscle: Muscle) -> Iterator[str]:
    """Which parameters of its model are out of their range."""
    if muscle.ring is None and MODELS[muscle.model].geometry == "ring":
        return
    for parameter in MODELS[muscle.model].parameters:
        yield from complaints_of(muscle, parameter)


def complaints_of(muscle: Muscle, parameter: Parameter | ProfileParameter) -> Iterator[str]:
    """What is wrong with one parameter of a muscle."""
    value = value_of(muscle, parameter.name)
    if isinstance(parameter, ProfileParameter):
        yield from _profile_complaints(f"The {parameter.title.lower()} of “{muscle.key}”", parameter, value)
    elif not parameter.least <= value <= parameter.most:
        unit = f" {parameter.unit}" if parameter.unit else ""
        yield (
            f"“{parameter.title}” of “{muscle.key}” is {value:g}{unit}; "
            f"it has to be between {parameter.least:g} and {parameter.most:g}{unit}."
        )


def _profile_complaints(name: str, parameter: ProfileParameter, profile: Profile) -> Iterator[str]:
    ordered = len(profile.at) > 1 and profile.at[0] == 0 and all(a < b for a, b in pairwise(profile.at))
    if len(profile.at) != len(profile.values) or not ordered:
        yield f"{name} needs two knots or more, from 0 outward, with one value each."
    elif not (profile.at[-1] <= parameter.reach and np.isfinite(profile.values).all()):
        yield f"{name} reaches beyond {parameter.reach:g} half axes; drag its last knot inward."
    elif not all(parameter.least <= value <= parameter.most for value in profile.values):
        yield f"{name} has a value outside {parameter.least:g} to {parameter.most:g}; drag its knots back."
    elif profile.values[-1] != 0:
        yield f"{name} does not end at zero, so the skin would tear at its rim; drag its last knot to zero."


def _place_complaints(muscle: Muscle, face: Face) -> Iterator[str]:
    places = [
        (number, name, point)
        for number, fibre in enumerate(muscle.fibres, start=1)
        for name, point in zip(_names_of_points(fibre), fibre.points, strict=True)
    ]
    out = outside_head(face, np.array([point for *_, point in places]).reshape(-1, 3))
    for (number, name, _), is_out in zip(places, out, strict=True):
        if is_out:
            yield f"Fibre {number} of “{muscle.key}” has {name} outside the head; drag it in."
    if muscle.ring is not None and not _about_skin(muscle.ring, face):
        yield f"The ring of “{muscle.key}” lies away from the skin; drag its middle to the face."


def _names_of_points(fibre: Fibre) -> tuple[str, ...]:
    return ("its origin", *["a point between its ends"] * len(fibre.via), "its attachment")


def _about_skin(ring: Sphincter, face: Face) -> bool:
    """Whether some of the skin lies as near to the middle of a ring as its long half axis is long."""
    away = face.skin.tree.query(ring.centre)[0]
    return bool(away < 1.5 * np.linalg.norm(ring.long_axis))
