"""The sphincters around the eyes and the mouth, and the levators of the lids, from landmarks."""

from __future__ import annotations

import numpy as np

from facemodel.actions import Side
from facemodel.face import Eye
from facemodel.making.placement import Placement, Spot
from facemodel.muscles import Muscle, Sphincter
from facemodel.muscles.muscle import Model, MuscleSide
from fem.types import FloatArray

STRENGTH = 0.01
"""N/mm^2 where the influence of a muscle is one; how far an action unit moves the skin is set by its gain."""

UP = np.array([0.0, 1.0, 0.0])


def _ring(name: str, side: MuscleSide, title: str, group: str, ring: Sphincter, width: float, model: Model) -> Muscle:
    return Muscle(name, side, title, group, model, (), ring, width, 1.0, STRENGTH, 1)


def _upright(along: FloatArray) -> FloatArray:
    """The unit vector nearest to up that is square to ``along``."""
    up = UP - (UP @ along) / (along @ along) * along
    return np.asarray(up / np.linalg.norm(up))


def eye_rings(place: Placement, eye: Eye) -> list[Muscle]:
    """Both parts of orbicularis oculi and the levator of the lid, around one eye."""
    side, scale = eye.side, place.scale
    inner, outer = place.on_skin(Spot("eye_inner"), side), place.on_skin(Spot("eye_outer"), side)
    top, bottom = place.on_skin(Spot("upper_lid_mid"), side), place.on_skin(Spot("lower_lid_mid"), side)
    along = np.abs((outer - inner) / 2) * [1, 0, 0]
    up = _upright(along)
    fissure = (top + bottom) / 2
    orbital = Sphincter((inner + outer) / 2 - 4 * scale * up, 2.1 * along, 27 * scale * up, -up, focus=0.5)
    palpebral = Sphincter(fissure, 1.25 * along, 9 * scale * up, focus=0.8)
    pivot = eye.centre + ((fissure - eye.centre) @ up) * up
    lid = Sphincter(pivot, 1.12 * along, 13 * scale * up)
    names = ("Orbicularis oculi, pars orbitalis", "Orbicularis oculi, pars palpebralis")
    return [
        _ring("orbicularis_oculi_orbitalis", side, names[0], "eye", orbital, 17 * scale, "sphincter"),
        _ring("orbicularis_oculi_palpebralis", side, names[1], "eye", palpebral, 8 * scale, "sphincter"),
        _ring("levator_palpebrae", side, "Levator palpebrae superioris", "eye", lid, 8 * scale, "lid"),
    ]


def mouth_rings(place: Placement) -> list[Muscle]:
    """Orbicularis oris: the peripheral ring that purses, in two halves, and the marginal rings that press."""
    corners = {side: place.on_skin(Spot("mouth_corner"), side) for side in ("L", "R")}
    middle = (corners["L"] + corners["R"]) / 2
    upper, lower = (place.on_skin(Spot(name), "L") for name in ("upper_vermilion", "lower_vermilion"))
    centre = np.array([middle[0], (upper[1] + lower[1]) / 2, middle[2]])
    along = (corners["L"] - corners["R"]) / 2
    scale = place.scale
    height = abs(upper[1] - lower[1]) / 2
    rings: list[Muscle] = []
    sides: tuple[Side, ...] = ("L", "R")
    for side in sides:
        sector = along if side == "L" else -along
        purse = Sphincter(centre, 0.95 * along, (height + 3 * scale) * UP, sector, focus=0.1, forward=0.9)
        rings.append(
            _ring(
                "orbicularis_oris_peripheral",
                side,
                "Orbicularis oris, pars peripheralis",
                "lip",
                purse,
                13 * scale,
                "sphincter",
            )
        )
    tight = Sphincter(centre, 0.8 * along, 0.8 * height * UP, focus=0.5, forward=-0.35)
    press = Sphincter(centre, 0.9 * along, height * UP, focus=0.95, forward=-0.2)
    title = "Orbicularis oris, pars marginalis"
    return [
        *rings,
        _ring("orbicularis_oris_marginal", "M", title, "lip", tight, 7 * scale, "sphincter"),
        _ring("orbicularis_oris_pressing", "M", f"{title} (pressing)", "lip", press, 7 * scale, "sphincter"),
    ]
