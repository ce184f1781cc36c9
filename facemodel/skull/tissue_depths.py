"""How deep bone lies under landmarks of the skin: what tables of adults say, and what it is on a face."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from facemodel.face import Face
from facemodel.skull.depths import bone_depths
from facemodel.skull.naming import spoken

MIDLINE: Mapping[str, float] = {
    "supraglabella": 4.5,
    "glabella": 4.5,
    "nasion": 7.0,
    "rhinion": 2.5,
    "mid_philtrum": 10.0,
    "upper_lip_incisor": 11.0,
    "lower_lip_incisor": 12.0,
    "chin_lip_fold": 10.0,
    "pogonion": 13.0,
    "menton": 8.0,
}
"""Skin to bone at landmarks of the midline of adults, millimetres: Rhine and Taylor."""

PAIRED: Mapping[str, float] = {
    "frontal_eminence": 4.0,
    "supraorbital": 8.5,
    "suborbital": 6.0,
    "inferior_malar": 12.0,
    "lateral_orbit": 11.0,
    "zygion": 7.0,
    "supraglenoid": 6.0,
    "gonion": 10.0,
    "upper_second_molar": 26.0,
    "mid_masseter": 17.5,
    "lower_second_molar": 19.5,
}
"""The same at those of both sides: Rhine and Taylor, but for the molars the later table, whose deeper cheeks leave the
tooth rows the width of a dental arch."""


def table() -> dict[str, float]:
    """Depth by landmark, both sides written out."""
    return {**MIDLINE, **{f"{name}_{side}": depth for name, depth in PAIRED.items() for side in "LR"}}


@dataclass(frozen=True)
class LandmarkDepth:
    """The depth of bone under one landmark.

    Attributes
    ----------
    name : of the landmark
    vertex : of the skin
    wanted : millimetres, what the tables say
    measured : millimetres to the nearest bone, below zero where the bone is outside
    """

    name: str
    vertex: int
    wanted: float
    measured: float

    @property
    def title(self) -> str:
        """What people call it."""
        return spoken(self.name)

    @property
    def off(self) -> float:
        """How much too deep the bone lies, millimetres; below zero where it is too near to the skin."""
        return self.measured - self.wanted


def landmark_depths(face: Face) -> tuple[LandmarkDepth, ...]:
    """What the tables say and what is, at all landmarks that the tables and the face share."""
    depth = bone_depths(face).depth
    return tuple(
        LandmarkDepth(name, face.landmarks[name], wanted, float(depth[face.landmarks[name]]))
        for name, wanted in table().items()
        if name in face.landmarks
    )
