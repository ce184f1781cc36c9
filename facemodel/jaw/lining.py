"""The floor of the mouth goes with the jaw it lies on.

What lies behind the skin is carried by the rim it hangs on.  That does for a smile; when the jaw turns, though, bone
near its hinge goes a shorter way than the lip before it, and a floor that went the lip's way would stand up over teeth
and tongue.  Near the rim the lining goes with the skin; deeper in, every place of it goes the bone's way at itself, as
far as it lies on the lower jaw.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import KDTree

from facemodel.face import Face, Part
from facemodel.jaw.modes import JawMode, mode_motion
from facemodel.openings import mouth_of, on_upper_side
from facemodel.smooth import smooth
from facemodel.sources import Recipe
from fem.types import Float32Array, FloatArray

CHEEK = (0.3, 0.7)
"""Share of a place's rim that is the lower lip's: below the first it lies on the upper jaw, above the other one on the
lower jaw, and between them in the cheek."""

RIM = (2.0, 9.0)
"""Millimetres behind the rim up to which a place goes with the skin, and from which on with the bone."""


@dataclass(frozen=True, eq=False)
class Lining:
    """How the lining of a mouth lies between skin and bone.

    Attributes
    ----------
    face, part : whose it is, and what it is
    first : number of its first point among those that the skin carries
    of_jaw : (P,) how far its places belong to the lower jaw
    of_skin : (P,) how far they go with the skin
    """

    face: Face
    part: Part
    first: int
    of_jaw: FloatArray
    of_skin: FloatArray

    @property
    def columns(self) -> slice:
        """Where its coordinates are in a row of a basis."""
        return slice(3 * self.first, 3 * (self.first + len(self.of_jaw)))

    def beyond_rim(self, mode: JawMode, moved: FloatArray) -> FloatArray:
        """How far (P, 3) a mode of the jaw takes it beyond what its rim gives it.

        Parameters
        ----------
        moved : (N, 3) how far the mode moves the vertices of the skin
        """
        bone = mode_motion(self.face.skull.jaw, mode, self.part.mesh.positions)
        carried = np.einsum("pk,pkc->pc", self.part.shares, moved[self.part.anchors])
        return np.asarray((1 - self.of_skin)[:, None] * (self.of_jaw[:, None] * bone - carried))


def lining_of(face: Face) -> Lining | None:
    """The lining of a face; none on one without it, or without the slit of a mouth."""
    mouth, first = mouth_of(face), 0
    for part in face.parts:
        if part.carrier != "skin":
            continue
        if part.kind == "lining" and mouth is not None:
            lower = ~on_upper_side(face.skin, mouth)
            below = np.einsum("pk,pk->p", part.shares, lower[part.anchors].astype(np.float64))
            rim = face.skin.positions[np.unique(part.anchors)]
            behind = KDTree(rim).query(part.mesh.positions)[0]
            return Lining(face, part, first, smooth(below, *CHEEK), smooth(behind, *reversed(RIM)))
        first += len(part.mesh.positions)
    return None


def carry_lining(
    fields: Float32Array, recipes: Sequence[Recipe], lining: Lining | None, moved: Callable[[JawMode], FloatArray]
) -> None:
    """Take the lining along with the bone in fields (M, 3 Q), each made after a recipe, in place.

    Parameters
    ----------
    moved : how far (N, 3) a mode of the jaw moves the vertices of the skin; asked for those alone that turn a field
    """
    if lining is None:
        return
    beyond = {mode: lining.beyond_rim(mode, moved(mode)).ravel() for mode in _modes(recipes)}
    for row, recipe in zip(fields, recipes, strict=True):
        for source, weight in recipe:
            if isinstance(source, JawMode):
                row[lining.columns] += (weight * beyond[source]).astype(np.float32)


def _modes(recipes: Iterable[Recipe]) -> set[JawMode]:
    return {source for recipe in recipes for source, _ in recipe if isinstance(source, JawMode)}
