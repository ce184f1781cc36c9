"""A triangulated surface in space together with its chart: the domain on which the elements live."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fem.errors import FemError
from fem.types import BoolArray, FloatArray, IntArray

# A triangle counts as degenerate when its area is below this share of its longest edge squared. Slopes lose about the
# square of that share in accuracy: at ten times this share they are right to a thousandth, below it they are noise.
DEGENERATE_SHARE = 1e-5
NAMED_TRIANGLES = 5


@dataclass(frozen=True, eq=False)
class ChartedSurface:
    """A manifold triangle mesh, holes allowed, with a bijective chart (u, v).

    Parameters
    ----------
    positions
        (N, 3) vertex positions in millimetres.
    triangles
        (T, 3) vertex indices, counter-clockwise in the chart. Every vertex is used by a triangle.
    chart
        (N, 2) chart coordinates (u, v), in any unit.

    Raises
    ------
    FemError
        If the arrays do not fit together, a triangle is flipped or degenerate in the chart, a triangle has no
        area in space, an edge has more than two triangles, or a vertex belongs to no triangle.
    """

    positions: FloatArray
    triangles: IntArray
    chart: FloatArray

    def __post_init__(self) -> None:
        object.__setattr__(self, "positions", _frozen_floats(self.positions, 3, "positions"))
        object.__setattr__(self, "chart", _frozen_floats(self.chart, 2, "chart"))
        triangles = np.array(self.triangles, dtype=np.int64, order="C")
        triangles.setflags(write=False)
        object.__setattr__(self, "triangles", triangles)
        self._check_indices()
        self._check_shapes_of_triangles()
        self._check_edges()

    def _check_indices(self) -> None:
        count = len(self.positions)
        if len(self.chart) != count:
            raise FemError(f"The chart has {len(self.chart)} points but the surface has {count} vertices.")
        if self.triangles.ndim != 2 or self.triangles.shape[1] != 3 or len(self.triangles) == 0:
            raise FemError(f"Triangles must be a non-empty (T, 3) array, not {self.triangles.shape}.")
        if self.triangles.min() < 0 or self.triangles.max() >= count:
            raise FemError(f"A triangle names a vertex outside 0..{count - 1}.")
        unused = np.flatnonzero(np.bincount(self.triangles.ravel(), minlength=count) == 0)
        if len(unused):
            raise FemError(
                f"{len(unused)} vertices belong to no triangle (first: {unused[:NAMED_TRIANGLES].tolist()}); "
                "remove them before solving."
            )

    def _check_shapes_of_triangles(self) -> None:
        uv = self.chart[self.triangles]
        limit = DEGENERATE_SHARE * _longest_edge_squared(uv)
        bad = np.flatnonzero(~(self.chart_areas > limit))
        if len(bad):
            raise FemError(
                f"{len(bad)} of {len(self.triangles)} triangles are flipped or degenerate in the chart "
                f"(first: {bad[:NAMED_TRIANGLES].tolist()}); "
                "it must be bijective and counter-clockwise."
            )
        limit = DEGENERATE_SHARE * _longest_edge_squared(self.positions[self.triangles])
        bad = np.flatnonzero(~(self.areas > limit))
        if len(bad):
            raise FemError(
                f"{len(bad)} of {len(self.triangles)} triangles have no area in space "
                f"(first: {bad[:NAMED_TRIANGLES].tolist()}); repair the mesh before solving."
            )

    def _check_edges(self) -> None:
        users = np.bincount(self.triangle_edges.ravel(), minlength=len(self.edges))
        bad = np.flatnonzero(users > 2)
        if len(bad):
            raise FemError(
                f"{len(bad)} edges have more than two triangles (first: {self.edges[bad[0]].tolist()}); "
                "the surface must be manifold."
            )

    @property
    def n_vertices(self) -> int:
        """Number of vertices N."""
        return len(self.positions)

    @property
    def n_triangles(self) -> int:
        """Number of triangles T."""
        return len(self.triangles)

    @cached_property
    def _edge_topology(self) -> tuple[IntArray, IntArray]:
        return edge_topology(self.triangles)

    @property
    def edges(self) -> IntArray:
        """(E, 2) vertex pairs, each with the lower index first, sorted."""
        return self._edge_topology[0]

    @property
    def triangle_edges(self) -> IntArray:
        """(T, 3) edges of each triangle; edge k lies opposite corner k."""
        return self._edge_topology[1]

    @cached_property
    def is_boundary_edge(self) -> BoolArray:
        """(E,) True where an edge has one triangle only."""
        users = np.bincount(self.triangle_edges.ravel(), minlength=len(self.edges))
        return np.asarray(users == 1)

    @property
    def boundary_edges(self) -> IntArray:
        """(B,) indices of the edges with one triangle only."""
        return np.flatnonzero(self.is_boundary_edge)

    @cached_property
    def edge_normals(self) -> FloatArray:
        """(E, 2) unit normals in the chart: to the right when walking from the lower to the higher vertex."""
        along = self.chart[self.edges[:, 1]] - self.chart[self.edges[:, 0]]
        normal = np.stack([along[:, 1], -along[:, 0]], axis=1)
        return np.asarray(normal / np.linalg.norm(normal, axis=1, keepdims=True))

    @cached_property
    def chart_areas(self) -> FloatArray:
        """(T,) signed areas in the chart."""
        uv = self.chart[self.triangles]
        first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
        return np.asarray(0.5 * (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]))

    @cached_property
    def chart_gradients(self) -> FloatArray:
        """(T, 3, 2) gradients d/d(u, v) of the barycentric coordinates."""
        uv = self.chart[self.triangles]
        opposite = np.roll(uv, -2, axis=1) - np.roll(uv, -1, axis=1)
        turned = np.stack([-opposite[..., 1], opposite[..., 0]], axis=-1)
        return np.asarray(turned / (2.0 * self.chart_areas)[:, None, None])

    @cached_property
    def _normals_times_twice_area(self) -> FloatArray:
        xyz = self.positions[self.triangles]
        return np.cross(xyz[:, 1] - xyz[:, 0], xyz[:, 2] - xyz[:, 0])

    @cached_property
    def areas(self) -> FloatArray:
        """(T,) true areas in square millimetres."""
        return np.asarray(0.5 * np.linalg.norm(self._normals_times_twice_area, axis=1))

    @cached_property
    def normals(self) -> FloatArray:
        """(T, 3) unit normals of the triangles."""
        return np.asarray(self._normals_times_twice_area / (2.0 * self.areas)[:, None])

    @cached_property
    def frames(self) -> FloatArray:
        """(T, 2, 3) frame of each triangle's plane: orthonormal s, along its first edge, and t."""
        first = self.positions[self.triangles[:, 1]] - self.positions[self.triangles[:, 0]]
        s = first / np.linalg.norm(first, axis=1, keepdims=True)
        return np.stack([s, np.cross(self.normals, s)], axis=1)

    @cached_property
    def jacobians(self) -> FloatArray:
        """(T, 2, 2) J = d(u, v)/d(s, t): row for u and v, column for s and t."""
        xyz = self.positions[self.triangles]
        edges_st = np.einsum("tek,tfk->tfe", xyz[:, 1:] - xyz[:, :1], self.frames)
        uv = self.chart[self.triangles]
        edges_uv = np.swapaxes(uv[:, 1:] - uv[:, :1], 1, 2)
        return np.asarray(edges_uv @ np.linalg.inv(edges_st))


def _frozen_floats(values: FloatArray, width: int, name: str) -> FloatArray:
    array = np.array(values, dtype=np.float64, order="C")
    if array.ndim != 2 or array.shape[1] != width:
        raise FemError(f"The {name} must be an (N, {width}) array, not {array.shape}.")
    bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if len(bad):
        raise FemError(f"The {name} of vertex {bad[0]} are not finite numbers.")
    array.setflags(write=False)
    return array


def _longest_edge_squared(corners: FloatArray) -> FloatArray:
    edges = np.roll(corners, -1, axis=1) - corners
    return np.asarray((edges**2).sum(axis=2).max(axis=1))


def edge_topology(triangles: IntArray) -> tuple[IntArray, IntArray]:
    """Find the edges of a triangulation.

    Parameters
    ----------
    triangles
        (T, 3) vertex indices.

    Returns ------- (E, 2) edges, each with the lower index first, sorted; and (T, 3) edges of each triangle,
    edge k opposite corner k.
    """
    pairs = np.sort(triangles[:, [[1, 2], [2, 0], [0, 1]]].reshape(-1, 2), axis=1)
    base = int(triangles.max()) + 1
    keys, users = np.unique(pairs[:, 0] * base + pairs[:, 1], return_inverse=True)
    edges = np.stack([keys // base, keys % base], axis=1)
    return edges, users.reshape(-1, 3).astype(np.int64)
