"""The fields of a face that its places feel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.animation.landmarks.places import Places, told_units
from facemodel.basis import Basis
from fem.types import FloatArray

LEAST = 1.0
"""Millimetres that a field has to move some place at weight 1 to have a say."""

FULL = 1.0
"""No unit is captured beyond its full strength: what is more than it is another face, not another expression."""


@dataclass(frozen=True, eq=False)
class Felt:
    """The fields that move some place.

    Attributes
    ----------
    names : (M,)
    fields : (M, K, 3) at the places, at weight 1, millimetres
    peaks : (M,) largest motion anywhere, millimetres
    high : (M,) largest weights
    """

    names: tuple[str, ...]
    fields: FloatArray
    peaks: FloatArray
    high: FloatArray

    @classmethod
    def on(cls, places: Places, basis: Basis, units: Sequence[ActionUnit]) -> Felt:
        """Those of a basis that belong to units which the places tell apart."""
        told = [unit for unit in units if unit.number in told_units()]
        limits = {name: FULL for unit in told for name in unit.fields if name in basis.index}
        moved = {name: basis.field(name)[places.points].astype(np.float64) for name in limits}
        names = tuple(name for name, field in moved.items() if np.linalg.norm(field, axis=1).max() >= LEAST)
        fields = np.array([moved[name] for name in names]).reshape(len(names), len(places.points), 3)
        return cls(names, fields, np.array([basis.peak(name) for name in names]), np.array([limits[n] for n in names]))
