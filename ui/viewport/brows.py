"""Eyebrows: a few hundred strokes that grow along the brow ridge, as curves on the skin's chart."""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np
from scipy.interpolate import PchipInterpolator

from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.smooth import smooth
from fem.types import FloatArray

HAIRS = 560
"""Per brow; enough to read as hair from near and as a band from afar."""
STEPS = 8
"""Points of one stroke."""
HALF_WIDTH = np.array([0.0, 0.9, 3.1, 3.7, 3.2, 2.2, 1.2, 0.3])
ALONG = np.array([-0.02, 0.0, 0.10, 0.25, 0.50, 0.75, 0.92, 1.02])
"""Half of the brow's height in millimetres along its length: blunt at the nose, full, and thin at the tail."""
LEAN = np.array([[0.0, 78.0], [0.2, 52.0], [0.5, 30.0], [0.8, 14.0], [1.0, 6.0]])
"""Angle of a hair to the brow (degrees) along its length: upright at the nose, lying flat towards the temple."""
LENGTH = np.array([[0.0, 4.6], [0.25, 6.4], [0.6, 6.0], [1.0, 3.6]])
"""Length of a hair in millimetres along the brow."""


@dataclass(frozen=True, eq=False)
class Strokes:
    """Hairs as curves on the skin.

    Attributes
    ----------
    points : (H, K, 2) on the chart
    weight : (H,) how strong each is, 0..1
    """

    points: FloatArray
    weight: FloatArray


def on_chart(face: Face, places: FloatArray) -> FloatArray:
    """The chart points (n, 2) of the skin nearest to some places (n, 3)."""
    skin = face.skin
    _, element, nearest = igl.point_mesh_squared_distance(np.ascontiguousarray(places), skin.positions, skin.triangles)
    corners = skin.triangles[element]
    share = igl.barycentric_coordinates(
        np.ascontiguousarray(nearest),
        *(np.ascontiguousarray(skin.positions[corners[:, k]]) for k in range(3)),
    )
    return np.asarray(np.einsum("nk,nkc->nc", share, face.chart[corners]))


def ridge(face: Face, side: str) -> PchipInterpolator:
    """The middle line of a brow from the nose (0) to the temple (1), as a smooth curve in space."""
    at = {name: face.skin.positions[face.landmarks[f"brow_{name}_{side}"]] for name in ("inner", "mid", "outer")}
    head = at["inner"] + 0.18 * (at["inner"] - at["mid"]) + [0.0, 0.8, 0.0]
    bend = at["mid"] + [0.0, -1.2, 0.0]
    arch = 0.40 * at["mid"] + 0.60 * at["outer"] + [0.0, 2.0, 0.0]
    tail = at["outer"] + 0.22 * (at["outer"] - at["mid"]) + [0.0, -0.6, -1.0]
    knots = np.stack([head, at["inner"], bend, arch, tail])
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(knots, axis=0), axis=1))])
    return PchipInterpolator(length / length[-1], knots)


def strokes(face: Face, side: str) -> Strokes:
    """The hairs of one brow; both brows are mirror images as far as the face is."""
    random = np.random.default_rng(7)
    middle = ridge(face, side)
    s = np.sort(random.uniform(0.0, 1.0, HAIRS) ** 0.92)
    t = np.clip(random.normal(0.0, 0.52, HAIRS), -1.0, 1.0)
    lean = np.radians(np.interp(s, *LEAN.T)) + random.normal(0.0, 0.10, HAIRS)
    lean *= np.where(t > 0, 1.0 - 1.2 * t * smooth(s, 0.05, 0.75), 1.0 + 0.12 * t)
    length = np.interp(s, *LENGTH.T) * random.uniform(0.7, 1.1, HAIRS)
    curl = random.normal(-0.32, 0.12, HAIRS)

    root = middle(s)
    along = middle.derivative()(s)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    normal = _normals_at(face.skin, root)
    up = np.cross(normal, along) * (1.0 if side == "L" else -1.0)
    root = root + up * (t * np.interp(s, ALONG, HALF_WIDTH))[:, None]

    step = np.linspace(0.0, 1.0, STEPS)
    angle = lean[:, None] + curl[:, None] * step[None]
    heading = np.cos(angle)[..., None] * along[:, None] + np.sin(angle)[..., None] * up[:, None]
    path = np.cumsum(heading, axis=1) - heading[:, :1]
    places = root[:, None] + path * (length / STEPS)[:, None, None]
    weight = random.uniform(0.55, 1.0, HAIRS) * np.interp(s, [0.0, 0.12, 0.85, 1.0], [0.45, 1.0, 1.0, 0.7])
    return Strokes(on_chart(face, places.reshape(-1, 3)).reshape(HAIRS, STEPS, 2), weight)


def _normals_at(skin: Mesh, places: FloatArray) -> FloatArray:
    """Unit normals (n, 3) of the skin nearest to some places."""
    _, element, _ = igl.point_mesh_squared_distance(np.ascontiguousarray(places), skin.positions, skin.triangles)
    normal = skin.normals[skin.triangles[element]].mean(axis=1)
    return np.asarray(normal / np.linalg.norm(normal, axis=1, keepdims=True))
