"""Which part of the skin hangs on the mandible."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
from scipy.sparse import csc_array, diags_array
from scipy.sparse.linalg import splu

from facemodel.making.skull.envelope import face_size
from facemodel.mesh import Mesh
from facemodel.smooth import smooth_step
from fem.types import FloatArray, IntArray

BAND = 22.0
"""Millimetres over which the cheek passes from the cranium to the mandible."""

LOBE, DROP, SLOPE = 8.0, 25.0, 0.7
"""The hind border of the ramus runs this far before the tragus (millimetres) down to the lobe of the ear, this far
below it, and from there backwards to the neck at this slope."""

FREE_CORNER = 0.7
"""Beyond this share of the mouth's half width the lips pass gradually from one jaw to the other."""

NEAR_BORDER, FADE = 10.0, 34.0
"""Below the lower border the skin follows the jaw this far, and lets go of it over this length (millimetres)."""


def lips(skin: Mesh, landmarks: Mapping[str, int]) -> tuple[IntArray, IntArray]:
    """The mouth loop's vertices of the upper and of the lower lip, without the corners."""
    ends = [landmarks["mouth_corner_L"], landmarks["mouth_corner_R"]]
    loop = next(loop for loop in skin.boundary_loops if np.isin(ends, loop).all())
    first, second = sorted(int(np.flatnonzero(loop == end)[0]) for end in ends)
    one, other = loop[first + 1 : second], np.concatenate([loop[second + 1 :], loop[:first]])
    return (one, other) if landmarks["upper_lip_mid"] in one else (other, one)


def _neck_hold(skin: Mesh, border: FloatArray) -> FloatArray:
    """1 where skin is at the mandible, falling to 0 down the neck; ``border`` (n, 3) runs gonion, menton, gonion."""
    p = skin.positions
    gap = np.full(len(p), np.inf)
    for a, b in pairwise(border):
        t = np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        gap = np.minimum(gap, np.linalg.norm(p - a - t[:, None] * (b - a), axis=1))
    up = np.cross(border[-1] - border[0], border[len(border) // 2] - border[0])
    above = (p - border[0]) @ (up / np.linalg.norm(up) * -np.sign(up[1]))
    gap *= smooth_step(above / 12.0 + 1.0)
    return 1 - smooth_step((gap - NEAR_BORDER) / FADE)


def jaw_share(skin: Mesh, landmarks: Mapping[str, int]) -> FloatArray:
    """Share (N,) of the mandible in what each skin vertex hangs on: 1 on chin and lower lip, 0 on the midface.

    The share is harmonic on the graph of the skin across the band of the cheek between the two, so that it jumps
    at the slit of the mouth and nowhere else, and its ends are levelled.
    """
    p = skin.positions
    ears = p[[landmarks["tragus_L"], landmarks["tragus_R"]]]
    corners = p[[landmarks["mouth_corner_L"], landmarks["mouth_corner_R"]]]
    ear = ears.mean(axis=0)
    normal = np.cross(ears[0] - ears[1], corners.mean(axis=0) - ear)
    below = (p - ear) @ normal / np.linalg.norm(normal)
    size = face_size(skin, landmarks)
    under = np.maximum(ear[1] - p[:, 1] - DROP * size, 0)
    hind = p[:, 2] - ear[2] - LOBE * size + SLOPE * under
    territory = np.minimum(below, hind)
    fixed = np.abs(territory) > BAND / 2
    value = (territory > 0).astype(np.float64)
    corner_x = abs(skin.positions[landmarks["mouth_corner_L"], 0])
    for lip, share in zip(lips(skin, landmarks), (0.0, 1.0), strict=True):
        held = lip[np.abs(skin.positions[lip, 0]) < FREE_CORNER * corner_x]
        fixed[held], value[held] = True, share
    free = ~fixed
    degree = np.asarray(skin.adjacency.sum(axis=1)).ravel()
    laplacian = csc_array(diags_array(degree) - skin.adjacency)
    value[free] = splu(laplacian[free][:, free].tocsc()).solve(-laplacian[free][:, fixed] @ value[fixed])
    at = skin.positions[[landmarks[n] for n in ("gonion_L", "menton", "gonion_R")]]
    return smooth_step(value) * _neck_hold(skin, at)
