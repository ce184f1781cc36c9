"""Lay sphincters and the levators of the lids around eyes and mouth."""

from __future__ import annotations

import numpy as np

from facemodel.anatomy.placement import Placement
from facemodel.anatomy.recipe import Ring, Spot
from facemodel.face import Eye
from facemodel.muscles import Muscle, Profile, Profiles, Sphincter
from facemodel.muscles.mouth import PROFILES
from facemodel.muscles.muscle import MuscleSide
from fem.types import FloatArray

UP = np.array([0.0, 1.0, 0.0])
ABOUT_MOUTH = ("mouth", "lips")


def laid_rings(ring: Ring, place: Placement, eyes: tuple[Eye, Eye]) -> list[Muscle]:
    """A ring on a head: one about each eye, or one or two halves about the mouth."""
    if ring.around == "cheek":
        return [_muscle(ring, eye.side, _about_cheek(ring, place, eye.side), place.scale) for eye in eyes]
    if ring.around not in ABOUT_MOUTH:
        return [_muscle(ring, eye.side, _about_eye(ring, place, eye), place.scale) for eye in eyes]
    whole = _about_mouth(ring, place)
    if ring.sector != "half":
        return [_muscle(ring, "M", whole, place.scale)]
    return [_muscle(ring, eye.side, _halved(whole, eye.side), place.scale) for eye in eyes]


def _muscle(ring: Ring, side: MuscleSide, laid: Sphincter, scale: float) -> Muscle:
    profiles = None
    if ring.model == "mouth":
        profiles = Profiles(_times(PROFILES.sigma, ring.inward), _times(PROFILES.tau, ring.forward))
    width = ring.width * scale
    return Muscle(ring.name, side, ring.title, ring.group, ring.model, (), laid, width, 1.0, ring.strength, 1, profiles)


def _times(profile: Profile, factor: float) -> Profile:
    return Profile(profile.at, tuple(factor * value for value in profile.values))


def _about_eye(ring: Ring, place: Placement, eye: Eye) -> Sphincter:
    """A ring between the corners of an eye.

    About its ``lids`` it is as high as they stand, about the ``eyeball`` as deep as that one's centre, about which the
    lid turns.
    """
    side = eye.side
    inner, outer, top, bottom = (
        place.on_skin(Spot(name), side) for name in ("eye_inner", "eye_outer", "upper_lid_mid", "lower_lid_mid")
    )
    along = np.abs((outer - inner) / 2) * [1.0, 0.0, 0.0]
    fissure = (top + bottom) / 2
    centres = {
        "eye": (inner + outer) / 2,
        "lids": fissure,
        "eyeball": eye.centre + ((fissure - eye.centre) @ UP) * UP,
    }
    return _ring(ring, place, centres[ring.around], along, float(abs(top - bottom) @ UP) / 2, side)


def _about_cheek(ring: Ring, place: Placement, side: str) -> Sphincter:
    """A ring on the hollow of a cheek, between the corner of the mouth and the middle of the masseter."""
    corner, masseter, above, below = (
        place.on_skin(Spot(name), side)
        for name in ("mouth_corner", "mid_masseter", "upper_second_molar", "lower_second_molar")
    )
    outward = 1.0 if side == "L" else -1.0
    return _ring(ring, place, (corner + above + below) / 3, outward * (masseter - corner) / 2, 0.0, side)


def _about_mouth(ring: Ring, place: Placement) -> Sphincter:
    """A ring between the corners of the mouth.

    About the ``mouth`` it lies as deep as these, about the ``lips`` as far before them as the lips stand, which people
    differ in by half: what pushes lips must find them.
    """
    left, right = (place.on_skin(Spot("mouth_corner"), side) for side in ("L", "R"))
    upper, lower = (place.on_skin(Spot(name), "L") for name in ("upper_vermilion", "lower_vermilion"))
    middle = (left + right) / 2
    lips = (upper + lower) / 2
    centre = np.array([middle[0], lips[1], lips[2] if ring.around == "lips" else middle[2]])
    return _ring(ring, place, centre, (left - right) / 2, abs(upper[1] - lower[1]) / 2, "L")


def _ring(ring: Ring, place: Placement, centre: FloatArray, along: FloatArray, half: float, side: str) -> Sphincter:
    height = ring.height * place.scale + ring.relative * half
    up = UP - (UP @ along) / (along @ along) * along
    up *= height / np.linalg.norm(up)
    sector = {"above": up, "below": -up}.get(ring.sector, np.zeros(3))
    return Sphincter(
        centre + place.offset(ring.shift, side), ring.reach * along, up, sector, ring.focus, ring.inward, ring.forward
    )


def _halved(whole: Sphincter, side: str) -> Sphincter:
    sector = whole.long_axis if side == "L" else -whole.long_axis
    return Sphincter(whole.centre, whole.long_axis, whole.short_axis, sector, whole.focus, whole.inward, whole.forward)
