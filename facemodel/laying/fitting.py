"""Fit muscles to another shape of head: by landmarks first, then each end onto what it lay on before."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from facemodel.face import Face
from facemodel.laying.places import Kind, kind_of_place, settled
from facemodel.laying.sides import mirrored, partner
from facemodel.laying.warp import Warp, control_points, landmark_warp
from facemodel.muscles import Fibre, Muscle, Sphincter
from facemodel.muscles.models import MODELS
from fem.types import FloatArray


def fitted_atlas(muscles: Sequence[Muscle], source: Face, target: Face) -> tuple[Muscle, ...]:
    """All muscles of one head on another one; the right of two linked partners stays the mirror image of the left.

    Parameters
    ----------
    muscles : on the head ``source``
    source, target : heads that share landmarks

    Raises
    ------
    MuscleError
        If the heads share too few landmarks, or these lie in a plane.
    """
    warp = landmark_warp(control_points(source), control_points(target))
    made: list[Muscle] = []
    for muscle in muscles:
        left = partner(muscles, muscle)
        if muscle.side == "R" and muscle.linked and left is not None and left.linked:
            made.append(mirrored(fitted(left, warp, target, source), target))
        else:
            made.append(fitted(muscle, warp, target, source))
    return tuple(made)


def fitted(muscle: Muscle, warp: Warp, target: Face, source: Face | None = None) -> Muscle:
    """One muscle carried by a warp and snapped to the head ``target``.

    Ends come to lie on what they lay on in ``source``: a vertex of the skin, the bone under one, skin or bone
    elsewhere; without a source, origins go to the bone and attachments to the skin.  The width grows with the
    head about the attachments; strength, kappa and count stay.
    """
    ring = None if muscle.ring is None else _fitted_ring(muscle.ring, warp)
    lies: Kind = "skin" if MODELS[muscle.model].along_skin else "bone"
    fibres = tuple(_fitted_fibre(fibre, lies, warp, target, source) for fibre in muscle.fibres)
    scale = _scale(muscle, ring, warp)
    cosine = None if muscle.cosine is None else replace(muscle.cosine, box=muscle.cosine.box * scale)
    return replace(muscle, fibres=fibres, ring=ring, width=muscle.width * scale, cosine=cosine)


def _scale(muscle: Muscle, ring: Sphincter | None, warp: Warp) -> float:
    """How much the skin grows that a muscle moves: that about its attachments, or its ring itself."""
    if muscle.ring is not None and ring is not None:
        before, after = (np.linalg.norm(np.cross(each.long_axis, each.short_axis)) for each in (muscle.ring, ring))
        return float(np.sqrt(after / before))
    if not muscle.fibres:
        return 1.0
    return warp.scale(np.mean([fibre.attachment for fibre in muscle.fibres], axis=0))


def _fitted_fibre(fibre: Fibre, lies: Kind, warp: Warp, target: Face, source: Face | None) -> Fibre:
    """A fibre carried along; without a source it begins on what it ``lies`` on."""
    kinds: tuple[Kind, Kind] = (lies, "skin")
    if source is not None:
        kinds = kind_of_place(source, fibre.origin)[0], kind_of_place(source, fibre.attachment)[0]
    moved = warp(fibre.points)
    between = [settled(target, point, "skin") if lies == "skin" else point for point in moved[1:-1]]
    return Fibre(settled(target, moved[0], kinds[0]), settled(target, moved[-1], kinds[1]), tuple(between))


def _fitted_ring(ring: Sphincter, warp: Warp) -> Sphincter:
    centre = warp(ring.centre)[0]
    long_axis, short_axis = (_fitted_axis(ring.centre, axis, warp) for axis in (ring.long_axis, ring.short_axis))
    height, along = np.linalg.norm(short_axis), long_axis / np.linalg.norm(long_axis)
    upright = short_axis - (short_axis @ along) * along
    sector = _fitted_axis(ring.centre, ring.sector, warp) if ring.sector.any() else ring.sector
    return replace(
        ring,
        centre=centre,
        long_axis=long_axis,
        short_axis=upright * height / np.linalg.norm(upright),
        sector=sector,
    )


def _fitted_axis(centre: FloatArray, axis: FloatArray, warp: Warp) -> FloatArray:
    ends = warp(np.array([centre + axis, centre - axis]))
    return np.asarray((ends[0] - ends[1]) / 2)
