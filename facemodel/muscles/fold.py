"""A fold of the skin: where muscles insert along a line they draw it in, and the flesh beside it stands up."""

from __future__ import annotations

import numpy as np

from facemodel.mesh import Mesh
from facemodel.muscles.curve import Curves, Feet, curves, feet, paths
from facemodel.muscles.fibre import lateral
from facemodel.muscles.muscle import Muscle
from fem.types import FloatArray

BESIDE = 3.0
"""Widths of the crease over which the flesh beside it stands up: the fat of a cheek is broader than its edge."""

FADED = 0.25
"""Share of its length over which a fold fades at each end."""

MIDDLE, DOWNWARD = 5.0, 0.1
"""Millimetres from the middle of the face within which a line has no outer side, and how little it counts beside that
which side is the lower one."""

LEAST = 1e-12
"""Square millimetres of skin beside a fold, where there is none."""


def fold_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Force per area (N, 3) on the skin, N/mm^2, of muscles that insert along a line on it.

    The levators of the lip and the zygomatic muscles end in the skin along the nasolabial line: when they contract the
    skin is held there, and the fat of the cheek, which keeps its volume, is pushed up over the crease.  A membrane that
    is pulled at one end knows nothing of that.  Here the skin is drawn in within the width of the line, with the
    lateral profile of eq. 8 of Koch, Gross and Bosshard 1998, and pushed out over a broader band beside it; both fade
    towards the ends of the line, act along the skin's normal and together press on nothing: what one takes, the other
    gives.

    The flesh stands on the side that is farther from the middle of the face, which is the cheek's side of a nasolabial
    line, and below a line across the middle.
    """
    points = paths(muscle.fibres, muscle.count)
    lines = curves(points, skin.normals[skin.tree.query(points[:, -1])[1]]).whole
    amount = np.zeros(len(skin.positions))
    if len(lines.length):
        at = feet(lines, skin.positions, (BESIDE + 1) * muscle.width)
        drawn, standing = (
            np.bincount(at.place, weight, len(amount)) / len(lines.length) for weight in _weights(muscle, lines, at)
        )
        areas = skin.vertex_areas
        amount = standing * (areas @ drawn) / max(float(areas @ standing), LEAST) - drawn
    return np.asarray(muscle.strength * amount[:, None] * skin.normals)


def _hand(lines: Curves) -> float:
    """On which hand of one who goes along lines the flesh stands, 1 or -1."""
    aside = np.cross(lines.pull, lines.across)
    outward = np.clip(lines.points[..., 0] / MIDDLE, -1.0, 1.0) * aside[..., 0]
    return 1.0 if float((outward - DOWNWARD * aside[..., 1]).mean()) >= 0 else -1.0


def _weights(muscle: Muscle, lines: Curves, at: Feet) -> tuple[FloatArray, FloatArray]:
    """How much (P,) each line draws a place in, and how much it lets it stand up."""
    beside = _hand(lines) * np.einsum("pc,pc->p", at.offset, np.cross(at.pull, at.across)) / muscle.width
    share = at.rho / lines.length[at.curve]
    ends = lateral(np.maximum(np.maximum(FADED - share, share - 1 + FADED), 0.0) / FADED)
    standing = np.where((beside > 0) & (beside < BESIDE), np.sin(np.pi * beside / BESIDE) ** 2, 0.0)
    return ends * lateral(np.abs(beside)), ends * standing
