"""Writes MPEG-4 face animation parameters: how far the feature points of a face really move, in its own units."""

from __future__ import annotations

import re

import numpy as np

from facemodel.animation.evaluation import Sampled
from facemodel.animation.feature_points import face_units, point_motions
from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.io.weights.fap import FAPS
from fem.types import FloatArray

ANGLE = 1e-5
"""Radians in one unit of a turn."""

TURNED = {
    "yaw_l_eyeball": ("eyeL.yaw", 1.0),
    "yaw_r_eyeball": ("eyeR.yaw", 1.0),
    "pitch_l_eyeball": ("eyeL.pitch", -1.0),
    "pitch_r_eyeball": ("eyeR.pitch", -1.0),
    "head_pitch": ("head.pitch", -1.0),
    "head_yaw": ("head.yaw", 1.0),
    "head_roll": ("head.roll", -1.0),
}
"""Which rigid motion a turn is, and its sign: pitch is down there, and roll to the right."""


def fap_text(clip: Sampled, face: Face, basis: Basis, name: str) -> str:
    """A file of version 2.1; parameters that never move are not given.

    Parameters
    ----------
    clip : frame by frame
    face, basis : what is animated
    name : of the clip; blanks would end it
    """
    values = fap_values(clip, face, basis)
    given = [label for label, _ in FAPS if label in values and np.any(values[label])]
    mask = " ".join("1" if label in given else "0" for label, _ in FAPS)
    one_word = re.sub(r"\s+", "_", name) or "clip"
    lines = [f"2.1 {one_word} {clip.rate:g} {len(clip.times)}"]
    for frame in range(len(clip.times)):
        lines += [mask, " ".join([str(frame), *(str(int(values[label][frame])) for label in given)])]
    return "\n".join([*lines, ""])


def fap_values(clip: Sampled, face: Face, basis: Basis) -> dict[str, FloatArray]:
    """Every parameter (T,) that this face can tell, whole numbers in its unit."""
    column = {name: k for k, name in enumerate(clip.channels)}
    fields = [name for name in clip.channels if name in basis.index]
    weights = clip.values[:, [column[name] for name in fields]]
    motions, units = point_motions(face, basis, fields), face_units(face)
    found: dict[str, FloatArray] = {}
    for label, unit in FAPS:
        if label in TURNED and TURNED[label][0] in column:
            channel, sign = TURNED[label]
            found[label] = np.rint(sign * np.radians(clip.values[:, column[channel]]) / ANGLE)
        elif label in motions and unit in units:
            found[label] = np.rint(weights @ motions[label] / units[unit])
    return found
