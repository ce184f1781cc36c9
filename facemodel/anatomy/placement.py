"""One head, on which words of the recipe become points of skin and bone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from facemodel.anatomy.recipe import Course, Spot
from facemodel.face import Skull
from facemodel.laying.places import nearest
from facemodel.mesh import Mesh
from facemodel.muscles import Fibre
from fem.types import FloatArray

SCALE_FROM = ("eye_outer_L", "eye_outer_R")
EYES_APART = 87.0
"""Millimetres between the outer canthi for which lengths are written; other heads scale them."""

OWN_SIDE = 2.0
"""Millimetres from the midline beyond which both ends of a paired muscle stay."""

IN_MIDLINE = 0.01
"""Millimetres from the midline within which a place is meant to be in it: faces are as symmetric as that."""


class Placement:
    """One head, on which spots become points.

    Parameters
    ----------
    skin : the skin at rest
    skull : the bone under it
    landmarks : skin vertices by name
    """

    def __init__(self, skin: Mesh, skull: Skull, landmarks: Mapping[str, int]) -> None:
        self._skin = skin
        self._skull = skull
        self._landmarks = landmarks
        left, right = (skin.positions[landmarks[name]] for name in SCALE_FROM)
        self.scale = float(np.linalg.norm(left - right)) / EYES_APART

    def landmark(self, name: str, side: str) -> FloatArray:
        """A landmark (3,); one without side is that of the side that is asked for."""
        full = name if name in self._landmarks else f"{name}_{'R' if side == 'R' else 'L'}"
        return np.asarray(self._skin.positions[self._landmarks[full]])

    def offset(self, offset: tuple[float, float, float], side: str) -> FloatArray:
        """An offset (3,) on this head; ``side`` ``R`` mirrors it."""
        return np.asarray(offset) * [-1.0 if side == "R" else 1.0, 1.0, 1.0] * self.scale

    def point(self, spot: Spot, side: str) -> FloatArray:
        """The spot itself (3,), not snapped."""
        return np.asarray(self.landmark(spot.landmark, side) + self.offset(spot.offset, side))

    def on_skin(self, spot: Spot, side: str) -> FloatArray:
        """The nearest place (3,) of the skin to a spot."""
        return np.array(nearest(self._skin, self.point(spot, side))[0][0])

    def on_bone(self, spot: Spot, side: str) -> FloatArray:
        """The bone (3,) under the place of the skin that is nearest to a spot."""
        return self._below(self.point(spot, side))

    def fibre(self, course: Course, side: str, paired: bool = True) -> Fibre:
        """A central fibre, which touches bone in between as often as its course says.

        That of a paired muscle keeps to its own side: where its words would bring an end across the midline of a narrow
        head, it stays `OWN_SIDE` short of that.  An unpaired one that is meant to arise in the midline does.
        """
        ends = (self.point(spot, side) for spot in (course.origin, course.attachment))
        start, end = (self._kept(point, side) for point in ends) if paired else ends
        origin, attachment = self._below(start), np.array(nearest(self._skin, end)[0][0])
        if abs(start[0]) < IN_MIDLINE:
            origin[0] = 0.0  # the bone nearest to skin of the midline may be on either side of it by a hair
        shares = np.linspace(0, 1, course.over + 2)[1:-1]
        return Fibre(origin, attachment, tuple(self._below(origin + s * (attachment - origin)) for s in shares))

    def along_skin(self, spots: Sequence[Spot], side: str) -> Fibre:
        """A fibre on the skin through two spots or more."""
        first, *between, last = (self.on_skin(spot, side) for spot in spots)
        return Fibre(first, last, tuple(between))

    def _kept(self, point: FloatArray, side: str) -> FloatArray:
        """A point (3,) no nearer to the midline than a paired muscle comes."""
        outward, least = (-1.0 if side == "R" else 1.0), OWN_SIDE * self.scale
        return np.array([outward * max(outward * float(point[0]), least), *point[1:]])

    def _below(self, point: FloatArray) -> FloatArray:
        """The bone (3,) under the place of the skin that is nearest to a point."""
        place, triangle, _ = nearest(self._skin, point)
        corners = self._skin.triangles[int(triangle[0])]
        share = barycentric(self._skin.positions[corners], place[0])
        return np.asarray(share @ self._skull.anchors[corners])


def barycentric(corners: FloatArray, point: FloatArray) -> FloatArray:
    """Shares (3,) of the corners (3, 3) of a triangle in a point (3,) of it."""
    edges = np.stack([corners[1] - corners[0], corners[2] - corners[0]], axis=1)
    second, third = np.linalg.lstsq(edges, point - corners[0], rcond=None)[0]
    return np.array([1 - second - third, second, third])
