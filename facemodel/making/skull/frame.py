"""Where a place of one head would be in the head on which the skull was modelled."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.interpolate import RBFInterpolator

from facemodel.face import Eye
from facemodel.making.landmarks import MIDLINE, PAIRED
from facemodel.mesh import Mesh
from fem.types import FloatArray

BONY = (
    "supraglabella",
    "glabella",
    "nasion",
    "rhinion",
    "subnasale",
    "mid_philtrum",
    "chin_lip_fold",
    "pogonion",
    "menton",
    "frontal_eminence",
    "supraorbital",
    "suborbital",
    "inferior_malar",
    "lateral_orbit",
    "zygion",
    "supraglenoid",
    "gonion",
    "upper_second_molar",
    "mid_masseter",
    "lower_second_molar",
    "tragus",
)
"""Landmarks that follow the bone: lips, lids and the tip of the nose say little of the skull."""

EYE = (30.8, 728.4, 124.5)
"""Centre of the left eyeball in the base shape, millimetres."""

LOOSENESS = 10.0
"""Smoothing of the thin-plate spline: a landmark may be missed by a millimetre or two, the map must not fold."""

CORRECTIONS = 20
"""Fixed-point steps of the inverse; each leaves a fifth of the error or less, as heads are of like size."""


class Frame:
    """A smooth map from a head to the measured one: a thin-plate spline through landmarks and eyes.

    Parameters
    ----------
    skin, landmarks, eyes : the head, as in `facemodel.face.Face`
    """

    def __init__(self, skin: Mesh, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]) -> None:
        here, there = [], []
        for name in BONY:
            if name in MIDLINE:
                here.append(skin.positions[landmarks[name]])
                there.append(MIDLINE[name])
                continue
            for side, sign in (("L", 1.0), ("R", -1.0)):
                here.append(skin.positions[landmarks[f"{name}_{side}"]])
                there.append((sign * PAIRED[name][0], *PAIRED[name][1:]))
        for eye in eyes:
            here.append(eye.centre)
            there.append((EYE[0] if eye.side == "L" else -EYE[0], *EYE[1:]))
        self._to = RBFInterpolator(here, there, smoothing=LOOSENESS, kernel="linear", degree=1)
        self._from = RBFInterpolator(there, here, smoothing=LOOSENESS, kernel="linear", degree=1)

    def measured(self, points: FloatArray) -> FloatArray:
        """Points (n, 3) of this head in the coordinates of the measured one."""
        return np.asarray(self._to(points))

    def here(self, points: FloatArray) -> FloatArray:
        """Points (n, 3) of the measured head in this one: the inverse of `measured`."""
        found = np.asarray(self._from(points))
        for _ in range(CORRECTIONS):
            found = found + points - self.measured(found)
        return found
