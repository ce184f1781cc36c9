"""What lies under a point of the screen: the triangle of the posed skin that a ray through it meets first."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from facemodel.display import DisplaySurface
from facemodel.face import Face
from fem.types import Float32Array, FloatArray, IntArray

EDGE = 1e-6
"""Slack of barycentric coordinates, so that a ray through an edge meets one of its triangles."""


@dataclass(frozen=True, eq=False)
class Hit:
    """A place on the posed skin.

    Attributes
    ----------
    triangle : of the drawn skin
    barycentric : (3,) where in it
    place : (3,) millimetres
    point : the nearest corner of the triangle, a drawn point
    """

    triangle: int
    barycentric: FloatArray
    place: FloatArray
    point: int


def ray_through(renderer: vtkRenderer, x: float, y: float) -> tuple[FloatArray, FloatArray]:
    """Origin and unit direction of the ray through a point of the picture (pixels, from the lower left)."""
    ends = []
    for depth in (0.0, 1.0):
        renderer.SetDisplayPoint(x, y, depth)
        renderer.DisplayToWorld()
        world = np.array(renderer.GetWorldPoint())
        ends.append(world[:3] / world[3])
    along = ends[1] - ends[0]
    return ends[0], along / np.linalg.norm(along)


def first_hit(points: Float32Array, triangles: IntArray, origin: FloatArray, along: FloatArray) -> Hit | None:
    """The first triangle that a ray meets from outside (Möller and Trumbore 1997, all triangles at once)."""
    a, b, c = (points[triangles[:, k]].astype(np.float64) for k in range(3))
    ab, ac, from_a = b - a, c - a, origin - a
    p = np.cross(along, ac)
    det = np.einsum("ij,ij->i", ab, p)
    facing = det > 1e-12
    scale = 1 / np.where(facing, det, 1.0)
    u = np.einsum("ij,ij->i", from_a, p) * scale
    q = np.cross(from_a, ab)
    v = q @ along * scale
    distance = np.einsum("ij,ij->i", ac, q) * scale
    met = facing & (u >= -EDGE) & (v >= -EDGE) & (u + v <= 1 + EDGE) & (distance > 0)
    if not met.any():
        return None
    triangle = int(np.where(met, distance, np.inf).argmin())
    share = np.array([1 - u[triangle] - v[triangle], u[triangle], v[triangle]])
    place = share @ points[triangles[triangle]].astype(np.float64)
    return Hit(triangle, share, place, int(triangles[triangle, share.argmax()]))


def skin_vertex(face: Face, display: DisplaySurface, hit: Hit) -> int:
    """The skin vertex nearest to a hit, within the element it lies on."""
    element = display.elements[hit.point]
    return int(face.skin.triangles[element, display.barycentric[hit.point].argmax()])
