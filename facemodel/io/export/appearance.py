"""How things look in formats that carry colours: one plain material for each kind."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from fem.types import FloatArray


@dataclass(frozen=True)
class Appearance:
    """A plain material.

    Attributes
    ----------
    colour : sRGB 0..1
    opacity : of all of it; 1 is opaque
    sheer : whether some of it lets light through
    roughness : 0 mirrors, 1 is dull
    two_sided : seen from behind too
    """

    colour: tuple[float, float, float]
    opacity: float = 1.0
    sheer: bool = False
    roughness: float = 0.5
    two_sided: bool = False


APPEARANCES: Mapping[str, Appearance] = {
    "skin": Appearance((0.835, 0.655, 0.560), roughness=0.55),
    "eye": Appearance((1.0, 1.0, 1.0), roughness=0.15),
    "cornea": Appearance((0.5, 0.5, 0.5), opacity=0.05, sheer=True, roughness=0.02),
    "teeth": Appearance((0.93, 0.90, 0.83), roughness=0.25),
    "tongue": Appearance((0.72, 0.38, 0.36), roughness=0.4),
    "lining": Appearance((0.55, 0.24, 0.23), roughness=0.45, two_sided=True),
    "socket": Appearance((0.60, 0.33, 0.30), roughness=0.6, two_sided=True),
    "lashes": Appearance((0.10, 0.07, 0.06), sheer=True, roughness=0.7, two_sided=True),
}
"""By kind: the skin, the two layers of an eye, and the kinds of `facemodel.face.Part`."""


def linear(srgb: FloatArray) -> FloatArray:
    """Linear light from sRGB values (IEC 61966-2-1), of any shape."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
