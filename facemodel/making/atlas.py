"""The muscle atlas in words: origin and attachment of every muscle by landmarks, the same for every head.

Origins and insertions follow the anatomy of the facial muscles; offsets are (lateral, up, forward) in millimetres.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from facemodel.actions import Side
from facemodel.face import Eye, Skull
from facemodel.making.placement import Placement, Spot
from facemodel.making.rings import STRENGTH, eye_rings, mouth_rings
from facemodel.mesh import Mesh
from facemodel.muscles import Fibre, Muscle

FAN = 50
"""Fibres generated per muscle, as in the 1998 paper."""


@dataclass(frozen=True)
class Band:
    """A muscle of linear fibres: pairs of origin (on bone) and attachment (on skin), in order across the muscle."""

    title: str
    group: str
    fibres: tuple[tuple[Spot, Spot], ...]
    width: float
    kappa: float = 3.0
    midline: bool = False


BANDS: Mapping[str, Band] = {
    "frontalis_medialis": Band(
        "Frontalis, pars medialis",
        "brow",
        (
            (Spot("brow_inner", (-6, 46, 0)), Spot("brow_inner", (-5, 1, 0))),
            (Spot("brow_inner", (4, 46, 0)), Spot("brow_inner", (4, 2, 0))),
            (Spot("brow_inner", (12, 46, 0)), Spot("brow_inner", (11, 3, 0))),
        ),
        width=11,
    ),
    "frontalis_lateralis": Band(
        "Frontalis, pars lateralis",
        "brow",
        (
            (Spot("brow_mid", (3, 44, 0)), Spot("brow_mid", (1, 1, 0))),
            (Spot("brow_mid", (11, 43, 0)), Spot("brow_mid", (8, 1, 0))),
            (Spot("brow_outer", (5, 40, -4)), Spot("brow_outer", (0, 3, 0))),
        ),
        width=12,
    ),
    "corrugator": Band(
        "Corrugator supercilii",
        "brow",
        (
            (Spot("brow_inner", (-12, -7, 0)), Spot("brow_inner", (3, 1, 0))),
            (Spot("brow_inner", (-12, -6, 0)), Spot("brow_mid", (-5, 1, 0))),
            (Spot("brow_inner", (-12, -5, 0)), Spot("brow_mid", (3, 2, 0))),
        ),
        width=9,
    ),
    "depressor_supercilii": Band(
        "Depressor supercilii",
        "brow",
        (
            (Spot("eye_inner", (-5, 3, 2)), Spot("brow_inner", (-2, 0, 0))),
            (Spot("eye_inner", (-3, 4, 2)), Spot("brow_inner", (6, 0, 0))),
        ),
        width=9,
    ),
    "procerus": Band(
        "Procerus",
        "brow",
        (
            (Spot("rhinion", (-4, 0, 0)), Spot("glabella", (-6, 0, 0))),
            (Spot("rhinion", (4, 0, 0)), Spot("glabella", (6, 0, 0))),
        ),
        width=9,
        midline=True,
    ),
    "levator_labii_superioris_alaeque_nasi": Band(
        "Levator labii superioris alaeque nasi",
        "nose",
        (
            (Spot("eye_inner", (-8, 2, 4)), Spot("ala", (-2, 8, 2))),
            (Spot("eye_inner", (-7, 0, 4)), Spot("ala", (2, 4, 0))),
            (Spot("eye_inner", (-5, -3, 4)), Spot("ala", (4, -4, 0))),
        ),
        width=9,
    ),
    "levator_labii_superioris": Band(
        "Levator labii superioris, caput infraorbitale",
        "lip",
        (
            (Spot("suborbital", (-10, 2, 0)), Spot("cupid_bow", (1, 2, 0))),
            (Spot("suborbital", (-4, 1, 0)), Spot("cupid_bow", (6, 2, 0))),
            (Spot("suborbital", (3, 0, 0)), Spot("cupid_bow", (11, 1, 0))),
        ),
        width=10,
    ),
    "zygomaticus_minor": Band(
        "Zygomaticus minor",
        "cheek",
        (
            (Spot("cheek", (-2, 2, 0)), Spot("cupid_bow", (9, 4, 0))),
            (Spot("cheek", (3, 2, 0)), Spot("nasolabial", (-4, -4, 0))),
        ),
        width=10,
    ),
    "zygomaticus_major": Band(
        "Zygomaticus major",
        "cheek",
        (
            (Spot("lateral_orbit", (8, -8, -10)), Spot("mouth_corner", (0, 3, 0))),
            (Spot("lateral_orbit", (10, -12, -12)), Spot("mouth_corner", (2, 0, 0))),
            (Spot("lateral_orbit", (11, -16, -14)), Spot("mouth_corner", (1, -3, 0))),
        ),
        width=12,
    ),
    "levator_anguli_oris": Band(
        "Levator anguli oris",
        "lip",
        (
            (Spot("suborbital", (-2, -8, 0)), Spot("mouth_corner", (-2, 2, 0))),
            (Spot("suborbital", (2, -8, 0)), Spot("mouth_corner", (2, 1, 0))),
        ),
        width=9,
    ),
    "buccinator": Band(
        "Buccinator",
        "cheek",
        (
            (Spot("upper_second_molar", (2, -2, -8)), Spot("mouth_corner", (1, 4, 0))),
            (Spot("upper_second_molar", (2, -8, -8)), Spot("mouth_corner", (3, 0, 0))),
            (Spot("lower_second_molar", (2, 6, -8)), Spot("mouth_corner", (1, -4, 0))),
        ),
        width=11,
    ),
    "risorius": Band(
        "Risorius",
        "cheek",
        (
            (Spot("mid_masseter", (0, -2, 4)), Spot("mouth_corner", (2, 2, 0))),
            (Spot("mid_masseter", (0, -8, 4)), Spot("mouth_corner", (3, -2, 0))),
        ),
        width=11,
    ),
    "platysma": Band(
        "Platysma",
        "chin",
        (
            (Spot("gonion", (-2, -6, 2)), Spot("mouth_corner", (3, -5, 0))),
            (Spot("gonion", (-6, -10, 10)), Spot("mouth_corner", (2, -12, 0))),
        ),
        width=13,
    ),
    "depressor_anguli_oris": Band(
        "Depressor anguli oris",
        "chin",
        (
            (Spot("mouth_corner", (-4, -34, -4)), Spot("mouth_corner", (-1, -1, 0))),
            (Spot("mouth_corner", (4, -33, -8)), Spot("mouth_corner", (3, 0, 0))),
        ),
        width=10,
    ),
    "depressor_labii_inferioris": Band(
        "Depressor labii inferioris",
        "chin",
        (
            (Spot("pogonion", (10, -6, 0)), Spot("lower_vermilion", (8, 1, 0))),
            (Spot("pogonion", (16, -5, 0)), Spot("lower_vermilion", (12, 1, 0))),
            (Spot("pogonion", (22, -4, 0)), Spot("lower_vermilion", (16, 2, 0))),
        ),
        width=8,
    ),
    "mentalis": Band(
        "Mentalis",
        "chin",
        (
            (Spot("lower_vermilion", (2, 0, 0)), Spot("chin", (3, 3, 0))),
            (Spot("lower_vermilion", (6, 0, 0)), Spot("chin", (9, 5, 0))),
        ),
        width=11,
        kappa=1.5,
    ),
    "incisivus_labii_superioris": Band(
        "Incisivus labii superioris",
        "lip",
        (
            (Spot("upper_lip_incisor", (0, 4, 0)), Spot("mouth_corner", (1, 3, 0))),
            (Spot("upper_lip_incisor", (0, 2, 0)), Spot("mouth_corner", (1, 0, 0))),
        ),
        width=9,
    ),
    "incisivus_labii_inferioris": Band(
        "Incisivus labii inferioris",
        "lip",
        (
            (Spot("lower_lip_incisor", (0, -4, 0)), Spot("mouth_corner", (1, -3, 0))),
            (Spot("lower_lip_incisor", (0, -2, 0)), Spot("mouth_corner", (1, 0, 0))),
        ),
        width=9,
    ),
}
"""Muscles made of linear fibres, by name without side."""


def _band(name: str, band: Band, side: Side, place: Placement) -> Muscle:
    fibres = tuple(Fibre(place.on_bone(o, side), place.on_skin(a, side)) for o, a in band.fibres)
    return Muscle(
        name,
        "M" if band.midline else side,
        band.title,
        band.group,
        "fibre",
        fibres,
        None,
        band.width * place.scale,
        band.kappa,
        STRENGTH,
        FAN,
    )


def make_muscles(skin: Mesh, skull: Skull, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]) -> tuple[Muscle, ...]:
    """All muscles of a head, left before right."""
    place = Placement(skin, skull, landmarks)
    made: list[Muscle] = []
    for name, band in BANDS.items():
        sides: tuple[Side, ...] = ("L",) if band.midline else ("L", "R")
        made += [_band(name, band, side, place) for side in sides]
    for eye in eyes:
        made += eye_rings(place, eye)
    return (*made, *mouth_rings(place))
