"""How the head on which the skull was modelled is fitted to another."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import igl
import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import RBFInterpolator

from facemodel.face import Eye
from facemodel.making.landmarks import MIDLINE
from facemodel.making.skull.depth import BoneEnvelope
from facemodel.making.skull.envelope import closed
from fem.types import FloatArray

BONE: Mapping[str, tuple[float, float, float]] = {
    "supraglabella": (0.0, 770.9, 147.0),
    "glabella": (0.0, 752.2, 148.5),
    "nasion": (0.0, 732.2, 143.6),
    "rhinion": (0.0, 710.3, 155.8),
    "chin_lip_fold": (0.0, 645.6, 139.4),
    "pogonion": (0.0, 635.3, 137.2),
    "menton": (0.0, 623.9, 134.0),
    "frontal_eminence": (37.1, 784.5, 128.6),
    "supraorbital": (29.2, 746.8, 135.0),
    "suborbital": (29.3, 711.0, 136.0),
    "inferior_malar": (26.9, 698.1, 134.0),
    "lateral_orbit": (41.6, 708.7, 125.5),
    "zygion": (63.2, 708.6, 76.6),
    "supraglenoid": (64.9, 723.5, 70.2),
    "gonion": (46.2, 662.1, 77.0),
    "upper_second_molar": (34.0, 683.9, 103.3),
    "mid_masseter": (48.0, 682.6, 79.4),
    "lower_second_molar": (33.1, 655.9, 97.9),
    "tragus": (62.9, 708.6, 63.7),
}
"""Bone under landmarks of the measured head, the base shape: midline and left side, millimetres."""

EYE = (31.2, 730.1, 122.0)
CROWN = (0.0, 843.7, 68.5)
NAPE = (0.0, 762.6, -33.8)
"""Centre of the left eyeball, highest and hindmost bone of the measured head."""

FIRM = ("pogonion", "menton", "gonion", "mid_masseter", "zygion", "inferior_malar")
"""Landmarks whose bone does not follow the teeth."""

SLIT = (0.0, 661.5, 145.5)
"""Bone behind the slit of the lips of the measured head, where the tooth rows meet."""

ARCHES = (
    (12.0, 671.0, 144.0),
    (20.6, 672.0, 135.4),
    (27.3, 674.5, 122.2),
    (30.4, 677.8, 108.2),
    (0.0, 652.2, 141.6),
    (9.2, 651.8, 139.5),
    (16.6, 652.7, 135.2),
    (23.1, 655.2, 124.7),
    (24.5, 656.9, 109.9),
    (9.8, 662.6, 143.7),
    (18.3, 663.9, 137.3),
)
"""Bone of the measured head along its dental arches, midline and left side."""

COVER = 4.5
"""Millimetres of lip over the teeth, also at the slit."""

LOOSENESS = 20.0
"""Smoothing of the thin-plate spline: a landmark may be missed by a millimetre, the map must not fold."""


def _spline(there: Sequence[ArrayLike], here: Sequence[ArrayLike]) -> RBFInterpolator:
    return RBFInterpolator(np.array(there), np.array(here), smoothing=LOOSENESS, kernel="thin_plate_spline", degree=1)


def _covered(bone: BoneEnvelope, points: FloatArray) -> FloatArray:
    """Points (n, 3) pushed into the head until the lips cover them."""
    skin = closed(bone.skin)
    kind = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    height, _, nearest, _ = igl.signed_distance(points, skin.positions, skin.triangles, kind)
    inward = (points - nearest) / -height[:, None]
    return np.asarray(points + np.maximum(height + COVER, 0)[:, None] * inward)


class Frame:
    """A smooth map from the measured head to another: a thin-plate spline through the bone under the landmarks.

    Along the dental arches, where the landmarks lie on soft lips, it is then drawn to the nearest bone.

    Attributes
    ----------
    bone : the surface on which the bone of the other head ends
    firm : (n, 3) bone of it under the landmarks that lie beside the rows of teeth and on no lip
    """

    def __init__(self, bone: BoneEnvelope, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]) -> None:
        self.bone = bone
        here, there, firm = [], [], []
        for name, place in BONE.items():
            sides = (("", 1.0),) if name in MIDLINE else (("_L", 1.0), ("_R", -1.0))
            for suffix, sign in sides:
                here.append(bone.anchors[landmarks[name + suffix]])
                there.append((sign * place[0], *place[1:]))
                if name in FIRM:
                    firm.append(here[-1])
        self.firm = np.array(firm)
        for eye in eyes:
            here.append(eye.centre)
            there.append((EYE[0] if eye.side == "L" else -EYE[0], *EYE[1:]))
        lips = bone.skin.positions[[landmarks["upper_lip_mid"], landmarks["lower_lip_mid"]]]
        here.append(_covered(bone, bone.below(lips.mean(axis=0, keepdims=True)))[0])
        there.append(SLIT)
        p = bone.inner.positions
        here += [p[p[:, 1].argmax()], p[p[:, 2].argmin()]]
        there += [CROWN, NAPE]
        self._map = _spline(there, here)
        arches = np.array([(sign * x, y, z) for x, y, z in ARCHES for sign in ((1, -1) if x else (1,))])
        self._map = _spline([*there, *arches], [*here, *_covered(bone, bone.below(self.here(arches)))])

    def here(self, points: FloatArray) -> FloatArray:
        """Where points (n, 3) of the measured head lie in this one."""
        return np.asarray(self._map(points))
