"""What is wrong between skull and skin: bone that comes through, and springs that are left out of the tissue."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.face import Face
from facemodel.skull.depths import Depths, bone_depths, complaint, worst_places
from facemodel.skull.spring_checks import SpringFaults, spring_faults
from facemodel.skull.tissue_depths import LandmarkDepth, landmark_depths
from facemodel.system import solved_vertices
from fem.types import IntArray


@dataclass(frozen=True, eq=False)
class Findings:
    """What is known of the bone under one skin.

    Attributes
    ----------
    face : which
    depths : how deep bone lies everywhere
    landmarks : how deep it lies where tables say how deep it should
    pierced : (k,) skin vertices that bone comes through, the worst first
    complaint : where bone comes through the skin, in a sentence; empty where it does not
    faults : springs that are not solved
    """

    face: Face
    depths: Depths
    landmarks: tuple[LandmarkDepth, ...]
    pierced: IntArray
    complaint: str
    faults: SpringFaults

    @property
    def no_length(self) -> IntArray:
        """Skin vertices (k,) that lie on the foot of a spring."""
        return np.unique(self.faults.vertices[self.faults.no_length])

    @property
    def through_bone(self) -> IntArray:
        """Skin vertices (k,) of which a spring starts in bone or goes through it."""
        return np.unique(self.faults.vertices[self.faults.through])

    @property
    def sound(self) -> bool:
        """Whether nothing is wrong."""
        return not len(self.pierced) and not self.faults.left_out.any()


def findings(face: Face) -> Findings:
    """Look at the skull of a face from all sides."""
    depths = bone_depths(face)
    return Findings(
        face,
        depths,
        landmark_depths(face),
        worst_places(face, depths),
        complaint(face),
        spring_faults(face, solved_vertices(face)),
    )
