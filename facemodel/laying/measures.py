"""Handles that stand for a number: where they are for its value, and the value where they are dragged to.

What they measure: the width beside an attachment or past the tip of a ring; how far the profiles of a mouth reach; the
share of its way that a pseudo-muscle goes; K of a pseudo-sphincter along each axis; half of a bounding box; the force
of the jaw.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Literal

import numpy as np

from facemodel.face import Face
from facemodel.laying.fibres import fibre_of
from facemodel.laying.rings import frame_of, ring_of
from facemodel.laying.values import parameter_of
from facemodel.muscles import Muscle, Profile, Profiles
from facemodel.muscles.cosine import cosine_of
from facemodel.muscles.curve import SHORTEST
from facemodel.muscles.jaw import opening_at_teeth
from facemodel.muscles.models import MODELS
from facemodel.muscles.mouth import PROFILES
from facemodel.muscles.parameters import STRENGTH, Parameter, with_value
from fem.types import FloatArray

Measure = Literal["radius", "reach", "share", "factor", "box", "force"]

Place = tuple[FloatArray, int, int]
"""A point (3,), the number of the fibre, and which of x, y and z."""

LEVER = 60.0
"""Millimetres that the arrow of the jaw is long at the largest strength; its length grows with the root of the force,
so that a small one can still be taken hold of."""

NEAREST = 0.1
"""Half axes within which the profiles of a mouth cannot be drawn together further."""


def measures_of(muscle: Muscle) -> tuple[Measure, ...]:
    """What is measured by handles under a muscle's model, in the order in which they are found."""
    names = {parameter.name for parameter in MODELS[muscle.model].parameters}
    there: dict[Measure, bool] = {
        "radius": "width" in names and "profiles.sigma" not in names,
        "reach": "profiles.sigma" in names,
        "share": "cosine.share" in names,
        "factor": "cosine.factors.x" in names,
        "box": "cosine.box.x" in names,
        "force": MODELS[muscle.model].geometry == "skull",
    }
    return tuple(measure for measure, is_there in there.items() if is_there)


def places(muscle: Muscle, measure: Measure, face: Face) -> list[Place]:
    """Where the handles of a measure are."""
    return _PLACES[measure](muscle, face)


def foot(muscle: Muscle, measure: Measure, fibre: int, face: Face) -> FloatArray:
    """The point (3,) from which a handle measures."""
    if measure == "force":
        return face.skull.jaw.teeth
    return fibre_of(muscle, fibre).attachment if _on_fibres(muscle) else ring_of(muscle).centre


def measured(muscle: Muscle, measure: Measure, fibre: int, place: int, to: FloatArray, face: Face) -> Muscle:
    """A muscle with the number that a handle means where it is dragged to (3,); it stops at the ends of its range."""
    if measure == "reach":
        return _reaching(muscle, to)
    name, value = _VALUES[measure](muscle, fibre, place, to, face)
    parameter = parameter_of(muscle, name)
    assert isinstance(parameter, Parameter)
    return with_value(muscle, name, float(np.clip(value, parameter.least, parameter.most)))


def _on_fibres(muscle: Muscle) -> bool:
    return MODELS[muscle.model].geometry == "fibres"


def _radii(muscle: Muscle, face: Face) -> list[Place]:
    """Beside the outer attachments, or past the tip of a ring's long axis."""
    if not _on_fibres(muscle):
        ring = ring_of(muscle)
        tip = ring.long_axis * (1 + muscle.width / max(float(np.linalg.norm(ring.long_axis)), SHORTEST))
        return [(ring.centre + tip, 0, 0)]
    last = len(muscle.fibres) - 1
    sides = ((0, 1.0),) if last == 0 else ((0, 1.0), (last, -1.0))
    return [(muscle.fibres[k].attachment + turn * muscle.width * _aside(muscle, k, face), k, 0) for k, turn in sides]


def _radius_at(muscle: Muscle, fibre: int, _place: int, to: FloatArray, _face: Face) -> tuple[str, float]:
    if _on_fibres(muscle):
        return "width", float(np.linalg.norm(to - fibre_of(muscle, fibre).attachment))
    ring = ring_of(muscle)
    length = float(np.linalg.norm(ring.long_axis))
    return "width", float((to - ring.centre) @ ring.long_axis) / max(length, SHORTEST) - length


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


def profiles_end(muscle: Muscle) -> float:
    """Where both profiles of a mouth have come to zero, in half axes of its ring."""
    profiles = muscle.profiles or PROFILES
    return max(profiles.sigma.at[-1], profiles.tau.at[-1])


def _reaches(muscle: Muscle, _face: Face) -> list[Place]:
    ring = ring_of(muscle)
    return [(ring.centre + profiles_end(muscle) * ring.long_axis, 0, 0)]


def _reaching(muscle: Muscle, to: FloatArray) -> Muscle:
    """Both profiles drawn out or together, so that they end where the handle is."""
    ring, profiles = ring_of(muscle), muscle.profiles or PROFILES
    square = max(float(ring.long_axis @ ring.long_axis), SHORTEST**2)
    furthest = min(parameter_reach(muscle, name) for name in ("profiles.sigma", "profiles.tau"))
    end = float(np.clip((to - ring.centre) @ ring.long_axis / square, NEAREST, furthest))
    share = end / profiles_end(muscle)
    sigma, tau = (Profile(tuple(share * x for x in each.at), each.values) for each in (profiles.sigma, profiles.tau))
    return replace(muscle, profiles=Profiles(sigma, tau))


def parameter_reach(muscle: Muscle, name: str) -> float:
    """Largest distance of a knot of a profile, in half axes."""
    parameter = parameter_of(muscle, name)
    return float("inf") if isinstance(parameter, Parameter) else parameter.reach


def _shares(muscle: Muscle, _face: Face) -> list[Place]:
    fibre, share = fibre_of(muscle, 0), cosine_of(muscle).share
    return [(fibre.attachment + share * (fibre.origin - fibre.attachment), 0, 0)]


def _share_at(muscle: Muscle, fibre: int, _place: int, to: FloatArray, _face: Face) -> tuple[str, float]:
    way = fibre_of(muscle, fibre).origin - fibre_of(muscle, fibre).attachment
    return "cosine.share", float((to - fibre_of(muscle, fibre).attachment) @ way / max(float(way @ way), SHORTEST**2))


def _factors(muscle: Muscle, _face: Face) -> list[Place]:
    """Where the far tips of the ring, and one as far out of it as it is high, go at full contraction."""
    centre, factors = ring_of(muscle).centre, cosine_of(muscle).factors
    return [(centre - (1 - factors[k]) * axis, 0, k) for k, axis in enumerate(frame_of(ring_of(muscle)))]


def _factor_at(muscle: Muscle, _fibre: int, place: int, to: FloatArray, _face: Face) -> tuple[str, float]:
    axis = frame_of(ring_of(muscle))[place]
    out = -float((to - ring_of(muscle).centre) @ axis) / max(float(axis @ axis), SHORTEST**2)
    return f"cosine.factors.{'xyz'[place]}", 1 - out


def _boxes(muscle: Muscle, face: Face) -> list[Place]:
    centre = foot(muscle, "box", 0, face)
    return [(centre + step, 0, k) for k, step in enumerate(np.diag(cosine_of(muscle).box))]


def _box_at(muscle: Muscle, _fibre: int, place: int, to: FloatArray, face: Face) -> tuple[str, float]:
    return f"cosine.box.{'xyz'[place]}", abs(float((to - foot(muscle, "box", 0, face))[place]))


def _forces(muscle: Muscle, face: Face) -> list[Place]:
    length = LEVER * np.sqrt(max(muscle.strength, 0.0) / STRENGTH.most)
    return [(face.skull.jaw.teeth + length * opening_at_teeth(face), 0, 0)]


def _force_at(_muscle: Muscle, _fibre: int, _place: int, to: FloatArray, face: Face) -> tuple[str, float]:
    length = max(float((to - face.skull.jaw.teeth) @ opening_at_teeth(face)), 0.0)
    return "strength", STRENGTH.most * (length / LEVER) ** 2


_PLACES: Mapping[Measure, Callable[[Muscle, Face], list[Place]]] = {
    "radius": _radii,
    "reach": _reaches,
    "share": _shares,
    "factor": _factors,
    "box": _boxes,
    "force": _forces,
}

_VALUES: Mapping[Measure, Callable[[Muscle, int, int, FloatArray, Face], tuple[str, float]]] = {
    "radius": _radius_at,
    "share": _share_at,
    "factor": _factor_at,
    "box": _box_at,
    "force": _force_at,
}
