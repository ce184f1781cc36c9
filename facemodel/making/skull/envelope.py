"""The head without its soft ornaments: what the skin would be with no ears, lips, nose wings or lids.

Bone is measured down from this smooth surface, since the depth tables speak of the face as a whole and a lip or
an ear has no bone of its own shape beneath it.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.sparse import csc_array, diags_array, eye_array, vstack
from scipy.sparse.linalg import splu

from facemodel.face import Eye
from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray

MEASURED_HEIGHT = 115.5
"""Millimetres from nasion to menton on the base shape."""

ROUNDING = 11.0
"""Millimetres: wrinkles narrower than this are taken out of the skin; the shape of the face stays."""

STRICT = 60.0
"""The same along the bridge of the nose, whose thin bones are as narrow as a wrinkle."""

TAUT = 0.25
SLACK = 0.05
"""Weight of short edges against fairness under ears and nose, which are to be spanned, and under lips and lids,
which are to keep the swing of what surrounds them."""

PROUD = 1.5
"""Millimetres: skin beside an ear that stands this far out of the fair surface belongs to the ear."""


def _ellipse(points: FloatArray, centre: FloatArray, half: tuple[float, float]) -> BoolArray:
    return np.asarray((((points - centre) / half) ** 2).sum(axis=1) < 1)


def face_size(skin: Mesh, landmarks: Mapping[str, int]) -> float:
    """How large the face is against the one on which the figures of this package were measured."""
    span = skin.positions[landmarks["nasion"]] - skin.positions[landmarks["menton"]]
    return float(np.linalg.norm(span) / MEASURED_HEIGHT)


def ornaments(skin: Mesh, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]) -> FloatArray:
    """Tension (N,) under ears, lips, lids and the cartilaginous nose; zero on skin that is no ornament."""
    p = skin.positions
    at = {name: p[vertex] for name, vertex in landmarks.items()}
    size = face_size(skin, landmarks)
    front = p[:, 2] > at["eye_outer_L"][2] - 25 * size
    tension = np.zeros(len(p))
    for eye in eyes:
        tension[_ellipse(p[:, :2], eye.centre[:2], (19 * size, 11 * size)) & front] = SLACK
    mouth = (at["upper_vermilion"] + at["lower_vermilion"])[:2] / 2
    tall = float(np.linalg.norm(at["subnasale"] - at["chin_lip_fold"])) / 2
    tension[_ellipse(p[:, :2], mouth, (1.3 * at["mouth_corner_L"][0], tall)) & front] = SLACK
    low, high = at["subnasale"][1], at["rhinion"][1] - 3 * size
    nose = (p[:, 1] > low) & (p[:, 1] < high) & (np.abs(p[:, 0]) < 1.35 * at["ala_L"][0])
    tension[nose & front] = TAUT
    for side, sign in (("L", 1), ("R", -1)):
        ear = at[f"tragus_{side}"][1:] + size * np.array([1.0, -13.0])
        tension[_ellipse(p[:, 1:], ear, (38 * size, 27 * size)) & (sign * p[:, 0] > 40 * size)] = TAUT
    return tension


def closed(mesh: Mesh) -> Mesh:
    """The mesh with every boundary loop closed by a fan about its centre; the centres come last."""
    positions, triangles = [mesh.positions], [mesh.triangles]
    for k, loop in enumerate(mesh.boundary_loops):
        centre = np.full(len(loop), len(mesh.positions) + k)
        positions.append(mesh.positions[loop].mean(axis=0, keepdims=True))
        triangles.append(np.stack([np.roll(loop, -1), loop, centre], axis=1))
    return Mesh(np.concatenate(positions), np.concatenate(triangles))


def _fair(whole: Mesh, tension: FloatArray, bridge: BoolArray) -> FloatArray:
    """Positions that minimise ``|L x|^2 + (w |x - skin|)^2 + (tension |edge|)^2``, with w zero on ornaments.

    ``L`` is the graph Laplacian, since the folded triangles of an ear would spoil one that knows lengths; the mean
    edge length enters through w instead.
    """
    n = len(whole.positions)
    degree = np.asarray(whole.adjacency.sum(axis=1)).ravel()
    laplacian = csc_array(eye_array(n) - diags_array(1 / degree) @ whole.adjacency)
    i, j = whole.edges.T
    length = np.linalg.norm(whole.positions[i] - whole.positions[j], axis=1)
    spacing = np.bincount(whole.edges.ravel(), np.repeat(length, 2), n) / degree
    hold = np.where(tension > 0, 0.0, (spacing / ROUNDING) ** 2 * np.where(bridge, STRICT, 1.0))
    weight = np.minimum(tension[i], tension[j])
    rows = np.tile(np.arange(len(i)), 2)
    pull = csc_array((np.concatenate([weight, -weight]), (rows, np.concatenate([i, j]))), (len(i), n))
    matrix = vstack([laplacian, diags_array(hold), pull], format="csc")
    target = np.concatenate([np.zeros((n, 3)), hold[:, None] * whole.positions, np.zeros((len(i), 3))])
    return np.asarray(splu((matrix.T @ matrix).tocsc()).solve(matrix.T @ target))


def envelope(skin: Mesh, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]) -> Mesh:
    """The fair surface under the ornaments, closed at mouth, eyes and neck.

    Returns
    -------
    The first N vertices are the skin's; the centres of the closed loops follow.
    """
    whole = closed(skin)
    extra = len(whole.positions) - len(skin.positions)
    tension = np.concatenate([ornaments(skin, landmarks, eyes), np.full(extra, SLACK)])
    size = face_size(skin, landmarks)
    dorsum = skin.positions[landmarks["rhinion"]], skin.positions[landmarks["nasion"]]
    bridge = np.min([np.linalg.norm(whole.positions - p, axis=1) for p in dorsum], axis=0) < 14 * size
    ears = skin.positions[[landmarks["tragus_L"], landmarks["tragus_R"]]] - [0.0, 0.0, 13 * size]
    beside = np.linalg.norm(whole.positions[:, None] - ears, axis=2).min(axis=1) < 60 * size
    while True:
        surface = whole.moved(_fair(whole, tension, bridge))
        out = ((whole.positions - surface.positions) * surface.normals).sum(axis=1)
        grown = (whole.adjacency @ tension > 0) & (tension == 0) & beside & (out > PROUD)
        if not grown.any():
            return surface
        tension[grown] = TAUT


def inward(surface: Mesh) -> FloatArray:
    """Unit vectors (N, 3) into the head: the normals smoothed over a few rings so that neighbours agree."""
    average = surface.adjacency + eye_array(len(surface.positions))
    direction = -surface.normals
    for _ in range(4):
        direction = average @ direction
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    return direction
