"""Regions of the skin as (N,) truth values: lasso, flood, ball, grown and shrunk; and filling them with a value."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from facemodel.errors import PaintError
from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.painting.brush import Brush, check_mode, painted
from facemodel.painting.delta import LayerDelta
from facemodel.painting.geodesic import Geodesics, SurfacePoint
from facemodel.painting.layers import PaintLayer
from facemodel.painting.smoothing import smoothed
from facemodel.painting.surface import PaintSurface
from fem.types import BoolArray, FloatArray

LEAST_CORNERS = 3
"""A lasso with fewer corners encloses nothing."""


def lasso(polygon: FloatArray, screen: FloatArray, visible: BoolArray) -> BoolArray:
    """Visible vertices inside a polygon on the screen, by the even-odd rule.

    Parameters
    ----------
    polygon : (P, 2) its corners in order, closed by itself
    screen : (N, 2) where the vertices are on the screen, in the same unit
    visible : (N,) those that the viewer sees; see `unhidden`
    """
    inside = np.zeros(len(screen), dtype=np.bool_)
    if len(polygon) < LEAST_CORNERS:
        return inside
    low, high = polygon.min(axis=0), polygon.max(axis=0)
    near = np.flatnonzero(visible & ((screen >= low) & (screen <= high)).all(axis=1))
    x, y = screen[near, 0, None], screen[near, 1, None]
    (x0, y0), (x1, y1) = polygon.T, np.roll(polygon, -1, axis=0).T
    crosses = (y0 > y) != (y1 > y)
    rise = np.where(y1 == y0, 1.0, y1 - y0)
    right_of = x < x0 + (y - y0) / rise * (x1 - x0)
    inside[near] = (crosses & right_of).sum(axis=1) % 2 == 1
    return inside


def unhidden(screen: FloatArray, depth: FloatArray, drawn: FloatArray, slack: float) -> BoolArray:
    """Vertices (N,) with nothing drawn before them.

    Parameters
    ----------
    screen : (N, 2) pixels from the left and from the top
    depth : (N,) distance from the viewer
    drawn : (H, W) distance of what is drawn at every pixel, infinite where there is nothing
    slack : by how much a vertex may lie behind what is drawn there and still be seen
    """
    height, width = drawn.shape
    column, row = np.floor(screen).astype(np.int64).T
    on_screen = (column >= 0) & (column < width) & (row >= 0) & (row < height)
    before = drawn[np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)]
    return np.asarray(on_screen & (depth <= before + slack))


def flood(mesh: Mesh, values: FloatArray, seed: int, tolerance: float, period: float | None = None) -> BoolArray:
    """Vertices connected with a seed over vertices whose values differ from its own by at most a tolerance.

    Parameters
    ----------
    mesh : the skin
    values : (N,) of a layer
    seed : a vertex
    tolerance : in the layer's unit
    period : after which values come round again; 180 for angles
    """
    away = np.abs(values - values[seed])
    if period is not None:
        away = np.minimum(away % period, period - away % period)
    return _connected(mesh, away <= tolerance, seed)


def connected_part(mesh: Mesh, seed: int) -> BoolArray:
    """All vertices connected with a seed."""
    return _connected(mesh, np.ones(len(mesh.positions), dtype=np.bool_), seed)


def _connected(mesh: Mesh, allowed: BoolArray, seed: int) -> BoolArray:
    i, j = mesh.edges[allowed[mesh.edges].all(axis=1)].T
    count = len(mesh.positions)
    graph = coo_array((np.ones(len(i), dtype=np.int8), (i, j)), shape=(count, count))
    part = connected_components(graph, directed=False)[1]
    return np.asarray(part == part[seed])


def ball(geodesics: Geodesics, point: SurfacePoint, radius: float) -> BoolArray:
    """Vertices within a geodesic radius in millimetres."""
    inside = np.zeros(len(geodesics.mesh.positions), dtype=np.bool_)
    inside[geodesics.within(point, radius).vertices] = True
    return inside


def grown(mesh: Mesh, region: BoolArray, rings: int = 1) -> BoolArray:
    """The region with so many rings of neighbours around it."""
    for _ in range(rings):
        region = region | (mesh.adjacency @ region.astype(np.float64) > 0)
    return region


def shrunk(mesh: Mesh, region: BoolArray, rings: int = 1) -> BoolArray:
    """The region without so many rings along its border; the rim of the skin is no border."""
    return ~grown(mesh, ~region, rings)


def filled(surface: PaintSurface, face: Face, layer: PaintLayer, brush: Brush, region: BoolArray) -> LayerDelta:
    """Do to a whole region what the brush does in its middle; its radius and hardness do not count.

    Raises
    ------
    PaintError
        If the layer does not know the brush's mode, or combing is asked for, which needs a way.
    """
    check_mode(layer, brush.mode)
    if brush.mode == "comb":
        raise PaintError("A region cannot be combed as a whole; set its angle, or comb it with the brush.")
    vertices = np.flatnonzero(region)
    values = layer.values(face)
    target = np.full(len(values), brush.value)
    if brush.mode == "smooth":
        target = smoothed(layer.kind, values, surface.smoothing)
    elif brush.mode == "erase":
        target = layer.unpainted(face)
    weights = np.full(len(vertices), brush.strength)
    after = painted(layer.kind, brush.mode, values[vertices], weights, target[vertices])
    return layer.delta(face, vertices, after)
