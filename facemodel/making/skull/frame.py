"""How the head on which the skull was modelled is fitted to another."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.interpolate import RBFInterpolator

from facemodel.face import Eye
from facemodel.making.landmarks import MIDLINE
from facemodel.making.skull.depth import BoneEnvelope
from fem.types import FloatArray

BONE: Mapping[str, tuple[float, float, float]] = {
    "supraglabella": (0.0, 770.9, 147.0),
    "glabella": (0.0, 752.2, 148.5),
    "nasion": (0.0, 732.2, 143.6),
    "rhinion": (0.0, 710.3, 155.8),
    "subnasale": (0.0, 674.9, 146.8),
    "mid_philtrum": (0.0, 671.4, 147.1),
    "upper_lip_incisor": (0.0, 667.6, 148.2),
    "lower_lip_incisor": (0.0, 660.4, 145.6),
    "chin_lip_fold": (0.0, 646.0, 139.5),
    "pogonion": (0.0, 635.5, 137.2),
    "menton": (0.0, 624.0, 134.1),
    "frontal_eminence": (37.1, 784.5, 128.6),
    "supraorbital": (29.2, 746.8, 135.0),
    "suborbital": (29.2, 711.0, 136.0),
    "inferior_malar": (26.7, 698.5, 134.4),
    "lateral_orbit": (41.4, 709.1, 125.8),
    "zygion": (63.2, 708.6, 76.5),
    "supraglenoid": (64.9, 723.5, 70.1),
    "gonion": (46.5, 662.5, 76.8),
    "upper_second_molar": (34.4, 683.2, 101.5),
    "mid_masseter": (48.1, 682.6, 79.1),
    "lower_second_molar": (34.1, 657.8, 97.0),
    "tragus": (63.2, 708.5, 63.6),
}
"""Bone under landmarks of the measured head, the base shape: midline and left side, millimetres."""

EYE = (31.2, 730.1, 122.0)
CROWN = (0.0, 843.7, 68.5)
NAPE = (0.0, 762.6, -33.8)
"""Centre of the left eyeball, highest and hindmost bone of the measured head."""

LOOSENESS = 20.0
"""Smoothing of the thin-plate spline: a landmark may be missed by a millimetre, the map must not fold."""


class Frame:
    """A smooth map from the measured head to another: a thin-plate spline through the bone under the landmarks."""

    def __init__(self, bone: BoneEnvelope, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]) -> None:
        here, there = [], []
        for name, place in BONE.items():
            sides = (("", 1.0),) if name in MIDLINE else (("_L", 1.0), ("_R", -1.0))
            for suffix, sign in sides:
                here.append(bone.anchors[landmarks[name + suffix]])
                there.append((sign * place[0], *place[1:]))
        for eye in eyes:
            here.append(eye.centre)
            there.append((EYE[0] if eye.side == "L" else -EYE[0], *EYE[1:]))
        p = bone.inner.positions
        here += [p[p[:, 1].argmax()], p[p[:, 2].argmin()]]
        there += [CROWN, NAPE]
        self._map = RBFInterpolator(there, here, smoothing=LOOSENESS, kernel="thin_plate_spline", degree=1)

    def here(self, points: FloatArray) -> FloatArray:
        """Where points (n, 3) of the measured head lie in this one."""
        return np.asarray(self._map(points))
