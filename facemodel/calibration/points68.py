"""The 68-point scheme on our heads: which of our landmarks its points are."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from fem.types import FloatArray, IntArray

EXACT: Mapping[str, tuple[int, ...]] = {
    "nasion": (27,),
    "nose_tip": (30,),
    "subnasale": (33,),
    "upper_vermilion": (51,),
    "lower_vermilion": (57,),
    "upper_lip_mid": (62,),
    "lower_lip_mid": (66,),
    "eye_outer_R": (36,),
    "eye_inner_R": (39,),
    "eye_inner_L": (42,),
    "eye_outer_L": (45,),
    "upper_lid_mid_R": (37, 38),
    "lower_lid_mid_R": (40, 41),
    "upper_lid_mid_L": (43, 44),
    "lower_lid_mid_L": (46, 47),
    "mouth_corner_R": (48,),
    "mouth_corner_L": (54,),
    "cupid_bow_R": (50,),
    "cupid_bow_L": (52,),
    "brow_mid_R": (19,),
    "brow_inner_R": (21,),
    "brow_inner_L": (22,),
    "brow_mid_L": (24,),
}
"""Points whose mean is a landmark of ours."""

ROUGH: Mapping[str, tuple[int, ...]] = {
    "menton": (8,),
    "brow_outer_R": (17,),
    "brow_outer_L": (26,),
    "supraglenoid_R": (0,),
    "supraglenoid_L": (16,),
}
"""Points that lie within a centimetre of a landmark of ours; the shape of the face tells where it is itself."""

SCATTER = 6.0
"""Millimetres by which rough points may be off."""

EYES_APART = (55.0, 130.0)
"""Millimetres between the outer corners of the eyes of a person, newborn to giant."""


def places68(mesh: Mesh, landmarks: IntArray) -> dict[str, FloatArray]:
    """Places (3,) by the names of our landmarks on a face with 68 points."""
    return {name: mesh.positions[landmarks[list(points)]].mean(axis=0) for name, points in {**EXACT, **ROUGH}.items()}


def check_unit(places: Mapping[str, FloatArray]) -> None:
    """Refuse a face that is not in millimetres.

    Raises
    ------
    FaceError
        If the eyes are farther apart, or nearer, than those of any person.
    """
    apart = float(np.linalg.norm(places["eye_outer_L"] - places["eye_outer_R"]))
    if not EYES_APART[0] < apart < EYES_APART[1]:
        raise FaceError(
            f"The outer corners of the measured eyes are {apart:.3g} apart, a person's {EYES_APART[0]:.0f} to "
            f"{EYES_APART[1]:.0f} mm; give the face in millimetres, and its 68 landmarks in their order."
        )
