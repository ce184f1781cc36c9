"""Lay the muscles of a recipe on a head."""

from __future__ import annotations

from collections.abc import Mapping

from facemodel.actions import Side
from facemodel.anatomy.placement import Placement
from facemodel.anatomy.recipe import Anatomy, Band, Crease
from facemodel.anatomy.rings import laid_rings
from facemodel.face import Eye, Skull
from facemodel.mesh import Mesh
from facemodel.muscles import Muscle

FAN = 50
"""Fibres generated per muscle, as in the 1998 paper."""


def laid_band(band: Band, side: Side, place: Placement) -> Muscle:
    """A muscle of fibres on one side of a head."""
    return Muscle(
        band.name,
        "M" if band.midline else side,
        band.title,
        band.group,
        "fibre",
        tuple(place.fibre(course, side, not band.midline) for course in band.courses),
        None,
        band.width * place.scale,
        band.kappa,
        band.strength,
        FAN,
    )


def laid_crease(crease: Crease, side: Side, place: Placement) -> Muscle:
    """A fold of the skin on one side of a head."""
    fibre = place.along_skin(crease.spots, side)
    width = crease.width * place.scale
    return Muscle(crease.name, side, crease.title, crease.group, "fold", (fibre,), None, width, 1.0, crease.strength, 1)


def make_muscles(
    anatomy: Anatomy, skin: Mesh, skull: Skull, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]
) -> tuple[Muscle, ...]:
    """All muscles of a head, left before right."""
    place = Placement(skin, skull, landmarks)
    made: list[Muscle] = []
    for band in anatomy.bands:
        sides: tuple[Side, ...] = ("L",) if band.midline else ("L", "R")
        made += [laid_band(band, side, place) for side in sides]
    for ring in anatomy.rings:
        made += laid_rings(ring, place, eyes)
    for crease in anatomy.creases:
        made += [laid_crease(crease, side, place) for side in ("L", "R")]
    return tuple(made)
