"""One muscle as it lies under the resting skin, ready to be drawn and to go along with the skin."""

from __future__ import annotations

import atexit
from dataclasses import dataclass
from functools import lru_cache

import igl
import numpy as np

from facemodel.display import DisplaySurface
from facemodel.mesh import Mesh
from facemodel.muscles import Muscle
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.overlays.bands import Band, band
from ui.viewport.overlays.lens import ROWS
from ui.viewport.overlays.muscle_colours import colour_of

TENDON = (0.80, 0.74, 0.68)

TENDON_SHARE = 0.14
"""Share of the way from the bone over which a muscle is tendon."""


@dataclass(frozen=True, eq=False)
class LaidMuscle:
    """The body of a muscle.

    Attributes
    ----------
    points, normals, colours : (n, 3)
    triangles : (t, 3)
    grain : (n, 2) millimetres along and across its fibres
    share : (n,) how far each point goes with the skin
    anchors, pulls : (n, 3) the drawn points of the skin that it goes with, and how far with each of them
    """

    points: FloatArray
    normals: Float32Array
    colours: FloatArray
    triangles: IntArray
    grain: FloatArray
    share: FloatArray
    anchors: IntArray
    pulls: FloatArray


@lru_cache(maxsize=256)
def laid_muscle(muscle: Muscle, skin: Mesh, bones: tuple[Mesh, Mesh], display: DisplaySurface) -> LaidMuscle:
    """A muscle under a skin and over bones; remembered, so that of many only the one that changed is laid anew."""
    shape = band(muscle, skin, bones)
    points = shape.points.reshape(-1, 3)
    share = np.tile(shape.along**2, shape.points.shape[0])
    anchors, shares = _nearest(points, display)
    return LaidMuscle(
        points,
        _outward(Mesh(points, shape.triangles).normals, display.normals[anchors[:, 0]]).astype(np.float32),
        _colours(shape, colour_of(muscle)),
        shape.triangles,
        shape.grain.reshape(-1, 2),
        share,
        anchors,
        share[:, None] * shares,
    )


def _colours(shape: Band, own: tuple[float, float, float]) -> FloatArray:
    """Colours (n, 3) of a body, paler towards the tendon."""
    rows, columns = shape.points.shape[:2]
    pale = 0.7 * np.clip(1 - shape.along / TENDON_SHARE, 0, 1) ** 2
    colour = np.array(own) + (np.array(TENDON) - np.array(own)) * pale[:, None]
    return np.asarray(np.broadcast_to(colour, (rows, columns, 3)).reshape(-1, 3))


def _nearest(places: FloatArray, display: DisplaySurface) -> tuple[IntArray, FloatArray]:
    """The corners (n, 3) of the drawn triangle nearest to each place, and its shares (n, 3) of them."""
    tree, points = _tree(display)
    _, element, nearest = tree.squared_distance(points, display.triangles, np.ascontiguousarray(places))
    corners = display.triangles[np.reshape(element, -1)]
    shares = igl.barycentric_coordinates(
        np.reshape(nearest, (-1, 3)), *(np.ascontiguousarray(points[corners[:, k]]) for k in range(3))
    )
    return corners, np.nan_to_num(shares, nan=1 / 3)


@lru_cache(maxsize=2)
def _tree(display: DisplaySurface) -> tuple[igl.AABB, FloatArray]:
    """What finds the nearest places of the drawn skin at rest, and its points."""
    points = np.ascontiguousarray(display.points, dtype=np.float64)
    tree = igl.AABB()
    tree.init(points, display.triangles)
    return tree, points


# What igl made goes before the interpreter does, which would call it leaked.
atexit.register(_tree.cache_clear)


def _outward(normals: FloatArray, towards: Float32Array) -> FloatArray:
    """Normals (n, 3) of a body, turned so that those of its outer side face as the skin beside them does."""
    outer = slice(0, ROWS * (len(normals) // (2 * ROWS - 2)))
    side = np.einsum("nc,nc->", normals[outer], towards[outer])
    return np.asarray(normals if side >= 0 else -normals)
