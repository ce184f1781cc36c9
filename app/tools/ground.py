"""The skin to paint on, with its tables, kept as long as the skin is the same."""

from __future__ import annotations

from facemodel.errors import PaintError
from facemodel.face import Face
from facemodel.laying.places import mirrored_place
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.mirror import mirror_partners
from facemodel.painting.surface import PaintSurface
from facemodel.sameness import Kept
from fem.types import IntArray


class Ground:
    """Finds the tables of a skin once."""

    def __init__(self) -> None:
        self._surface: Kept[PaintSurface] = Kept()
        self._partners: Kept[IntArray | PaintError] = Kept()

    def surface(self, face: Face) -> PaintSurface:
        """The skin of a face to paint on; its distances take a second the first time they are asked for."""
        return self._surface.get((face.skin,), lambda: PaintSurface(face.skin))

    def partners(self, face: Face) -> IntArray:
        """The vertex (N,) across the midline of every vertex, or -1.

        Raises
        ------
        PaintError
            If the face is not symmetric.
        """
        found = self._partners.get((face.skin, face.mirror), lambda: _partners(face))
        if isinstance(found, PaintError):
            raise found
        return found

    def mirrored(self, face: Face, point: SurfacePoint) -> SurfacePoint:
        """The place on the skin across the midline."""
        surface = self.surface(face)
        (other,) = surface.path.nearest(mirrored_place(face, point.position(face.skin)))
        return other


def _partners(face: Face) -> IntArray | PaintError:
    try:
        return mirror_partners(face)
    except PaintError as error:
        return error
