"""The bone in hand: vertices of the skull that are selected, and how a hand selects them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from psygnal import Signal

from app.tools.pointer import Modifier
from facemodel.face import Face, Skull
from facemodel.sameness import same
from facemodel.skull.jaw_region import mirrored, whole_skull
from fem.types import BoolArray, IntArray


@dataclass(frozen=True)
class BoneHand:
    """How bone is selected.

    Attributes
    ----------
    through : a lasso takes the bone that is hidden behind other bone, too
    lower : a click takes of a connected part only what lies no higher
    """

    through: bool = True
    lower: bool = False


class Bones:
    """Selected vertices of one skull, numbered as by `facemodel.skull.jaw_region.whole_skull`; another has none.

    A skull that was only moved is the same one.
    """

    changed = Signal()
    """Other vertices are selected, or the hand selects otherwise."""

    def __init__(self) -> None:
        self._own: tuple[IntArray, IntArray] | None = None
        self._selected: BoolArray | None = None
        self._hand = BoneHand()

    @property
    def hand(self) -> BoneHand:
        """How bone is selected."""
        return self._hand

    def change(self, **members: Any) -> None:
        """Select otherwise from now on."""
        before, self._hand = self._hand, replace(self._hand, **members)
        if self._hand != before:
            self.changed.emit()

    def selected(self, skull: Skull) -> BoolArray | None:
        """Selected vertices (M,); none if nothing is."""
        own = self._own
        known = own is not None and own[0] is skull.cranium.triangles and own[1] is skull.mandible.triangles
        return self._selected if known else None

    def select(self, skull: Skull, vertices: BoolArray | None) -> None:
        """Select these vertices (M,) and no others."""
        before = self.selected(skull)
        self._own = skull.cranium.triangles, skull.mandible.triangles
        self._selected = None if vertices is None or not vertices.any() else vertices.copy()
        if not same(before, self._selected):
            self.changed.emit()


def taken(face: Face, before: BoolArray | None, region: BoolArray, held: Iterable[Modifier], mirror: bool) -> BoolArray:
    """What is selected after a hand took a region (M,): that alone, with Shift more, with Ctrl less of what was before.

    Parameters
    ----------
    mirror : the other side of the face alike
    """
    if mirror:
        region = mirrored(whole_skull(face.skull), face, region)
    if "control" in held:
        return np.zeros_like(region) if before is None else before & ~region
    return region if before is None or "shift" not in held else before | region
