"""Topology, frames and Jacobians of a charted surface, and what it refuses."""

import numpy as np
import pytest

from fem import HCT12, Assembler, ChartedSurface, FemError, interpolate_smoothly
from tests.fem.meshes import domed, flat, irregular, plate


def test_edges_obey_euler_for_a_ring() -> None:
    surface = irregular()
    assert surface.n_vertices - len(surface.edges) + surface.n_triangles == 0
    assert np.all(surface.edges[:, 0] < surface.edges[:, 1])


def test_edge_k_lies_opposite_corner_k() -> None:
    surface = irregular()
    ends = surface.edges[surface.triangle_edges]
    for corner in range(3):
        others = np.sort(surface.triangles[:, [(corner + 1) % 3, (corner + 2) % 3]], axis=1)
        assert np.array_equal(ends[:, corner], others)


def test_boundary_edges_form_two_closed_loops() -> None:
    surface = irregular()
    used = np.bincount(surface.edges[surface.boundary_edges].ravel(), minlength=surface.n_vertices)
    assert set(used) == {0, 2}
    assert len(surface.boundary_edges) == 8 + 24


def test_frames_are_orthonormal_and_lie_in_the_triangle() -> None:
    surface = domed(irregular())
    gram = surface.frames @ np.swapaxes(surface.frames, 1, 2)
    assert gram == pytest.approx(np.broadcast_to(np.eye(2), gram.shape), abs=1e-13)
    edges = np.diff(surface.positions[surface.triangles], axis=1)
    inside = np.einsum("tec,tfc->tef", edges, surface.frames)
    assert (inside**2).sum() == pytest.approx((edges**2).sum())


def test_jacobian_carries_edges_from_the_plane_to_the_chart() -> None:
    surface = domed(irregular())
    edges = np.roll(surface.positions[surface.triangles], -1, axis=1) - surface.positions[surface.triangles]
    in_plane = np.einsum("tec,tfc->tef", edges, surface.frames)
    in_chart = np.roll(surface.chart[surface.triangles], -1, axis=1) - surface.chart[surface.triangles]
    assert np.einsum("tij,tej->tei", surface.jacobians, in_plane) == pytest.approx(in_chart, abs=1e-13)


def test_area_of_a_tilted_plate() -> None:
    surface = plate(4)
    tilted = surface.chart @ np.array([[3.0, 0.0, 0.0], [0.0, 1.0, 2.0]])
    areas = ChartedSurface(tilted, surface.triangles, surface.chart).areas
    assert areas.sum() == pytest.approx(3.0 * np.sqrt(5.0))


def test_flipped_triangles_are_named() -> None:
    surface = plate(2)
    chart = surface.chart.copy()
    chart[4] = [1.4, 0.5]
    with pytest.raises(FemError, match=r"flipped or degenerate in the chart \(first: \[") as caught:
        ChartedSurface(surface.positions, surface.triangles, chart)
    turned = ChartedSurface(surface.positions, surface.triangles, surface.chart)
    corners = chart[turned.triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    bad = np.flatnonzero(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0] <= 0.0)
    assert str(bad[:5].tolist()) in str(caught.value)


def test_a_triangle_is_refused_before_its_slopes_are_noise() -> None:
    def with_height(height: float) -> ChartedSurface:
        chart = np.array([[0.0, 0.0], [1.0, 0.0], [0.5, -0.8], [0.5, height]])
        return ChartedSurface(flat(chart), np.array([[0, 1, 3], [1, 0, 2]]), chart)

    surface = with_height(1e-4)
    assembler = Assembler(surface, HCT12)
    found = interpolate_smoothly(assembler, surface.chart @ np.array([[1.0], [2.0]]))
    assert found[assembler.dofs.value_dofs + 1, 0] == pytest.approx(1.0, abs=1e-3)
    with pytest.raises(FemError, match="degenerate"):
        with_height(1e-5)


def test_a_sliver_without_area_in_space_is_refused() -> None:
    surface = plate(1)
    positions = np.zeros((4, 3))
    positions[:, 0] = [0.0, 1.0, 0.3, 0.7]
    with pytest.raises(FemError, match="no area in space"):
        ChartedSurface(positions, surface.triangles, surface.chart)


def test_three_triangles_at_one_edge_are_refused() -> None:
    chart = np.array([[0.0, 0.0], [1.0, 0.0], [0.5, 1.0], [0.5, 2.0], [0.5, 3.0]])
    with pytest.raises(FemError, match="manifold"):
        ChartedSurface(flat(chart), np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]]), chart)


@pytest.mark.parametrize(
    ("positions", "triangles", "message"),
    [
        (np.zeros((5, 3)), [[0, 1, 2]], "5 vertices"),
        (np.zeros((4, 2)), [[0, 1, 2]], r"\(N, 3\)"),
        (np.full((4, 3), np.nan), [[0, 1, 2]], "finite"),
        (np.zeros((4, 3)), [[0, 1, 4]], "outside"),
        (np.zeros((4, 3)), [[0, 1, 2]], r"belong to no triangle \(first: \[3\]\)"),
    ],
)
def test_arrays_that_do_not_fit_are_refused(positions: np.ndarray, triangles: list[list[int]], message: str) -> None:
    with pytest.raises(FemError, match=message):
        ChartedSurface(positions, np.array(triangles), plate(1).chart)


def test_the_surface_keeps_its_own_copy() -> None:
    points = plate(2).positions.copy()
    surface = ChartedSurface(points, plate(2).triangles, plate(2).chart)
    points[0] = 9.0
    assert surface.positions[0] == pytest.approx(0.0)
    with pytest.raises(ValueError, match="read-only"):
        surface.positions[0] = 1.0
