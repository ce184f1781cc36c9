"""The hinge of the jaw: placed by its two ends."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from facemodel.errors import SkullError
from facemodel.project import Project
from fem.types import FloatArray

NARROWEST = 20.0
"""Millimetres between the condyles; those of a newborn are 60 apart."""


def with_jaw_axis(project: Project, right: FloatArray, left: FloatArray) -> Project:
    """A project whose jaw turns about the line through two points (3,), the subject's right condyle and the left one.

    Raises
    ------
    SkullError
        If they are no points, too near to each other, or on each other's side.
    """
    axis = np.array([right, left], dtype=np.float64)
    if not np.isfinite(axis).all():
        raise SkullError("An end of the jaw’s axis is nowhere; place both ends anew.")
    if axis[1, 0] - axis[0, 0] < NARROWEST:
        raise SkullError(
            f"The ends of the jaw’s axis are {axis[1, 0] - axis[0, 0]:.0f} mm apart from right to left; "
            f"place them at least {NARROWEST:g} mm apart, the subject’s right one first."
        )
    skull = project.face.skull
    hinged = replace(skull, jaw=replace(skull.jaw, axis=axis))
    return replace(project, face=replace(project.face, skull=hinged))
