"""How deep the bone lies under the face: tables of soft-tissue depth, spread smoothly over the skin."""

from __future__ import annotations

from collections.abc import Mapping

import igl
import numpy as np
from scipy.interpolate import RBFInterpolator

from facemodel.face import Eye
from facemodel.making.skull.envelope import envelope, face_size, inward
from facemodel.mesh import Mesh
from facemodel.skull.tissue_depths import table
from fem.types import FloatArray, IntArray

SCALP = 5.5
EAR = 9.0
LID = 5.0
NOSE = 5.0
SUBMENTAL = 16.0
NECK = 25.0
"""Millimetres where the tables are silent: scalp, under ear, lids and nostrils (below the fair surface), floor of
the mouth, and the neck, whose column stands in for bone."""

SCALP_RAYS: list[tuple[float, float, float]] = [(0, 1, 0), (0, 1, 1), (0, 1, -1), (0, 0.1, -1), (0, 0.6, 1)]
SCALP_RAYS += [(x, y, z) for x in (-1, 1) for y, z in ((0.7, 0), (1, 1), (0.2, -1), (0.8, -0.6))]
"""Directions from the middle of the head in which the scalp's depth is set."""


BETWEEN: Mapping[tuple[str, str], float] = {
    ("brow_outer", "supraglenoid"): 14.0,
    ("zygion", "lateral_orbit"): 7.5,
    ("lower_second_molar", "mouth_corner"): 18.0,
    ("lower_second_molar", "chin_lip_fold"): 12.5,
    ("gonion", "menton"): 11.0,
    ("upper_second_molar", "nasolabial"): 19.0,
}
"""Millimetres half-way between two landmarks: temple, zygomatic arch, cheek before the lower molars, body of the
mandible, its lower border, cheek before the upper molars."""


def _extra_sites(
    surface: Mesh, skin: Mesh, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]
) -> tuple[FloatArray, FloatArray]:
    """Places (n, 3) on the fair surface where no table speaks, and their depths (n,)."""
    size = face_size(skin, landmarks)
    at = {name: surface.positions[vertex] for name, vertex in landmarks.items()}
    middle = (at["tragus_L"] + at["tragus_R"]) / 2 + [0.0, 55 * size, 0.0]
    out = surface.positions - middle
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    scalp = [int((out @ (ray / np.linalg.norm(ray))).argmax()) for ray in np.array(SCALP_RAYS)]
    sites = [(surface.positions[v], SCALP) for v in scalp]
    for side in "LR":
        for (one, other), depth in BETWEEN.items():
            a, b = (at[name if name in at else f"{name}_{side}"] for name in (one, other))
            sites.append(((a + b) / 2, depth))
        sites += [(at[f"tragus_{side}"] - [0.0, 0.0, 12 * size], EAR), (at[f"ala_{side}"], NOSE)]
    sites += [(eye.centre + np.array([0.0, 0.0, eye.radius]), LID) for eye in eyes]
    sites.append((at["menton"] - [0.0, 0.0, 38 * size], SUBMENTAL))
    low = surface.positions[skin.boundary_loops[-1]]
    sites += [(point, NECK) for point in low]
    nape = low[low[:, 2] < at["tragus_L"][2]]
    sites += [(point + np.array([0.0, 35 * size, 0.0]), NECK) for point in nape]
    places = np.array([site for site, _ in sites])
    nearest = np.linalg.norm(surface.positions[None] - places[:, None], axis=2).argmin(axis=1)
    vertices, first = np.unique(nearest, return_index=True)
    return surface.positions[vertices], np.array([depth for _, depth in sites])[first]


class BoneEnvelope:
    """The fair surface and, under it, the smooth surface on which all bone ends.

    Attributes
    ----------
    skin : the whole skin
    outer : the fair surface, see `envelope`
    inner : the same triangles on the bone
    anchors : (N, 3) for each skin vertex the place below it on ``inner``
    """

    outer: Mesh
    inner: Mesh
    skin: Mesh
    anchors: FloatArray

    def __init__(self, skin: Mesh, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]) -> None:
        self.skin = skin
        self.outer = envelope(skin, landmarks, eyes)
        direction = inward(self.outer)
        places, depths = _extra_sites(self.outer, skin, landmarks, eyes)
        wanted = table()
        vertices = np.array([landmarks[name] for name in wanted])
        target = np.array(list(wanted.values()))
        sites = np.concatenate([self.outer.positions[vertices], places])
        values = np.concatenate([target, depths])
        for _ in range(ROUNDS):
            spread = RBFInterpolator(sites, np.log(values + LIFT), kernel="thin_plate_spline", degree=1)
            depth = np.minimum(np.exp(spread(self.outer.positions)) - LIFT, NECK)
            self.inner = self.outer.moved(self.outer.positions + depth[:, None] * direction)
            measured = np.linalg.norm(self.below(skin.positions[vertices]) - skin.positions[vertices], axis=1)
            values[: len(vertices)] = np.maximum(values[: len(vertices)] + target - measured, 1 - LIFT)
        self.anchors = self._anchors(skin, vertices, target)

    def below(self, points: FloatArray) -> FloatArray:
        """The nearest places (n, 3) on the inner surface."""
        _, _, closest = igl.point_mesh_squared_distance(points, self.inner.positions, self.inner.triangles)
        return np.asarray(closest)

    def _anchors(self, skin: Mesh, vertices: IntArray, target: FloatArray) -> FloatArray:
        down = self.below(skin.positions) - skin.positions
        degree = np.asarray(skin.adjacency.sum(axis=1))[:, None]
        for _ in range(SMOOTHINGS):
            down = (down + skin.adjacency @ down / degree) / 2
        missed = np.log(target / np.linalg.norm(down[vertices], axis=1))
        mend = RBFInterpolator(self.outer.positions[vertices], missed, kernel="gaussian", epsilon=1 / 15.0)
        length = np.exp(np.asarray(mend(self.outer.positions[: len(down)])))
        return np.asarray(skin.positions + length[:, None] * down)


LIFT = 6.0
"""Millimetres: the logarithm of the depth and this is spread, which keeps the bone from standing out of the face;
under a proud lip it may rise a little above the fair surface."""

ROUNDS = 5
"""Corrections of the depths so that the bone, not the offset, keeps the table's distance from the skin."""

SMOOTHINGS = 8
"""Averaging rounds of the springs' directions over neighbours."""
