"""Meshes of the tests: a plate, and an irregular surface with a hole, flat or curved."""

import numpy as np
from scipy.spatial import Delaunay

from fem import ChartedSurface, Support, Supports
from fem.types import BoolArray, FloatArray, IntArray


def plate(segments: int) -> ChartedSurface:
    """Unit square of segments x segments x 2 triangles with alternating diagonals."""
    ticks = np.linspace(0.0, 1.0, segments + 1)
    x, y = np.meshgrid(ticks, ticks)
    points = np.stack([x.ravel(), y.ravel()], axis=1)
    row, column = np.divmod(np.arange(segments**2), segments)
    lower = row * (segments + 1) + column
    upper = lower + segments + 1
    rising = np.stack([lower, lower + 1, upper + 1, lower, upper + 1, upper], axis=1)
    falling = np.stack([lower, lower + 1, upper, lower + 1, upper + 1, upper], axis=1)
    even = ((row + column) % 2 == 0)[:, None]
    return ChartedSurface(flat(points), np.where(even, rising, falling).reshape(-1, 3), points)


def irregular(count: int = 80, seed: int = 7) -> ChartedSurface:
    """Delaunay mesh of the square [-1, 1]^2 with a hole in the middle, in random vertex order."""
    rng = np.random.default_rng(seed)
    turn = np.linspace(0.0, 2.0 * np.pi, 9)[:-1]
    ring = 0.3 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    side = np.linspace(-1.0, 1.0, 7)
    frame = np.array([(x, y) for x in side for y in side if max(abs(x), abs(y)) == 1.0])
    inner = rng.uniform(-0.9, 0.9, (4 * count, 2))
    inner = _spread(inner[np.hypot(*inner.T) > 0.42], 1.0 / np.sqrt(count))
    points = rng.permutation(np.concatenate([ring, frame, inner]))
    triangles = Delaunay(points).simplices.astype(np.int64)
    centre = points[triangles].mean(axis=1)
    triangles = triangles[np.hypot(*centre.T) > 0.29]
    corners = points[triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    triangles = np.where((area < 0.0)[:, None], triangles[:, ::-1], triangles)
    return ChartedSurface(flat(points), triangles, points)


def _spread(points: FloatArray, distance: float) -> FloatArray:
    kept: list[FloatArray] = []
    for point in points:
        if all(np.hypot(*(point - other)) > distance for other in kept):
            kept.append(point)
    return np.array(kept)


def flat(points: FloatArray) -> FloatArray:
    return np.pad(points, ((0, 0), (0, 1)))


def domed(surface: ChartedSurface) -> ChartedSurface:
    """The same triangles and chart over a saddle-like dome."""
    x, y = surface.chart.T
    return ChartedSurface(
        np.stack([x, y, 0.8 * (x - 0.5) ** 2 + 0.6 * (y - 0.4) ** 2], axis=1), surface.triangles, surface.chart
    )


def bent_chart(points: FloatArray) -> FloatArray:
    """A smooth bijection of the unit square that is far from affine."""
    x, y = points.T
    return np.stack(
        [x + 0.175 * (x**2 + x * y), y + 0.35 * (0.3 * y**2 - 0.4 * x**2 + 0.3 * np.sin(2.0 * x) * y)], axis=1
    )


def on_boundary(surface: ChartedSurface) -> BoolArray:
    marked = np.zeros(surface.n_vertices, dtype=np.bool_)
    marked[surface.edges[surface.boundary_edges]] = True
    return marked


def boundary_supports(surface: ChartedSurface, kind: Support) -> Supports:
    return Supports(np.where(on_boundary(surface), kind, Support.FREE))


def points_inside(surface: ChartedSurface, per_triangle: int = 3, seed: int = 1) -> tuple[IntArray, FloatArray]:
    """Random points in every triangle: their triangles and barycentric coordinates."""
    elements = np.repeat(np.arange(surface.n_triangles), per_triangle)
    return elements, np.random.default_rng(seed).dirichlet([1.0, 1.0, 1.0], len(elements))


def chart_points(surface: ChartedSurface, elements: IntArray, barycentric: FloatArray) -> FloatArray:
    return np.einsum("pk,pkc->pc", barycentric, surface.chart[surface.triangles[elements]])
