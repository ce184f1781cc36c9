"""How wide a mouth is open, and whether its skin has folded over."""

from __future__ import annotations

import numpy as np

from facemodel.face import Face
from facemodel.jaw import opening
from facemodel.superposition import Superposition

AGAINST = -0.2
"""Cosine between a drawn triangle and the normals of the smooth surface in its corners below which it is folded over:
across the edge of a lip the two differ by nearly a right angle."""

LEAST_AREA = 1e-3
"""Square millimetres of a triangle that can be seen."""


def incisors_apart(face: Face, posed: Superposition) -> float:
    """Millimetres between the edges of the upper and the lower incisors of a posed face."""
    return opening.incisors_apart(face, lambda row: posed.parts[row.name])


def folded(posed: Superposition) -> int:
    """How many drawn triangles show their back where the smooth surface shows its front."""
    triangles = posed.basis.display.triangles
    a, b, c = (posed.points[triangles[:, k]].astype(np.float64) for k in range(3))
    normal = np.cross(b - a, c - a)
    twice = np.linalg.norm(normal, axis=1)
    smooth = posed.normals[triangles].astype(np.float64).mean(axis=1)
    smooth /= np.linalg.norm(smooth, axis=1)[:, None] + 1e-12
    cosine = np.einsum("ij,ij->i", normal, smooth) / (twice + 1e-12)
    return int(((cosine < AGAINST) & (twice > 2 * LEAST_AREA)).sum())
