"""The path of a brush between two places on the skin, and how far vertices lie from it."""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np

from facemodel.mesh import Mesh
from facemodel.painting.geodesic import Geodesics, SurfacePoint
from fem.types import FloatArray, IntArray

STRIDE = 0.5
"""Largest step of a sweep in radii of the brush: over such a distance skin is flat enough for the distance from a
straight piece of path."""


class SkinPath:
    """Walks on a mesh.

    Parameters
    ----------
    mesh : the skin
    """

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh
        self._tree = igl.AABB()
        self._tree.init(mesh.positions, mesh.triangles)

    def nearest(self, positions: FloatArray) -> list[SurfacePoint]:
        """The points of the skin nearest to positions (k, 3)."""
        mesh = self.mesh
        _, triangles, found = self._tree.squared_distance(mesh.positions, mesh.triangles, np.atleast_2d(positions))
        corners = [np.ascontiguousarray(mesh.positions[mesh.triangles[triangles, k]]) for k in range(3)]
        shares = np.clip(igl.barycentric_coordinates(found, *corners), 0.0, 1.0)
        shares /= shares.sum(axis=1, keepdims=True)
        return [SurfacePoint(int(t), share) for t, share in zip(triangles, shares, strict=True)]

    def between(self, start: SurfacePoint, end: SurfacePoint, stride: float) -> list[SurfacePoint]:
        """The way from one point to another in steps of at most ``stride`` millimetres, without the first.

        The straight way through space, put onto the skin: however far apart two places of a hasty mouse lie, the stroke
        between them has no gap.
        """
        a, b = start.position(self.mesh), end.position(self.mesh)
        steps = int(np.ceil(np.linalg.norm(b - a) / stride))
        if steps <= 1:
            return [end]
        share = np.linspace(0, 1, steps + 1)[1:-1, None]
        return [*self.nearest((1 - share) * a + share * b), end]


@dataclass(frozen=True, eq=False)
class Reached:
    """Vertices near a piece of path.

    Attributes
    ----------
    vertices : (k,) skin vertices
    distances : (k,) from the piece, millimetres
    """

    vertices: IntArray
    distances: FloatArray


class Tip:
    """A brush's tip at one point of the skin: how far the vertices around it are."""

    def __init__(self, geodesics: Geodesics, point: SurfacePoint, radius: float) -> None:
        self.point = point
        self.position = point.position(geodesics.mesh)
        self.radius = radius
        # Beside a piece of path lie vertices that are farther than the radius from both of its ends.
        ball = geodesics.within(point, radius * float(np.hypot(1.0, STRIDE)))
        self.distances: FloatArray = np.full(len(geodesics.mesh.positions), np.inf)
        self.distances[ball.vertices] = ball.distances

    def reached(self) -> Reached:
        """Vertices within the radius of the tip alone."""
        vertices = np.flatnonzero(self.distances <= self.radius)
        return Reached(vertices, self.distances[vertices])


def swept(one: Tip, other: Tip) -> Reached:
    """Vertices within the radius of the piece of path between two tips, at most a stride apart.

    Their distances from both ends give their place in the plane, and with it the distance from the piece: a capsule
    instead of two dabs, so that the stroke does not bulge at its tips.
    """
    near = np.flatnonzero(np.minimum(one.distances, other.distances) < np.inf)
    a, b = one.distances[near], other.distances[near]
    length = float(np.linalg.norm(other.position - one.position))
    distances = np.minimum(a, b)
    if length > 0:
        both = np.flatnonzero(np.maximum(a, b) < np.inf)
        along = (a[both] ** 2 - b[both] ** 2 + length**2) / (2 * length)
        beside = np.flatnonzero((along > 0) & (along < length))
        off = np.sqrt(np.maximum(a[both[beside]] ** 2 - along[beside] ** 2, 0.0))
        distances[both[beside]] = off
    inside = distances <= one.radius
    return Reached(near[inside], distances[inside])
