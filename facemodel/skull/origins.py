"""Muscles whose bone has moved: their origins go along, or come to lie on the new bone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from facemodel.face import Face
from facemodel.laying.places import SNAPPED, nearest, on_bone
from facemodel.muscles import Fibre, Muscle
from facemodel.skull.placement import carried
from fem.types import FloatArray


def with_origins_carried(muscles: Sequence[Muscle], face: Face, way: FloatArray) -> tuple[Muscle, ...]:
    """Muscles of a face after its bone went an affine way (4, 4): origins and bends go along, attachments stay.

    An origin on the skin, as pseudo-muscles may have, stays as well.
    """
    return tuple(_moved(muscle, face, lambda points: carried(points, way)) for muscle in muscles)


def with_origins_settled(muscles: Sequence[Muscle], before: Face, after: Face) -> tuple[Muscle, ...]:
    """Muscles whose origins come to lie on the nearest place of another skull; bends stay where they are."""

    def settled(points: FloatArray) -> FloatArray:
        made = points.copy()
        made[0] = on_bone(after, points[0])
        return made

    return tuple(_moved(muscle, before, settled) for muscle in muscles)


def _moved(muscle: Muscle, face: Face, move: Callable[[FloatArray], FloatArray]) -> Muscle:
    fibres = tuple(_fibre(fibre, face, move) for fibre in muscle.fibres)
    unmoved = all(one is other for one, other in zip(fibres, muscle.fibres, strict=True))
    return muscle if unmoved else replace(muscle, fibres=fibres)


def _fibre(fibre: Fibre, face: Face, move: Callable[[FloatArray], FloatArray]) -> Fibre:
    if nearest(face.skin, fibre.origin)[2][0] < SNAPPED:
        return fibre
    *inner, _ = move(fibre.points)
    return replace(fibre, origin=inner[0], via=tuple(inner[1:]))
